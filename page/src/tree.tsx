// A running tree as an outline that opens where it runs or fails.
import { useMemo, useRef, useState } from "preact/hooks";
import { ask } from "./api";
import { count, rows, type Row } from "./outline";
import { useLive, type NodeState } from "./state";
import { act, may } from "./acting";
import type { NodeStatus, TreeSnapshot } from "./types";
import { KIND_SIGNS, KIND_WORDS, SIGNS, STATUS_WORDS } from "./words";

export function LiveTree({ failed }: { failed: boolean }) {
  const tree = useLive((live) => live.tree);
  const nodes = useLive((live) => live.nodes);
  const kept = useLive((live) => live.kept);
  if (!tree) return <p class="quiet">No tree yet. It appears with the first task.</p>;
  return <Tree tree={tree} nodes={nodes} kept={kept} failed={failed} breakpoints />;
}

type Given = {
  tree: TreeSnapshot;
  nodes: Record<string, NodeState>;
  kept: Record<string, NodeStatus>;
  failed: boolean;
  breakpoints?: boolean;
};

export function Tree({ tree, nodes, kept, failed, breakpoints }: Given) {
  const [chosen, choose] = useState<Record<string, boolean>>({});
  const [search, find] = useState("");
  const [all, showAll] = useState(false);
  const [at, move] = useState("");
  const list = useRef<HTMLUListElement>(null);
  const shown = rows(tree.root, { nodes, kept, chosen, search, all, failed });
  const total = useMemo(() => count(tree.root), [tree]);
  const flip = (row: Row, open = !row.open) => row.more && choose({ ...chosen, [row.node.path]: open });
  const focus = (index: number) => {
    const row = shown[Math.max(0, Math.min(shown.length - 1, index))];
    if (!row) return;
    move(row.node.path);
    const items = list.current?.children ?? [];
    (items[shown.indexOf(row)] as HTMLElement | undefined)?.focus();
  };
  const keys = (event: KeyboardEvent, row: Row, index: number) => {
    const steps: Record<string, () => void> = {
      ArrowDown: () => focus(index + 1),
      ArrowUp: () => focus(index - 1),
      Home: () => focus(0),
      End: () => focus(shown.length - 1),
      ArrowRight: () => (row.open ? focus(index + 1) : flip(row, true)),
      ArrowLeft: () => (row.open ? flip(row, false) : focus(shown.findLastIndex((each, i) => i < index && each.depth < row.depth))),
      Enter: () => flip(row),
      " ": () => flip(row),
    };
    const step = steps[event.key];
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
        {Object.keys(chosen).length > 0 && <button onClick={() => choose({})}>Follow</button>}
      </div>
      <ul role="tree" aria-label={`Tree of ${tree.task || tree.kind}`} ref={list}>
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
            {row.message && <span class="said">{row.message}</span>}
            {breakpoints && may("breakpoint") && at === row.node.path && (
              <button class="small" onClick={(event) => { event.stopPropagation(); void act(() => ask("breakpoint", { task: tree.task, node: row.node.path }), "It pauses before this node."); }}>
                Pause here
              </button>
            )}
          </li>
        ))}
      </ul>
    </div>
  );
}

export function Sign({ status }: { status: string }) {
  return <span class={`sign ${status}`} role="img" aria-label={STATUS_WORDS[status] ?? status}>{SIGNS[status] ?? "·"}</span>;
}

function about(row: Row): string {
  const now = row.status === "RUNNING" ? "runs" : row.kept === "INVALID" ? "has not run" : `${STATUS_WORDS[row.kept]}${row.status === "INVALID" ? ", set back since" : ""}`;
  return `${row.node.path}\n${KIND_WORDS[row.node.kind] ?? row.node.kind} (${row.node.type}); ${now}`;
}
