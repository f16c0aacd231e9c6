// A request: the kinds that this robot can do, a form of the chosen one, and the same as JSON and as a command.
import { useLayoutEffect, useMemo, useState } from "preact/hooks";
import { may, say } from "./acting";
import { AskError, post } from "./api";
import { Favourites, Keep, useFavourites, type Favourite } from "./favourites";
import { document as make, Field, fields, type Schema, type Values } from "./form";
import { useKinds, useRobot, useSite } from "./loading";
import { go } from "./route";
import type { Problem, RobotDescription, Site } from "./types";
import { command } from "./words";

const COMMON = new Set(["on_cancel", "priority", "not_before", "expires", "on_restart", "test_run", "labels"]);
const HIDDEN = new Set(["id", "retry_of", "by"]);

export function Request({ url }: { url: URL }) {
  const kinds = useKinds();
  const site = useSite().value;
  const robot = useRobot().value;
  const { kept, add, remove, all } = useFavourites();
  const [count, again] = useState(0); // another favourite of the same kind is another form
  const { task = "", ...given } = Object.fromEntries(url.searchParams);
  if (!kinds.value) return <p class="quiet">{kinds.error || "Asking which tasks there are…"}</p>;
  const kind = kinds.value.kinds.find((each) => each.name === task);
  return (
    <div class="request">
      <nav class="card kinds" aria-label="Kinds of task">
        <h2>Task</h2>
        {kinds.value.kinds.map((each) => {
          const lacks = kinds.value!.unable[each.name];
          return (
            <a key={each.name} href={`/request?task=${encodeURIComponent(each.name)}`} class={lacks ? "unable" : ""} aria-current={each.name === task ? "true" : undefined}>
              <strong>{each.name}</strong> <span class="quiet">{lacks ? `not with this robot: ${lacks}` : each.summary}</span>
            </a>
          );
        })}
        <Favourites kept={kept} remove={remove} all={all} chosen={() => again(count + 1)} />
      </nav>
      {kind ? <Form key={`${task} ${count}`} name={task} keep={add} schema={kind.request as Schema} given={given} items={[...Object.keys(kinds.value.names), ...kinds.value.items]} site={site} robot={robot} />
        : <p class="quiet">{task ? `There is no task ${task}.` : "Choose what the robot is to do."}</p>}
    </div>
  );
}

type Given = { name: string; keep: (one: Favourite) => void; schema: Schema; given: Values; items: string[]; site: Site | null; robot: RobotDescription | null };

function Form({ name, keep, schema, given, items, site, robot }: Given) {
  const [values, set] = useState<Values>(given);
  const [problems, wrong] = useState<Problem[]>([]);
  const [sending, send] = useState(false);
  const [copied, copy] = useState("");
  const made = make(schema, values);
  const id = useMemo(() => crypto.randomUUID(), [values]); // sent twice, by two clicks or after a lost answer, it is one request
  useLayoutEffect(() => { // before anything else happens: a page that is loaded anew loses no word
    const filled = Object.entries(values).filter(([, value]) => value);
    go(`/request?${new URLSearchParams({ task: name, ...Object.fromEntries(filled) })}`, true);
  }, [values]);
  const submit = async (event: Event) => {
    event.preventDefault();
    send(true);
    wrong([]);
    try {
      const { task } = await post<{ task: string }>("/api/request", { ...made, id });
      say(`${task} was accepted.`);
      go("/");
    } catch (error) {
      const found = error instanceof AskError ? error.problems : [];
      wrong(found);
      const other = found.filter((each) => !(each.path in (schema.properties ?? {})));
      say(found.length ? `The request was not taken.${other.map((each) => ` ${each.path}: expected ${each.expected}`).join("")}` : String((error as Error).message), true);
    }
    send(false);
  };
  const offers = (field: string): string[] => {
    if (["item", "left", "right"].includes(field)) return items;
    if (field === "to") return site?.depots.map((each) => each.name) ?? [];
    if (field === "arm") return robot?.end_effectors.map((each) => each.side) ?? [];
    return [];
  };
  const draw = ([field, about]: [string, Schema]) => (
    <Field key={field} name={field} field={about} value={values[field] ?? ""} needed={schema.required?.includes(field) ?? false}
      offers={offers(field)} problem={problems.find((each) => each.path.split(/[.[]/)[0] === field)}
      change={(value) => set({ ...values, [field]: value })} />
  );
  const shown = fields(schema).filter(([field]) => !HIDDEN.has(field));
  const common = shown.filter(([field]) => COMMON.has(field));
  const write = async (words: string, what: string) => {
    await navigator.clipboard?.writeText(words).catch(() => undefined);
    copy(what);
  };
  return (
    <form class="card" onSubmit={submit} noValidate aria-label={`Request ${name}`}>
      <h2>{name}</h2>
      <p class="quiet">{schema.description}</p>
      <div class="fields">{shown.filter(([field]) => !COMMON.has(field)).map(draw)}</div>
      <details open={common.some(([field]) => values[field])}>
        <summary>When, how urgent, and what else</summary>
        <div class="fields">{common.map(draw)}</div>
      </details>
      <p class="verbs">
        {may("request") ? <button class="primary" disabled={sending}>Send</button> : <span class="quiet">This key does not allow requests.</span>}
        <Keep task={name} values={values} add={keep} />
      </p>
      <details class="same">
        <summary>The same as JSON and as a command</summary>
        <pre>{JSON.stringify(made, null, 2)}</pre>
        <button type="button" class="small" onClick={() => write(JSON.stringify(made, null, 2), "json")}>{copied === "json" ? "Copied" : "Copy JSON"}</button>
        <pre>{command(made)}</pre>
        <button type="button" class="small" onClick={() => write(command(made), "command")}>{copied === "command" ? "Copied" : "Copy command"}</button>
      </details>
    </form>
  );
}
