// The other robots of the site: where each tells that it is, and what it does.
import { useActing } from "./acting";
import { useLive } from "./state";

export function Others() {
  const robots = Object.entries(useLive((live) => live.robots)).sort(([a], [b]) => a.localeCompare(b));
  const pages = useActing().session?.pages ?? {};
  if (!robots.length) return null;
  return (
    <section class="card others">
      <h2>Other robots <span class="count">{robots.length}</span></h2>
      <ul class="plain">
        {robots.map(([name, told]) => (
          <li key={name}>
            {pages[name] ? <a href={pages[name]} title={`the page of ${name}: ${pages[name]}`}><strong>{name}</strong></a> : <strong>{name}</strong>} {told.kind ? `${told.kind}${told.phase && `: ${told.phase}`}` : <span class="quiet">without a task</span>}
            <span class="quiet"> · {told.silent ? "silent; it may be elsewhere" : told.at ? `at ${told.at[0].toFixed(2)}, ${told.at[1].toFixed(2)}` : "does not know where it is"}</span>
          </li>
        ))}
      </ul>
    </section>
  );
}
