// The other robots of the site: where each tells that it is, and what it does.
import { useActing } from "./acting";
import { useLive } from "./state";

export function Others() {
  const heard = useLive((live) => live.robots);
  const pages = useActing().session?.pages ?? {};
  const names = [...new Set([...Object.keys(heard), ...Object.keys(pages)])].sort((a, b) => a.localeCompare(b));
  const robots = names.map((name) => [name, heard[name]] as const);
  if (!robots.length) return null;
  return (
    <section class="card others">
      <h2>Other robots <span class="count">{robots.length}</span></h2>
      <ul class="plain">
        {robots.map(([name, told]) => (
          <li key={name}>
            {pages[name] ? <a href={pages[name]} title={`the page of ${name}: ${pages[name]}`}><strong>{name}</strong></a> : <strong>{name}</strong>} {!told ? "" : told.kind ? `${told.kind}${told.phase && `: ${told.phase}`}` : <span class="quiet">without a task</span>}
            <span class="quiet"> · {!told ? "nothing heard" : told.silent ? "silent; it may be elsewhere" : told.at ? `at ${told.at[0].toFixed(2)}, ${told.at[1].toFixed(2)}` : "does not know where it is"}</span>
          </li>
        ))}
      </ul>
    </section>
  );
}
