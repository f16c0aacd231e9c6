// All that is known, as one object that is replaced at each change. The server's updates are merged into it.
import { useEffect, useState } from "preact/hooks";
import type {
  ExecutivePulse, NodeStatus, Occupancy, PipelineState, PlanningScene, ReflexState, RobotTime, StopState, TaskStatus, TreeNode, TreeSnapshot,
  WorldState,
} from "./types";

export type Pose = { x: number; y: number; yaw: number; localised: boolean; moving: boolean; reason: string; position_sigma: number };
export type Now = { boot: string; seconds: number | null; silent: number | null };
export type Session = { site: string; robot: string; endpoint: string; who: string; role: string; keys: boolean; login: boolean; may: string[]; pages: Record<string, string> };
export type Tags = { stamp: RobotTime; seen: { item: number; distance: number; tag: { position: [number, number, number]; orientation: [number, number, number, number] } }[] };
export type Replayed = { at: number; speed: number; begin: number; end: number; began: number; cause: { at: number; words: string } | null };
export const RADIUS = 0.27; // m, of a base whose size nobody told: PMB2's, without the margin for arms
export type Other = { at: [number, number, number] | null; task: string; kind: string; phase: string; silent: boolean; size?: [radius: number | null, height: number | null] }; // size in m; older records have none
export type Person = [x: number, y: number, vx: number, vy: number, radius: number]; // m and m/s in the map
export type Occupied = Pick<Occupancy, "origin" | "shape" | "resolution" | "cells">;
export type Gates = Pick<TreeSnapshot, "breakpoints" | "forced">;
export type Reflex = ReflexState & { asks: string }; // what is asked before it is switched off
export type NodeState = [NodeStatus, NodeStatus, string];
export type Live = {
  connected: boolean;
  heardAt: number;
  link: string;
  executive: boolean | null;
  tasks: Record<string, TaskStatus>;
  tree: TreeSnapshot | null;
  nodes: Record<string, NodeState>;
  kept: Record<string, NodeStatus>;
  board: Record<string, string>; // of the tree's task
  gates: Gates; // of the tree's task
  joints: Record<string, number>;
  pose: Pose | null;
  path: [number, number][];
  plan: [number, number][];
  hands: Record<string, [number, number, number][]>; // planned ways of hands, in the base's frame
  tags: Tags | null;
  replay: Replayed | null;
  robots: Record<string, Other>; // the others of the site
  trails: Record<string, [number, number][]>; // the ways they went, while this page looked on
  people: Record<string, Person>; // by number
  lasers: Record<string, number[]>; // what each measured last
  occupied: Occupied | null;
  scene: Omit<PlanningScene, "stamp" | "version" | "occupied"> | null;
  world: Omit<WorldState, "stamp" | "version"> | null;
  stop: StopState | null;
  recording: { recording: boolean; file: string; reason: string } | null;
  pulse: ExecutivePulse | null;
  now: Now | null;
  reflexes: Record<string, Reflex>;
  pipelines: Record<string, Omit<PipelineState, "stamp">>;
};
export type Update = Partial<Omit<Live, "connected" | "heardAt" | "kept" | "path" | "trails">> & { whole?: boolean };

const EMPTY: Live = {
  connected: false, heardAt: 0, link: "", executive: null, tasks: {}, tree: null, nodes: {}, kept: {}, board: {}, gates: { breakpoints: {}, forced: {} }, joints: {},
  pose: null, path: [], plan: [], hands: {}, tags: null, replay: null, robots: {}, trails: {}, people: {}, lasers: {}, occupied: null, scene: null, world: null, stop: null, recording: null, pulse: null, now: null, reflexes: {},
  pipelines: {},
};
const PATH = 2000;
const TASKS = 200;
let live = EMPTY;
const listeners = new Set<() => void>();
let due = 0;

export const current = () => live;

function changed() {
  if (due) return;
  // Once a frame at the most; a tab in the background gets no frames, and still has to be right when it returns.
  due = document.hidden ? setTimeout(tell, 500) : requestAnimationFrame(tell);
}

function tell() {
  due = 0;
  for (const each of [...listeners]) each();
}

export function listen(heard: () => void): () => void {
  listeners.add(heard);
  return () => void listeners.delete(heard);
}

// The part of all that is known which a component shows; it is drawn anew when that part is another object.
export function useLive<T>(pick: (live: Live) => T): T {
  const [, again] = useState(0);
  const picked = pick(live);
  useEffect(() => {
    let shown = picked;
    const check = () => {
      const now = pick(live);
      if (now !== shown) {
        shown = now;
        again((count) => count + 1);
      }
    };
    check();
    return listen(check);
  });
  return picked;
}

export function connected(yes: boolean) {
  live = { ...live, connected: yes };
  changed();
}

export function take(update: Update) {
  // In a replay another moment begins anew; beside a robot it is the same one, told whole once more.
  const same = live.replay === null ? { path: live.path, trails: live.trails, kept: live.kept } : { replay: live.replay };
  live = { ...merged(update.whole ? { ...EMPTY, connected: true, ...same } : live, update), heardAt: performance.now() };
  changed();
}

// What was known at another moment, which an update tells whole.
export const knownThen = (update: Update): Live => merged(EMPTY, update);

function merged(before: Live, update: Update): Live {
  const next: Live = { ...before, ...update };
  for (const part of ["tasks", "joints", "nodes", "reflexes", "pipelines", "robots", "hands", "lasers"] as const) {
    if (update[part]) Object.assign(next, { [part]: { ...before[part], ...update[part] } });
  }
  if (update.tasks) next.tasks = lately(next.tasks);
  if (update.tree) {
    next.nodes = {};
    const same = before.tree?.task === update.tree.task;
    next.kept = keep(same ? before.kept : {}, states(update.tree.root));
  } else if (update.nodes) {
    next.kept = keep(before.kept, Object.entries(update.nodes));
  }
  if (update.pose?.localised) next.path = walked(before.path, update.pose.x, update.pose.y);
  if (update.robots) next.trails = { ...before.trails, ...trailed(before.trails, update.robots) };
  return next;
}

export function* states(node: TreeNode): Generator<[string, NodeState]> {
  yield [node.path, [node.status, node.last, node.message]];
  for (const child of node.children) yield* states(child);
}

// How each node ended last, until it runs again.
function keep(kept: Record<string, NodeStatus>, changes: Iterable<[string, NodeState]>): Record<string, NodeStatus> {
  const next = { ...kept };
  for (const [path, [status, last]] of changes) {
    if (status !== "INVALID") next[path] = status;
    else if (last !== "INVALID") next[path] = last;
    else if (next[path] === "RUNNING") delete next[path];
  }
  return next;
}

// All that have not ended, and the newest of the others, so that a page which stays open for days does not grow.
function lately(tasks: Record<string, TaskStatus>): Record<string, TaskStatus> {
  const over = Object.values(tasks).filter(ended);
  if (over.length <= 2 * TASKS) return tasks;
  const old = new Set(over.sort((a, b) => at(b) - at(a)).slice(TASKS).map((each) => each.task));
  return Object.fromEntries(Object.entries(tasks).filter(([task]) => !old.has(task)));
}

function walked(path: [number, number][], x: number, y: number): [number, number][] {
  const last = path.at(-1);
  return last && Math.hypot(last[0] - x, last[1] - y) < 0.03 ? path : [...path.slice(-PATH + 1), [x, y]];
}

const trailed = (before: Live["trails"], robots: Live["robots"]): Live["trails"] =>
  Object.fromEntries(Object.entries(robots).flatMap(([name, { at }]) => (at ? [[name, walked(before[name] ?? [], at[0], at[1])]] : [])));

export const clearPath = () => {
  live = { ...live, path: [], trails: {} };
  changed();
};

const ENDED = ["SUCCEEDED", "FAILED", "CANCELED", "EXPIRED", "REJECTED", "INTERRUPTED"];
export const ended = (status: TaskStatus) => ENDED.includes(status.state);
export const queued = (tasks: Record<string, TaskStatus>) =>
  Object.values(tasks).filter((each) => each.state === "QUEUED").sort((a, b) => b.priority - a.priority || at(a) - at(b));
export const atWork = (tasks: Record<string, TaskStatus>) =>
  Object.values(tasks).find((each) => !ended(each) && each.state !== "QUEUED");
export const at = (status: TaskStatus) => Number(status.accepted_at);
