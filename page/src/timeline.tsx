// When which node ran: a bar for each of its runs, skills and recoveries under their phases.
import { move } from "./replay";
import { mark } from "./route";
import { useLive } from "./state";
import type { Span, TaskStatus } from "./types";
import { KIND_SIGNS, seconds, STATUS_WORDS } from "./words";

type Run = { path: string; name: string; kind: string; begin: number; end: number | null; status: string; message: string };

// Times of two boots can't be compared: what was before the last one is left out, and said so.
// A moment of it is chosen by a click or the slider: in a replay that is where the record goes, else what the card
// below is about.
export function Timeline({ spans: told, status, at }: { spans: Span[]; status: TaskStatus; at: number | null }) {
  const now = useLive((live) => live.now);
  const replayed = useLive((live) => live.replay !== null);
  const boot = told.at(-1)!.begin.boot;
  const spans: Run[] = told
    .filter((each) => each.begin.boot === boot)
    .map((each) => ({ ...each, name: each.path.split("/").at(-1)!, begin: each.begin.seconds, end: each.end && each.end.seconds }))
    .sort((a, b) => a.begin - b.begin || a.path.length - b.path.length);
  const before = told.length - spans.length;
  const from = Math.min(...spans.map((each) => each.begin));
  const last = Math.max(...spans.map((each) => each.end ?? each.begin), from + 0.1);
  const to = spans.some((each) => each.end === null) && now?.boot === boot ? Math.max(last, now.seconds ?? 0) : last;
  const lanes = new Map<string, Run[]>();
  for (const each of spans) lanes.set(each.path, [...(lanes.get(each.path) ?? []), each]);
  const share = (value: number) => (100 * (value - from)) / (to - from);
  const over = status.ended !== null;
  const seek = (event: MouseEvent) => {
    const { left, width } = (event.currentTarget as Element).getBoundingClientRect();
    choose(from + ((to - from) * (event.clientX - left)) / width);
  };
  const choose = (moment: number) => (replayed ? void move({ seconds: moment }) : mark("at", moment.toFixed(1)));
  const cursor = replayed ? (now?.boot === boot ? now.seconds : null) : at;
  return (
    <section class="card">
      <h2>Timeline <span class="count">{seconds(to - from)} of robot time</span></h2>
      <ol class="timeline">
        {[...lanes].map(([path, runs]) => {
          const { name, kind } = runs[0]!;
          return (
            <li key={path} class={kind}>
              <span class="name" title={path}>{kind === "recovery" && <><span aria-hidden="true">{KIND_SIGNS[kind]} </span><span class="hidden">recovery: </span></>}{name}</span>
              <span class="lane" onClick={seek}>
                {cursor !== null && <span class="cursor" style={{ left: `${Math.min(100, Math.max(0, share(cursor)))}%` }} />}
                {runs.map((run) => (
                  <span key={run.begin} class={`run ${run.status}`} title={`${name}: ${seconds(run.begin - from)} to ${run.end === null ? "now" : seconds(run.end - from)}, ${STATUS_WORDS[run.status] ?? run.status}${run.message && `: ${run.message}`}`}
                    style={{ left: `${share(run.begin)}%`, width: `${Math.max(0.4, share(run.end ?? to) - share(run.begin))}%` }} />
                ))}
              </span>
              <span class="number">{seconds(runs.reduce((sum, run) => sum + (run.end ?? (over ? run.begin : to)) - run.begin, 0))}{runs.length > 1 && ` in ${runs.length}`}</span>
            </li>
          );
        })}
        {!replayed && (
          <li class="choose">
            <span class="name quiet">moment</span>
            <input type="range" min={from} max={to} step={0.1} value={at ?? to} aria-label="Moment of the timeline"
              aria-valuetext={at === null ? "none chosen" : seconds(at - from)} onInput={(event) => choose(Number(event.currentTarget.value))} />
            <span class="number">{at === null ? "" : <button class="small" onClick={() => mark("at", false)}>Clear</button>}</span>
          </li>
        )}
      </ol>
      {before > 0 && <p class="quiet">{before} runs before the hardware's last start are not drawn.</p>}
    </section>
  );
}
