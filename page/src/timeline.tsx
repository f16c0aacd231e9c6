// When which node ran: a bar for each of its runs, skills and recoveries under their phases.
import type { TaskStatus } from "./types";
import { seconds } from "./words";

export type Span = { path: string; name: string; kind: string; begin: number; end: number | null; status: string; message: string };

export function Timeline({ spans, status }: { spans: Span[]; status: TaskStatus }) {
  const from = Math.min(...spans.map((each) => each.begin));
  const to = Math.max(...spans.map((each) => each.end ?? each.begin), from + 1);
  const lanes = new Map<string, Span[]>();
  for (const each of spans) lanes.set(each.path, [...(lanes.get(each.path) ?? []), each]);
  const share = (value: number) => (100 * (value - from)) / (to - from);
  const over = status.ended !== null;
  return (
    <section class="card">
      <h2>Timeline <span class="count">{seconds(to - from)} of robot time</span></h2>
      <ol class="timeline">
        {[...lanes].map(([path, runs]) => {
          const { name, kind } = runs[0]!;
          return (
            <li key={path} class={kind}>
              <span class="name" title={path}>{name}</span>
              <span class="lane">
                {runs.map((run) => (
                  <span key={run.begin} class={`run ${run.status}`} title={`${name}: ${seconds(run.begin - from)} to ${run.end === null ? "now" : seconds(run.end - from)}, ${run.status.toLowerCase()}${run.message && `: ${run.message}`}`}
                    style={{ left: `${share(run.begin)}%`, width: `${Math.max(0.4, share(run.end ?? to) - share(run.begin))}%` }} />
                ))}
              </span>
              <span class="number">{seconds(runs.reduce((sum, run) => sum + (run.end ?? (over ? run.begin : to)) - run.begin, 0))}{runs.length > 1 && ` in ${runs.length}`}</span>
            </li>
          );
        })}
      </ol>
    </section>
  );
}
