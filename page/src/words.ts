// Numbers and states as people read them.
import type { Failure, Site, TaskState, TaskStatus } from "./types";
import type { Now } from "./state";

export const SIGNS: Record<string, string> = { INVALID: "·", RUNNING: "▶", SUCCESS: "✓", FAILURE: "✗" };
export const STATUS_WORDS: Record<string, string> = {
  INVALID: "has not run", RUNNING: "runs", SUCCESS: "succeeded", FAILURE: "failed",
};
export const KIND_SIGNS: Record<string, string> = {
  sequence: "→", selector: "?", parallel: "⇉", recovery: "↻", decorator: "δ", condition: "◇", action: "▢",
};
export const KIND_WORDS: Record<string, string> = {
  sequence: "sequence: one after the other", selector: "selector: the first that succeeds", parallel: "parallel",
  recovery: "recovery: tries, repairs, tries again", decorator: "decorator", condition: "guard: only looks", action: "action",
};
export const STATE_SIGNS: Record<TaskState, string> = {
  QUEUED: "◦", RUNNING: "▶", PAUSING: "‖", PAUSED: "‖", CANCELING: "■", SUCCEEDED: "✓", FAILED: "✗", CANCELED: "■",
  EXPIRED: "⌛", REJECTED: "✗", INTERRUPTED: "!",
};

export function seconds(value: number | null | undefined): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value < 60) return `${value.toFixed(value < 9.95 ? 1 : 0)} s`;
  if (value < 3600) return `${Math.floor(value / 60)} min ${Math.floor(value % 60)} s`;
  return `${Math.floor(value / 3600)} h ${Math.floor((value % 3600) / 60)} min`;
}

export const size = (bytes: number) => (bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

// Minutes, seconds and tenths, which do not jump about while they count.
export const clock = (value: number) =>
  `${Math.floor(Math.max(value, 0) / 60)}:${(Math.max(value, 0) % 60).toFixed(1).padStart(4, "0")}`;

export function when(utc: number | string | null): string {
  return utc === null ? "–" : new Date(Number(utc) * 1000).toLocaleString();
}

export function took(status: TaskStatus, now: Now | null): number | null {
  const from = status.started;
  if (!from) return null;
  const to = status.ended ?? (now?.seconds != null ? { boot: now.boot, seconds: now.seconds } : null);
  return to && to.boot === from.boot ? Math.max(0, to.seconds - from.seconds) : null;
}

export function root(failure: Failure): Failure {
  const first = failure.causes?.[0];
  return first ? root(first) : failure;
}

export function summary(request: Record<string, unknown>): string {
  const left = new Set(["task", "id", "by", "on_cancel", "priority", "not_before", "expires", "on_restart", "test_run", "labels", "retry_of"]);
  return Object.entries(request)
    .filter(([name, value]) => !left.has(name) && value !== null && value !== undefined)
    .map(([name, value]) => `${name} ${plain(value)}`)
    .join(", ");
}

// A value without brackets and quotes: of a list of places "x 1.2 y 0.4; x 1.2 y 1.4".
function plain(value: unknown): string {
  if (Array.isArray(value)) return value.map(plain).join(value.some((each) => typeof each === "object") ? "; " : " ");
  if (typeof value === "object" && value !== null) return Object.entries(value).map(([name, each]) => `${name} ${plain(each)}`).join(" ");
  return String(value);
}

export const command = (document: Record<string, unknown>) =>
  `tandem request json '${JSON.stringify(document).replaceAll("'", "'\\''")}'`;

const nameOf = (site: Site | null, item: number) => site?.items.find((each) => each.item === item)?.name;

// An item with its name, if the site gives it one; and short, as it stands beside the thing itself.
export function called(site: Site | null, item: number): string {
  const name = nameOf(site, item);
  return name ? `${item} (${name})` : String(item);
}
export const named = (site: Site | null, item: number): string => nameOf(site, item) || String(item);

// What two failures have in common that differ in numbers alone; as `tandem why` has it.
export const alike = (failure: Failure): string =>
  JSON.stringify([failure.kind, failure.where, failure.message.replace(/-?\d+(\.\d+)?/g, "#"), (failure.causes ?? []).map(alike)]);

// Those that are the same together, where the first of them stands.
export function together<T>(all: Iterable<T>, same: (one: T) => string): [T, ...T[]][] {
  const found = new Map<string, [T, ...T[]]>();
  for (const one of all) {
    const group = found.get(same(one));
    if (group) group.push(one);
    else found.set(same(one), [one]);
  }
  return [...found.values()];
}
