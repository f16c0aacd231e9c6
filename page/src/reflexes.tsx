// Who has which resource of the robot, what a reflex has taken from the tree, and reflexes to switch on and off.
import { useEffect, useRef, useState } from "preact/hooks";
import { act, may } from "./acting";
import { ask } from "./api";
import { useLive, type Reflex } from "./state";

export function Overridden() {
  const pipelines = useLive((live) => live.pipelines);
  const reflexes = useLive((live) => live.reflexes);
  const taken = Object.values(pipelines).filter((each) => each.reflex);
  const switched = Object.values(reflexes).filter((each) => each.on !== each.declared);
  if (!taken.length && !switched.length) return null;
  return (
    <section class="card warn" role="status">
      {taken.map((each) => (
        <p key={each.resource}><strong>⚡ {each.resource}</strong> is taken by the reflex <strong>{each.reflex}</strong>{each.why && `: ${each.why.message}`}</p>
      ))}
      {switched.map((each) => <p key={each.reflex}>The reflex <strong>{each.reflex}</strong> is {each.on ? "on" : "off"}{each.by && `, by ${each.by}`}.{!each.on && each.protects && ` It protects ${each.protects}.`}</p>)}
    </section>
  );
}

export function Resources() {
  const pipelines = Object.values(useLive((live) => live.pipelines)).sort((a, b) => a.resource.localeCompare(b.resource));
  const reflexes = Object.values(useLive((live) => live.reflexes)).sort((a, b) => b.rank - a.rank || a.reflex.localeCompare(b.reflex));
  if (!pipelines.length && !reflexes.length) return null;
  const busy = pipelines.filter((each) => each.holder || each.reflex).length;
  return (
    <details class="card resources">
      <summary><strong>Resources and reflexes</strong> <span class="quiet">{busy} of {pipelines.length} in use; {reflexes.filter((each) => each.on).length} of {reflexes.length} reflexes on</span></summary>
      {pipelines.length > 0 && <table>
        <thead><tr><th>Resource</th><th>Has it</th><th>Does</th></tr></thead>
        <tbody>
          {pipelines.map((each) => (
            <tr key={each.resource}>
              <td>{each.resource}</td>
              <td>{each.reflex ? <><strong>⚡ {each.reflex}</strong>{each.holder && <span class="quiet"> (before: {each.holder})</span>}</> : each.holder || <span class="quiet">free</span>}</td>
              <td class="quiet">{each.doing.join(" › ")}</td>
            </tr>
          ))}
        </tbody>
      </table>}
      <ul class="plain reflexes">{reflexes.map((each) => <li key={each.reflex}><Switch reflex={each} /></li>)}</ul>
    </details>
  );
}

function Switch({ reflex }: { reflex: Reflex }) {
  const next = !reflex.on;
  const words = `The reflex ${reflex.reflex} is ${next ? "on" : "off"}.`;
  const [asks, ask_] = useState(false);
  const press = useRef<HTMLButtonElement>(null);
  const turn = () => act(() => ask("reflex", { reflex: reflex.reflex, on: next }), words);
  const answered = (yes: boolean) => {
    ask_(false);
    press.current?.focus();
    if (yes) void turn();
  };
  return (
    <>
      <p>
        <strong>{reflex.reflex}</strong> <span class={`chip ${reflex.on ? "" : "off"}`}>{reflex.on ? "on" : "off"}</span>
        {reflex.by && <span class="quiet"> by {reflex.by}</span>}
        <span class="quiet"> · takes {reflex.resources.join(", ")} · fired {reflex.fired} {reflex.fired === 1 ? "time" : "times"}</span>
        <br /><span class="quiet">{reflex.about}</span>
        {asks && reflex.asks && <Sure reflex={reflex} answered={answered} />}
      </p>
      {may("reflex") && (
        <button class="small" ref={press} aria-label={`Switch ${reflex.reflex} ${next ? "on" : "off"}`} onClick={() => (reflex.asks ? ask_(true) : turn())}>
          Switch {next ? "on" : "off"}
        </button>
      )}
    </>
  );
}

// A reflex that protects somebody is not switched off by one press: what it is for is said, and not to do it is at hand.
function Sure({ reflex, answered }: { reflex: Reflex; answered: (yes: boolean) => void }) {
  const leave = useRef<HTMLButtonElement>(null);
  useEffect(() => leave.current?.focus(), []);
  return (
    <span class="sure" role="alertdialog" aria-label={`Switch ${reflex.reflex} off?`} onKeyDown={(event) => event.key === "Escape" && answered(false)}>
      <span>{reflex.asks}</span>
      <button class="small" ref={leave} onClick={() => answered(false)}>Leave it on</button>
      <button class="small danger" onClick={() => answered(true)}>Switch off all the same</button>
    </span>
  );
}
