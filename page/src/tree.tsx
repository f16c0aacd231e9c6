// A running tree as an outline that opens where it runs or fails.
import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { ask } from "./api";
import { count, rows, type Row } from "./outline";
import { ended, useLive, type Gates, type NodeState } from "./state";
import { act, may } from "./acting";
import type { NodeStatus, TreeSnapshot } from "./types";
import { KIND_SIGNS, KIND_WORDS, SIGNS, STATUS_WORDS } from "./words";
import { type List, useWheel, useZoom, ZoomButtons, zoomKeys } from "./zoom";

export function LiveTree({ failed }: { failed: boolean }) {
  const tree = useLive((live) => live.tree);
  const nodes = useLive((live) => live.nodes);
  const kept = useLive((live) => live.kept);
  const gates = useLive((live) => live.gates);
  if (!tree) return <p class="quiet">No tree yet. It appears with the first task.</p>;
  return (
    <>
      <Breakpoints task={tree.task} gates={gates} />
      <Tree tree={tree} nodes={nodes} kept={kept} gates={gates} failed={failed} at={(path) => <NodeVerbs task={tree.task} node={path} gates={gates} />} />
    </>
  );
}

type Given = {
  tree: TreeSnapshot;
  nodes: Record<string, NodeState>;
  kept: Record<string, NodeStatus>;
  gates: Gates;
  failed: boolean;
  at?: (path: string) => ComponentChildren; // what is offered at the node that is chosen
};

export function Tree({ tree, nodes, kept, gates, failed, at: offers }: Given) {
  const [chosen, choose] = useState<Record<string, boolean>>({});
  const [search, find] = useState("");
  const [all, showAll] = useState(false);
  const [at, move] = useState("");
  const list = useRef<HTMLUListElement>(null);
  const shown = rows(tree.root, { nodes, kept, chosen, search, all, failed });
  const set = gatesByRow(gates, shown.map((row) => row.node.path));
  const total = useMemo(() => count(tree.root), [tree]);
  const zoom = useZoom(list);
  const wheel = useWheel(zoom);
  const [follows, follow] = useFollow(list, shown);
  const flip = (row: Row, open = !row.open) => {
    if (!row.more) return;
    follow(false);
    choose({ ...chosen, [row.node.path]: open });
  };
  const focus = (index: number) => {
    const row = shown[Math.max(0, Math.min(shown.length - 1, index))];
    if (!row) return;
    move(row.node.path);
    const items = list.current?.children ?? [];
    (items[shown.indexOf(row)] as HTMLElement | undefined)?.focus();
  };
  const keys = (event: KeyboardEvent, row: Row, index: number) => {
    if (event.target !== event.currentTarget) return; // a key for one of the row's buttons
    const steps: Record<string, () => void> = {
      ArrowDown: () => focus(index + 1),
      ArrowUp: () => focus(index - 1),
      Home: () => focus(0),
      End: () => focus(shown.length - 1),
      ArrowRight: () => (row.open ? focus(index + 1) : flip(row, true)),
      ArrowLeft: () => (row.open ? flip(row, false) : focus(shown.findLastIndex((each, i) => i < index && each.depth < row.depth))),
      Enter: () => flip(row),
      " ": () => flip(row),
      ...zoomKeys(zoom),
    };
    const step = event.ctrlKey || event.metaKey || event.altKey ? undefined : steps[event.key];
    if (!step) return;
    event.preventDefault();
    step();
  };
  return (
    <div class="tree">
      <div class="bar">
        <input
          type="search" placeholder="Find a node" aria-label="Find a node" value={search}
          onInput={(event) => find(event.currentTarget.value)}
        />
        <label class="check">
          <input type="checkbox" checked={all} onChange={(event) => showAll(event.currentTarget.checked)} /> all {total} nodes
        </label>
        <button class="small" aria-pressed={follows} title="Open the tree where it runs, and scroll there" onClick={() => { choose({}); follow(!follows); }}>Follow</button>
        <ZoomButtons zoom={zoom} />
      </div>
      <ul role="tree" aria-label={`Tree of ${tree.task || tree.kind}`} ref={list} style={{ zoom: String(zoom.percent / 100) }} onWheel={wheel}>
        {shown.map((row, index) => (
          <li
            key={row.node.path} role="treeitem" aria-level={row.depth + 1} aria-expanded={row.more ? row.open : undefined}
            tabIndex={(at || shown[0]?.node.path) === row.node.path ? 0 : -1}
            class={`node ${row.node.kind} ${row.status === "RUNNING" ? "RUNNING" : row.kept} ${row.status === "INVALID" ? "past" : ""}`}
            style={{ "--depth": Math.min(row.depth, 12) }}
            onFocus={() => move(row.node.path)} onClick={() => flip(row)} onKeyDown={(event) => keys(event, row, index)}
            title={about(row)}
          >
            <span class="fold" aria-hidden="true">{row.more ? (row.open ? "▾" : "▸") : ""}</span>
            <Sign status={row.status === "RUNNING" ? "RUNNING" : row.kept} />
            <span class="kind" aria-hidden="true">{KIND_SIGNS[row.inner.kind]}</span>
            <span class="name">{row.node.name}</span>
            {(set[row.node.path] ?? []).map((each) => <span key={each.words} class="gate" title={each.words}>{each.sign}<span class="hidden">{each.words}</span></span>)}
            {row.message && <span class="said">{row.message}</span>}
            {at === row.node.path && offers?.(row.node.path)}
          </li>
        ))}
      </ul>
    </div>
  );
}

// Scrolls to the node that began to run last, until the viewer opens or closes one or ends it.
function useFollow(list: List, shown: Row[]): [boolean, (on: boolean) => void] {
  const [follows, follow] = useState(false);
  const before = useRef<string[]>([]);
  const running = shown.filter((row) => row.status === "RUNNING");
  const leaves = running.filter((row, i) => (running[i + 1]?.depth ?? 0) <= row.depth); // a node runs only while its parent does
  const paths = leaves.map((row) => row.node.path);
  useEffect(() => {
    const fresh = leaves.find((row) => !before.current.includes(row.node.path)) ?? leaves.at(-1);
    before.current = paths;
    if (follows && fresh) list.current?.children[shown.indexOf(fresh)]?.scrollIntoView({ block: "nearest" });
  }, [follows, paths.join("\n")]);
  return [follows, follow];
}

const SIDES = ["before", "after"] as const;

// What was set at nodes, as signs at the row that shows each: of one that is folded, at the nearest above it.
function gatesByRow(gates: Gates, rows: string[]): Record<string, { sign: string; words: string }[]> {
  const shown = new Set(rows);
  const found: Record<string, { sign: string; words: string }[]> = {};
  const put = (path: string, sign: string, words: string) => {
    let row = path;
    while (!shown.has(row) && row.includes("/")) row = row.slice(0, row.lastIndexOf("/"));
    const folded = row === path ? "" : ` ${path.slice(row.length + 1)}`;
    (found[row] ??= []).push({ sign: folded ? `${sign}…` : sign, words: `${words}${folded}` });
  };
  for (const [path, sides] of Object.entries(gates.breakpoints)) for (const side of sides) put(path, side === "before" ? "‖▸" : "▸‖", `pauses ${side}`);
  for (const [path, status] of Object.entries(gates.forced)) put(path, status === "SUCCESS" ? "!✓" : "!✗", status === "SUCCESS" ? "is forced to succeed" : "is forced to fail");
  return found;
}

// All breakpoints, also those of folded nodes and those that somebody else has set, to be taken away.
function Breakpoints({ task, gates }: { task: string; gates: Gates }) {
  const status = useLive((live) => live.tasks[task]);
  const set = Object.entries(gates.breakpoints).flatMap(([node, sides]) => sides.map((when) => ({ node, when })));
  if (!set.length || (status && ended(status))) return null;
  return (
    <ul class="plain breakpoints" aria-label="Breakpoints">
      {set.map(({ node, when }) => (
        <li key={`${node} ${when}`}>
          <span>Pauses {when} <strong title={node}>{node.slice(node.lastIndexOf("/") + 1)}</strong></span>
          {may("breakpoint") && <button class="small" aria-label={`Don't pause ${when} ${node}`} onClick={() => act(() => ask("breakpoint", { task, node, when, on: false }), `It does not pause ${when} this node any more.`)}>✕</button>}
        </li>
      ))}
    </ul>
  );
}

// Breakpoints of a task that has not ended, and how its node is to end in a test run.
function NodeVerbs({ task, node, gates }: { task: string; node: string; gates: Gates }) {
  const status = useLive((live) => live.tasks[task]);
  if (!status || ended(status)) return null;
  const press = (words: string, verb: string, document: Record<string, unknown>) => (event: Event) => {
    event.stopPropagation();
    void act(() => ask(verb, { task, node, ...document }), words);
  };
  const sides = gates.breakpoints[node] ?? [];
  const forced = gates.forced[node];
  return (
    <span class="nodeverbs">
      {may("breakpoint") && <>
        {SIDES.map((when) => {
          const on = !sides.includes(when);
          return <button key={when} class="small" aria-pressed={!on} onClick={press(on ? `It pauses ${when} this node.` : `It does not pause ${when} this node any more.`, "breakpoint", { when, on })}>Pause {when}</button>;
        })}
      </>}
      {may("force") && status.request.test_run === true && <>
        <button class="small" aria-pressed={forced === "SUCCESS"} onClick={press("It will succeed without its work.", "force", { status: "SUCCESS" })}>Force ✓</button>
        <button class="small" aria-pressed={forced === "FAILURE"} onClick={press("It will fail without its work.", "force", { status: "FAILURE" })}>Force ✗</button>
        <button class="small" disabled={!forced} onClick={press("It does its work again.", "force", { status: null })}>Let it run</button>
      </>}
    </span>
  );
}

export function Sign({ status }: { status: string }) {
  return <span class={`sign ${status}`} role="img" aria-label={STATUS_WORDS[status] ?? status}>{SIGNS[status] ?? "·"}</span>;
}

function about(row: Row): string {
  const now = row.status === "RUNNING" ? "runs" : row.kept === "INVALID" ? "has not run" : `${STATUS_WORDS[row.kept]}${row.status === "INVALID" ? ", set back since" : ""}`;
  return `${row.node.path}\n${KIND_WORDS[row.node.kind] ?? row.node.kind} (${row.node.type}); ${now}`;
}
