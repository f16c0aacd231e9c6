// The ledger's tasks. The filters are the address, so that a view can be sent to a colleague.
import { useEffect, useState } from "preact/hooks";
import { get } from "./api";
import { useKinds } from "./loading";
import { go } from "./route";
import { useLive } from "./state";
import { Typed } from "./typed";
import type { TaskStatus } from "./types";
import { root, seconds, STATE_SIGNS, summary, took, when } from "./words";

type Kind = { kind: string; count: number; succeeded: number; decided: number; median: number | null };
type Week = Kind & { week: string };
type Node = { failure: string; where: string; count: number };
type Found = {
  tasks: TaskStatus[]; left_out: boolean; count: number; pages: number; states: Record<string, number>; failures: Record<string, number>; kinds: Kind[];
  weeks: Week[]; nodes: Node[]; labels: string[];
};
const STATES = Object.keys(STATE_SIGNS);
const DAYS: [string, string][] = [["", "any time"], ["1", "last day"], ["7", "last 7 days"], ["30", "last 30 days"]];

export function History({ url }: { url: URL }) {
  const [found, set] = useState<Found | null>(null);
  const [error, fail] = useState("");
  const kinds = useKinds().value;
  const executive = useLive((live) => live.executive);
  const moment = useLive((live) => (live.replay ? Math.floor(live.replay.at) : 0));
  const newest = useLive((live) => Object.values(live.tasks).map((each) => each.state).join());
  const wanted = Object.fromEntries(url.searchParams);
  useEffect(() => {
    let over = false;
    get<Found>(`/api/history?${url.searchParams}`).then(
      (answer) => over || (set(answer), fail("")),
      (wrong: Error) => over || fail(wrong.message),
    );
    return () => void (over = true);
  }, [url.search, newest, executive, moment]);
  const change = (name: string, value: string) => {
    const next = new URLSearchParams(url.search);
    if (name !== "page") next.delete("page");
    if (value) next.set(name, value);
    else next.delete(name);
    go(`/history?${next}`, true);
  };
  const page = Number(wanted.page ?? 0);
  const choose = (name: string, options: [string, string][]) => (
    <label>{name === "days" ? "time" : name}
      <select value={wanted[name] ?? ""} onChange={(event) => change(name, event.currentTarget.value)}>
        {offered(options, wanted[name] ?? "").map(([value, words]) => <option key={value} value={value}>{words}</option>)}
      </select>
    </label>
  );
  const any = (values: string[]): [string, string][] => [["", "any"], ...values.map((each): [string, string] => [each, each])];
  return (
    <div class="history">
      <form class="card filters" onSubmit={(event) => event.preventDefault()} aria-label="Filters">
        {choose("state", any(STATES))}
        {choose("kind", any(kinds?.kinds.map((each) => each.name) ?? []))}
        <label>item <Typed value={wanted.item ?? ""} list="items" size={6} take={(value) => change("item", value)} /></label>
        <datalist id="items">{kinds?.items.map((each) => <option key={each} value={each} />)}</datalist>
        {choose("failure", any(Object.keys(found?.failures ?? {})))}
        {wanted.where && choose("where", any([]))}
        <label>label <Typed value={wanted.label ?? ""} list="labels" size={10} take={(value) => change("label", value)} /></label>
        <datalist id="labels">{found?.labels.map((each) => <option key={each} value={each} />)}</datalist>
        {choose("days", DAYS)}
        {choose("week", any([...new Set(found?.weeks.map((each) => each.week))]))}
        <label>text <Typed type="search" value={wanted.text ?? ""} take={(value) => change("text", value)} /></label>
        {url.search && <a href="/history">Clear</a>}
      </form>
      {error && <p class="failure" role="alert">{error}</p>}
      {found && <Summary found={found} search={url.search} />}
      {found && (
        <div class="card scroll">
          <table>
            <thead><tr><th>State</th><th>Task</th><th>Request</th><th>Accepted</th><th class="number">Took</th><th>Failure</th></tr></thead>
            <tbody>
              {found.tasks.map((each) => {
                const cause = each.failure && root(each.failure);
                return (
                  <tr key={each.task}>
                    <td class={`state ${each.state}`}><span class={`sign ${each.state}`} aria-hidden="true">{STATE_SIGNS[each.state]}</span> {each.state}</td>
                    <td><a href={`/task/${encodeURIComponent(each.task)}`}>{each.task}</a></td>
                    <td class="what">{summary(each.request)}</td>
                    <td>{when(each.accepted_at)}</td>
                    <td class="number">{seconds(took(each, null))}</td>
                    <td>{cause && <><strong>{cause.kind}</strong> <span class="quiet">{cause.where}</span></>}</td>
                  </tr>
                );
              })}
            </tbody>
          </table>
          {!found.count && <p class="quiet">No task passes these filters.</p>}
          {found.pages > 1 && (
            <p class="verbs">
              <button disabled={page === 0} onClick={() => change("page", page > 1 ? String(page - 1) : "")}>Newer</button>
              <span>page {page + 1} of {found.pages}</span>
              <button disabled={page + 1 >= found.pages} onClick={() => change("page", String(page + 1))}>Older</button>
            </p>
          )}
        </div>
      )}
    </div>
  );
}

// What the address asks for is shown, also where it is none of what is offered: a filter that works is never hidden.
const offered = (options: [string, string][], wanted: string): [string, string][] =>
  options.some(([value]) => value === wanted) ? options : [...options, [wanted, wanted]];

function Summary({ found, search }: { found: Found; search: string }) {
  // The same filters and one more.
  const also = (more: Record<string, string>) => {
    const next = new URLSearchParams(search);
    next.delete("page");
    for (const [name, value] of Object.entries(more)) next.set(name, value);
    return `/history?${next}`;
  };
  const failed = found.nodes.reduce((sum, each) => sum + each.count, 0);
  return (
    <section class="card" aria-label="Counts">
      <p class="figures-card">
        <span><strong>{found.count}</strong> {found.count === 1 ? "task" : "tasks"}</span>
        {found.left_out && <span class="quiet">of the newest that the page's server has room for</span>}
        {found.kinds.map((each) => <span key={each.kind}><strong>{each.kind}</strong> {each.count} <Rate of={each} /></span>)}
      </p>
      {found.weeks.length > 0 && (
        <details class="scroll">
          <summary>By week and kind</summary>
          <table>
            <thead><tr><th>Week</th><th>Kind</th><th class="number">Tasks</th><th class="number">Succeeded</th><th class="number">Rate</th><th class="number">Median time</th></tr></thead>
            <tbody>{found.weeks.map((each) => (
              <tr key={`${each.week} ${each.kind}`}>
                <td><a href={also({ week: each.week })}>{each.week}</a></td>
                <td><a href={also({ week: each.week, kind: each.kind })}>{each.kind}</a></td>
                <td class="number">{each.count}</td>
                <td class="number">{each.succeeded} of {each.decided}</td>
                <td class="number">{each.decided ? `${percent(each)} %` : "–"}</td>
                <td class="number">{seconds(each.median)}</td>
              </tr>
            ))}</tbody>
          </table>
        </details>
      )}
      {found.nodes.length > 0 && (
        <details class="scroll">
          <summary>Failures by kind and node <span class="count">{failed}</span></summary>
          <table>
            <thead><tr><th>Failure</th><th>Node or skill</th><th class="number">Tasks</th></tr></thead>
            <tbody>{found.nodes.map((each) => (
              <tr key={`${each.failure} ${each.where}`}>
                <td><a href={also({ failure: each.failure })}>{each.failure}</a></td>
                <td class="what">{each.where ? <a href={also({ failure: each.failure, where: each.where })}>{each.where}</a> : "–"}</td>
                <td class="number">{each.count}</td>
              </tr>
            ))}</tbody>
          </table>
        </details>
      )}
    </section>
  );
}

const percent = (of: Kind) => Math.round((100 * of.succeeded) / of.decided);

function Rate({ of }: { of: Kind }) {
  return (
    <span class="quiet">
      {of.decided > 0 && ` · ${of.succeeded} of ${of.decided} succeeded (${percent(of)} %)`}
      {of.median !== null && ` · ${seconds(of.median)} median`}
    </span>
  );
}
