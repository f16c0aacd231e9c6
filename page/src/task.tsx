// All of one task, live or stored: what was asked, how it went, why it failed, what was tried, what to do.
import { useEffect, useState } from "preact/hooks";
import { get } from "./api";
import { TaskCard } from "./card";
import { MomentCard } from "./moment";
import { Records, useRecords } from "./records";
import { useRoute } from "./route";
import { ended, useLive } from "./state";
import { Timeline } from "./timeline";
import { LiveTree } from "./tree";
import type { Attempt, Failure, Span, TaskStatus } from "./types";
import { alike, command, seconds, together, when } from "./words";

type Told = { status: TaskStatus; words: string; next?: string; meaning?: string; helper?: string; timeline: Span[] };

export function TaskPage({ task }: { task: string }) {
  const live = useLive((all) => all.tasks[task]);
  const shownTree = useLive((all) => all.tree?.task === task);
  const [told, set] = useState<Told | null>(null);
  const [error, fail] = useState("");
  const replayed = useLive((all) => all.replay !== null);
  const moment = useLive((all) => (all.replay ? Math.floor(all.replay.at) : 0));
  const running = live !== undefined && !ended(live);
  useEffect(() => {
    let over = false;
    const load = () =>
      get<Told>(`/api/task/${encodeURIComponent(task)}`).then(
        (answer) => over || (set(answer), fail("")),
        (wrong: Error) => over || fail(wrong.message),
      );
    void load();
    const timer = running ? setInterval(load, 2000) : 0;
    return () => {
      over = true;
      clearInterval(timer);
    };
  }, [task, running, live?.state, moment]);
  const status = live ?? told?.status;
  const kept = useRecords(task, status?.state ?? "");
  const asked = useRoute().searchParams.get("at");
  if (!status) return <p class="quiet" role="status">{error || "Loading…"} {error && <a href="/history">History</a>}</p>;
  const { failure } = status;
  const at = asked === null || !Number.isFinite(Number(asked)) ? null : Number(asked);
  return (
    <div class="taskpage">
      <TaskCard status={status} linked={false} />
      {failure && (
        <section class="card">
          <h2>Why</h2>
          <Chain repeated={[failure]} status={status} />
          {told?.next && <p class="next"><strong>What to do:</strong> {told.next}</p>}
        </section>
      )}
      <div class="timed">
        {told && told.timeline.length > 0 && <Timeline spans={told.timeline} status={status} at={at} />}
        <MomentCard task={task} at={at} boot={told?.timeline.at(-1)?.begin.boot ?? status.started?.boot ?? ""} begin={status.started?.seconds ?? null} kept={kept} />
      </div>
      <Tried status={status} />
      {!replayed && <Records kept={kept} task={task} />}
      {status.result && <section class="card"><h2>Result</h2><pre>{JSON.stringify(status.result, null, 2)}</pre></section>}
      <section class="card">
        <h2>Request</h2>
        <dl>
          <dt>id</dt><dd><code>{status.task}</code></dd>
          <dt>client</dt><dd>{String(status.request.by ?? "") || "without a name"}{status.client_id && <span class="quiet"> ({status.client_id})</span>}</dd>
          <dt>accepted</dt><dd>{when(status.accepted_at)}</dd>
          {status.ended_at !== null && <><dt>ended</dt><dd>{when(status.ended_at)}</dd></>}
          {status.begun > 1 && <><dt>begun</dt><dd>{status.begun} times</dd></>}
          {typeof status.request.retry_of === "string" && status.request.retry_of && <><dt>retry of</dt><dd><a href={`/task/${encodeURIComponent(status.request.retry_of)}`}>{status.request.retry_of}</a></dd></>}
        </dl>
        <pre>{JSON.stringify(status.request, null, 2)}</pre>
        <p class="quiet">In a terminal: <code>tandem why {status.task}</code>, <code>tandem logs {status.task}</code></p>
        <details><summary>The request as a command</summary><pre>{command(status.request)}</pre></details>
      </section>
      {shownTree && <section class="card"><h2>Tree</h2><LiveTree failed={status.state === "FAILED"} /></section>}
      {told && <details class="card"><summary>In words, as <code>tandem why</code> says it</summary><pre>{told.words}</pre></details>}
    </div>
  );
}

// A failure and what is below it; one that came several times is said once.
function Chain({ repeated, status }: { repeated: [Failure, ...Failure[]]; status: TaskStatus }) {
  const [failure] = repeated;
  const names = [...new Set(repeated.flatMap((each) => Object.keys(each.evidence ?? {})))];
  const evidence = names.map((name) => `${name} ${values(repeated.map((each) => each.evidence?.[name]))}`);
  const attempts = status.tried.filter((each) => alike(each.failure) === alike(failure));
  return (
    <div class="chain">
      <p><strong>{failure.kind}</strong>{failure.where && <span class="quiet"> at {failure.where}</span>}: {failure.message}</p>
      {repeated.length > 1 && <p class="quiet">{repeated.length} times{span(attempts, status)}</p>}
      {evidence.length > 0 && <p class="quiet">{evidence.join(", ")}</p>}
      {together(repeated.flatMap((each) => each.causes), alike).map((causes, i) => <div key={i}><p class="quiet">because of</p><Chain repeated={causes} status={status} /></div>)}
    </div>
  );
}

function values(all: unknown[]): string {
  const known = [...new Set(all.filter((each) => each !== undefined))];
  const numbers = known.filter((each) => typeof each === "number");
  return known.length > 1 && numbers.length === known.length ? `${Math.min(...numbers)} to ${Math.max(...numbers)}` : known.join(" | ");
}

// Seconds into the task; "" of another boot than that in which it began.
const since = (at: Attempt["at"], { started }: TaskStatus) => (at && started && at.boot === started.boot ? seconds(at.seconds - started.seconds) : "");

function span(attempts: Attempt[], status: TaskStatus): string {
  const [first, last] = [attempts[0]?.at ?? null, attempts.at(-1)?.at ?? null];
  if (!first || !last || first.boot !== last.boot || first.seconds === last.seconds || !since(first, status)) return "";
  return `: the first after ${since(first, status)}, the last after ${since(last, status)}`;
}

function Tried({ status }: { status: TaskStatus }) {
  if (!status.tried.length) return null;
  return (
    <section class="card">
      <h2>What was tried</h2>
      <ol class="tried">{together(status.tried, sameTry).map((group, i) => <Try key={i} group={group} status={status} />)}</ol>
    </section>
  );
}

const sameTry = ({ at, failure, recovery }: Attempt) => JSON.stringify([alike(failure), recovery, at?.boot]);

function Try({ group, status }: { group: [Attempt, ...Attempt[]]; status: TaskStatus }) {
  const [{ at, failure, recovery, times }] = group;
  const did = recovery || "no recovery took it";
  return (
    <li>
      <span class="number">{since(at, status)}</span> <strong>{failure.kind}</strong> {failure.where && <span class="quiet">at {failure.where}</span>} {failure.message}
      <br /><span class="quiet">→ {group.length > 1 ? `${did}, ${group.length} times${span(group, status)}` : recovery ? `${did}, time ${times}` : did}</span>
      {group.map((attempt) => attempt.picture && (
        <details key={attempt.picture}>
          <summary>Picture {group.length > 1 ? `after ${since(attempt.at, status)}` : "of that moment"}</summary>
          <img loading="lazy" src={`/api/task/${encodeURIComponent(status.task)}/picture/${encodeURIComponent(attempt.picture)}`} alt={`What the camera saw when ${failure.kind} was noticed`} />
        </details>
      ))}
    </li>
  );
}
