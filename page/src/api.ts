// Questions and verbs over HTTP. Errors carry the server's words, and each problem of a document.
import type { Problem } from "./types";

export class AskError extends Error {
  constructor(message: string, readonly status: number, readonly problems: Problem[] = []) {
    super(message);
  }
}

async function told<T>(answer: Response): Promise<T> {
  const body: unknown = await answer.json().catch(() => ({ error: `${answer.status} ${answer.statusText}` }));
  if (answer.ok) return body as T;
  const { error, problems } = body as { error?: string; problems?: Problem[] };
  throw new AskError(error ?? answer.statusText, answer.status, problems);
}

async function reach(path: string, options?: RequestInit): Promise<Response> {
  try {
    return await fetch(path, options);
  } catch {
    throw new AskError("the page's server does not answer; is `tandem web` running?", 0);
  }
}

export const get = async <T>(path: string): Promise<T> => told<T>(await reach(path));

export const post = async <T>(path: string, document: unknown): Promise<T> =>
  told<T>(
    await reach(path, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(document),
    }),
  );

// A picture and its age in seconds.
export async function picture(path: string): Promise<{ blob: Blob; age: number }> {
  const answer = await reach(path);
  if (!answer.ok) await told(answer);
  return { blob: await answer.blob(), age: Number(answer.headers.get("X-Age") ?? 0) };
}

export const ask = (verb: string, document: unknown = {}) =>
  post<{ answer: unknown }>(`/api/verb/${verb}`, document);
