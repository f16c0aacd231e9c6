// What was known at one moment of a task: its board, what was believed of items, where the robot was, its tree.
import { useEffect, useState } from "preact/hooks";
import { get } from "./api";
import { useSite } from "./loading";
import type { Kept } from "./records";
import { knownThen, states, useLive, type Live, type NodeState, type Update } from "./state";
import { Tree } from "./tree";
import type { NodeStatus, RobotTime, TreeSnapshot, WorldState } from "./types";
import { View3d } from "./view3d";
import { called, seconds as words } from "./words";

type Told = { file: string; stamp: RobotTime | null; shown: Update };
type Beliefs = { items: WorldState["items"]; boot: string | null; now: number | null };

// Times of two boots of the robot can't be compared: `boot` says which one `at` is of.
type Given = { task: string; at: number | null; boot: string; begin: number | null; kept: Kept | null };

export function MomentCard({ task, at, boot, begin, kept }: Given) {
  const replay = useLive((live) => live.replay !== null);
  const shown = useLive((live) => live.tree?.task === task);
  if (replay || (at === null && shown)) return shown ? <Now /> : null;
  if (at === null) return null;
  if (kept && !kept.boxes.length && !kept.recordings.length) return <NotRecorded at={at} begin={begin} />;
  return <Then task={task} at={at} boot={boot} begin={begin} />;
}

function title(at: number, begin: number | null) {
  return <>At {at.toFixed(1)} s of robot time{begin !== null && <span class="count">{words(at - begin)} into the task</span>}</>;
}

// The moment that the page shows anyway: now, or where a record stands.
function Now() {
  const board = useLive((live) => live.board);
  const world = useLive((live) => live.world);
  const now = useLive((live) => live.now);
  const pose = useLive((live) => live.pose);
  const replay = useLive((live) => live.replay !== null);
  return (
    <section class="card moment">
      <View3d small />
      <h2>{replay && now?.seconds != null ? title(now.seconds, null) : "Now"}</h2>
      <Values board={board} beliefs={{ items: world?.items ?? [], boot: now?.boot ?? null, now: now?.seconds ?? null }} pose={pose} />
    </section>
  );
}

function Then({ task, at, boot, begin }: { task: string; at: number; boot: string; begin: number | null }) {
  const [told, set] = useState<(Told & { live: Live }) | null>(null);
  const [error, fail] = useState("");
  useEffect(() => {
    let over = false;
    const timer = setTimeout(() => {
      get<Told>(`/api/task/${encodeURIComponent(task)}/moment?seconds=${at}&boot=${encodeURIComponent(boot)}`).then(
        (found) => over || (set({ ...found, live: knownThen(found.shown) }), fail("")),
        (wrong: Error) => over || (set(null), fail(wrong.message)),
      );
    }, 100);
    return () => {
      over = true;
      clearTimeout(timer);
    };
  }, [task, at, boot]);
  const live = told?.live;
  const tree = live?.tree?.task === task ? live.tree : null;
  return (
    <section class="card moment" aria-live="polite">
      {live?.pose && <View3d then={live} small />}
      <h2>{title(at, begin)}</h2>
      {error && <p class="quiet">{error}</p>}
      {!told && !error && <p class="quiet">Reading the record…</p>}
      {live && <>
        <Values board={tree ? live.board : {}} pose={live.pose}
          beliefs={{ items: live.world?.items ?? [], boot: told.stamp?.boot ?? null, now: told.stamp?.seconds ?? null }} />
        {tree && <details open><summary>Tree</summary><Past tree={tree} /></details>}
        <p class="quiet from">out of {told.file}</p>
      </>}
    </section>
  );
}

function Past({ tree }: { tree: TreeSnapshot }) {
  const nodes: Record<string, NodeState> = Object.fromEntries(states(tree.root));
  const ends = Object.entries(nodes).map(([path, [status, last]]): [string, NodeStatus] => [path, status === "INVALID" ? last : status]);
  return <Tree tree={tree} nodes={nodes} kept={Object.fromEntries(ends.filter(([, status]) => status !== "INVALID"))} gates={tree} failed={false} />;
}

function NotRecorded({ at, begin }: { at: number; begin: number | null }) {
  return (
    <section class="card moment">
      <h2>{title(at, begin)}</h2>
      <p>This moment was not recorded. To record those of the next task: <code>tandem up --record</code>. Of a task that fails a black box keeps the last minute.</p>
    </section>
  );
}

function Values({ board, beliefs, pose }: { board: Record<string, string>; beliefs: Beliefs; pose: { x: number; y: number; yaw: number } | null }) {
  const values = Object.entries(board);
  const site = useSite().value;
  return (
    <div class="known">
      <div>
        <h3>Board</h3>
        {values.length ? <dl>{values.map(([name, value]) => <><dt>{name}</dt><dd>{value}</dd></>)}</dl> : <p class="quiet">The tree tells no board.</p>}
      </div>
      <div>
        <h3>Beliefs</h3>
        <dl>
          {pose && <><dt>robot</dt><dd>{pose.x.toFixed(2)}, {pose.y.toFixed(2)}, heading {((pose.yaw * 180) / Math.PI).toFixed(0)}°</dd></>}
          {beliefs.items.map((fact) => <><dt>item {called(site, fact.item)}</dt><dd>{where(fact, beliefs)}</dd></>)}
        </dl>
        {!beliefs.items.length && <p class="quiet">Nothing is believed of any item.</p>}
      </div>
    </div>
  );
}

function where(fact: WorldState["items"][number], { boot, now }: Beliefs) {
  if (fact.held) return `in the ${fact.held} hand`;
  const place = fact.tag_in_map.position.map((each) => each.toFixed(2)).join(", ");
  const age = now !== null && fact.seen.boot === boot ? `seen ${words(Math.max(0, now - fact.seen.seconds))} before` : "seen before the last start";
  return `its face at ${place}, ${age}`;
}
