// One task in short, with the verbs that it takes now and that the viewer may ask.
import { act, may } from "./acting";
import { ask } from "./api";
import { go } from "./route";
import { Typed } from "./typed";
import { ended, useLive } from "./state";
import type { TaskStatus } from "./types";
import { root, seconds, STATE_SIGNS, summary, took } from "./words";

export function TaskCard({ status, linked = true }: { status: TaskStatus; linked?: boolean }) {
  const now = useLive((live) => live.now);
  const percent = Math.round(status.progress.fraction * 100);
  const cause = status.failure && root(status.failure);
  return (
    <section class={`card task ${status.state}`} aria-label={`Task ${status.task}`}>
      <h2>
        <span class="state"><span class={`sign ${status.state}`} aria-hidden="true">{STATE_SIGNS[status.state]}</span> {status.state}</span>
        {linked ? <a href={`/task/${encodeURIComponent(status.task)}`}>{status.kind}</a> : <span>{status.kind}</span>}
        <span class="what">{summary(status.request)}</span>
      </h2>
      <div class="progress" role="progressbar" aria-valuenow={percent} aria-valuemin={0} aria-valuemax={100} aria-label="progress">
        <span style={{ width: `${percent}%` }} />
      </div>
      <p class="figures">
        <span>{percent} %</span>
        {status.progress.phase && <span>{status.progress.phase}</span>}
        <span>{seconds(took(status, now))}</span>
        {!ended(status) && status.time_left !== null && status.state !== "QUEUED" && <span>about {seconds(status.time_left)} left</span>}
        {status.waits_for && <span>{status.waits_for}</span>}
      </p>
      {cause && <p class="failure"><strong>{cause.kind}</strong> {cause.where && `at ${cause.where}: `}{cause.message}</p>}
      {status.question && <Question status={status} />}
      <Verbs status={status} />
    </section>
  );
}

function Question({ status }: { status: TaskStatus }) {
  const question = status.question!;
  return (
    <div class="question" role="alert">
      <p><strong>{question.text}</strong></p>
      {may("answer")
        ? question.choices.map((choice) => (
            <button key={choice} onClick={() => act(() => ask("answer", { task: status.task, answer: choice }), `Answered: ${choice}`)}>{choice}</button>
          ))
        : <p class="quiet">An operator may answer: {question.choices.join(", ")}</p>}
    </div>
  );
}

const TAKES: Record<string, string[]> = {
  QUEUED: ["cancel"],
  RUNNING: ["pause", "cancel"],
  PAUSING: ["resume", "cancel"],
  PAUSED: ["resume", "step", "cancel"],
  CANCELING: ["abandon"],
};

export function Verbs({ status }: { status: TaskStatus }) {
  const { task } = status;
  const verbs = (ended(status) ? ["retry"] : (TAKES[status.state] ?? [])).filter(may);
  if (!verbs.length) return null;
  const words: Record<string, string> = { cancel: "Cancel", pause: "Pause", resume: "Resume", step: "Step", abandon: "Abandon", retry: "Retry" };
  const press = (verb: string) =>
    act(async () => {
      const { answer } = await ask(verb, { task });
      if (verb === "retry") go(`/task/${encodeURIComponent(String(answer))}`);
    }, `${words[verb]}: taken.`);
  return (
    <p class="verbs">
      {verbs.map((verb) => <button key={verb} onClick={() => press(verb)}>{words[verb]}</button>)}
      {status.state === "QUEUED" && may("reprioritise") && (
        <label>priority <Typed type="number" min={-100} max={100} value={String(status.priority)}
          take={(value) => value !== "" && act(() => ask("reprioritise", { task, priority: Number(value) }), "The queue has changed.")} /></label>
      )}
    </p>
  );
}
