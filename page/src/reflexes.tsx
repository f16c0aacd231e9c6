// Resources that a reflex has taken from the tree, and reflexes that are switched off.
import { useLive } from "./state";

export function Overridden() {
  const pipelines = useLive((live) => live.pipelines);
  const reflexes = useLive((live) => live.reflexes);
  const taken = Object.values(pipelines).filter((each) => each.reflex);
  const off = Object.values(reflexes).filter((each) => !each.on);
  if (!taken.length && !off.length) return null;
  return (
    <section class="card warn" role="status">
      {taken.map((each) => (
        <p key={each.resource}><strong>⚡ {each.resource}</strong> is taken by the reflex <strong>{each.reflex}</strong>{each.why && `: ${each.why.message}`}</p>
      ))}
      {off.map((each) => <p key={each.reflex}>The reflex <strong>{each.reflex}</strong> is off{each.by && `, by ${each.by}`}.</p>)}
    </section>
  );
}
