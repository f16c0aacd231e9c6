// Which nodes of a tree matter: as tandem.executive.render.outline says it, for a tree that lives.
import type { NodeStatus, TreeNode } from "./types";
import type { NodeState } from "./state";

export type Row = {
  node: TreeNode;
  depth: number;
  status: NodeStatus;
  kept: NodeStatus;
  message: string;
  open: boolean;
  more: number; // children that may be opened
  inner: TreeNode; // of a chain that is drawn as one row, the innermost
};
export type Looks = {
  nodes: Record<string, NodeState>;
  kept: Record<string, NodeStatus>;
  chosen: Record<string, boolean>; // what the viewer opened or closed
  search: string;
  all: boolean;
  failed: boolean; // the task has failed: open where it did
};

const state = (node: TreeNode, looks: Looks): NodeState => looks.nodes[node.path] ?? [node.status, node.last, node.message];
const runs = (node: TreeNode, looks: Looks): boolean => state(node, looks)[0] === "RUNNING";

// What is drawn below a node: guards stand aside of the work that they may save, and recoveries until they run.
function below(node: TreeNode, looks: Looks): TreeNode[] {
  if (looks.all) return node.children;
  const shown = node.children.filter((child, index) => {
    if (runs(child, looks)) return true;
    if (node.kind === "recovery" && index > 0) return (looks.kept[child.path] ?? "INVALID") !== "INVALID";
    return child.kind !== "condition";
  });
  return shown.length ? shown : node.children;
}

// A chain of nodes with one child each is one row: a phase in it, or else the innermost.
function chain(node: TreeNode, looks: Looks): { shown: TreeNode; inner: TreeNode } {
  let shown = node;
  let inner = node;
  let named = node.type === "Phase";
  for (;;) {
    const next = below(inner, looks);
    if (looks.all || next.length !== 1 || (named && next[0]!.type === "Phase")) return { shown, inner };
    inner = next[0]!;
    if (!named) shown = inner;
    named ||= inner.type === "Phase";
  }
}

function matches(node: TreeNode, words: string, looks: Looks): boolean {
  return `${node.name} ${node.kind} ${state(node, looks)[2]}`.toLowerCase().includes(words);
}

export function rows(root: TreeNode, looks: Looks): Row[] {
  const found: Row[] = [];
  const words = looks.search.trim().toLowerCase();
  const hits = new Set<string>();
  if (words) {
    const mark = (node: TreeNode): boolean => {
      const inside = node.children.map(mark).some(Boolean);
      const hit = inside || matches(node, words, looks);
      if (hit) hits.add(node.path);
      return hit;
    };
    mark(root);
  }
  const within = words ? { ...looks, all: true } : looks;
  const walk = (node: TreeNode, depth: number) => {
    const { shown, inner } = depth ? chain(node, within) : { shown: node, inner: node };
    const children = below(inner, within).filter((child) => !words || hits.has(child.path));
    const [status] = state(node, looks);
    const kept = looks.kept[node.path] ?? "INVALID";
    const busy = status === "RUNNING" || (looks.failed && kept === "FAILURE");
    const phases = !looks.all && hasPhase(inner);
    const open = words ? true : (looks.chosen[shown.path] ?? (depth === 0 || busy || phases || looks.all));
    const said = state(inner, looks)[2] || state(node, looks)[2];
    found.push({ node: shown, inner, depth, status, kept, message: said, open: open && children.length > 0, more: children.length });
    if (open) for (const child of children) walk(child, depth + 1);
  };
  walk(root, 0);
  return found;
}

const known = new WeakMap<TreeNode, boolean>();
function hasPhase(node: TreeNode): boolean {
  let found = known.get(node);
  if (found === undefined) {
    found = node.children.some((child) => child.type === "Phase" || hasPhase(child));
    known.set(node, found);
  }
  return found;
}

export function count(node: TreeNode): number {
  return node.children.reduce((sum, child) => sum + count(child), 1);
}
