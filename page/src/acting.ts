// What the viewer does, with a line that says how it went; and what the viewer's role allows.
import { useEffect, useState } from "preact/hooks";
import { AskError, get, post } from "./api";
import type { Session } from "./state";

export type Notice = { words: string; bad: boolean; count: number };
let session: Session | null = null;
let strange = false; // whether the viewer has to log in
let notice: Notice = { words: "", bad: false, count: 0 };
const heard = new Set<() => void>();
const tell = () => [...heard].forEach((each) => each());

export async function loadSession() {
  try {
    session = await get<Session>("/api/session");
    document.title = `${session.robot} – Tandem`;
  } catch (error) {
    if (!(error instanceof AskError) || error.status !== 401) throw error;
    session = null;
    strange = true;
  }
  tell();
}

// With a word of `tandem keys link`. It is in the address for as long as that takes, and only in this browser.
export async function logIn(word: string) {
  await post("/api/login", { word });
  strange = false;
  await loadSession();
}

export async function logOut() {
  await post("/api/logout", {});
  location.assign("/login");
}

// The session has ended while the page was open.
export function ended() {
  session = null;
  strange = true;
  tell();
}

export const who = () => session;
export const may = (verb: string) => session?.may.includes(verb) ?? false;

export function say(words: string, bad = false) {
  notice = { words, bad, count: notice.count + 1 };
  tell();
}

export async function act(doing: () => Promise<unknown>, words: string): Promise<boolean> {
  try {
    await doing();
    if (words) say(words);
    return true;
  } catch (error) {
    say(error instanceof AskError ? error.message : String(error), true);
    return false;
  }
}

export function useActing(): { session: Session | null; notice: Notice; strange: boolean } {
  const [, again] = useState(0);
  useEffect(() => {
    const hear = () => again((count) => count + 1);
    heard.add(hear);
    hear(); // what came before this was there
    return () => void heard.delete(hear);
  }, []);
  return { session, notice, strange };
}
