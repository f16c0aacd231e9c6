// Requests that somebody keeps, by a name of his own. They stay in this browser; as JSON they go to another one.
import { useState } from "preact/hooks";
import { say } from "./acting";
import { go } from "./route";
import type { Values } from "./form";

export type Favourite = { name: string; task: string; values: Values };
const WHERE = "tandem.favourites";
const MOST = 100;

// What is stored may be of anybody: what is no favourite is left out.
function checked(found: unknown): Favourite[] {
  if (!Array.isArray(found)) return [];
  return found.filter((each): each is Favourite =>
    typeof each?.name === "string" && each.name !== "" && typeof each.task === "string" && typeof each.values === "object" && each.values !== null
    && Object.values(each.values as object).every((value) => typeof value === "string")).slice(0, MOST);
}

function read(): Favourite[] {
  try {
    return checked(JSON.parse(localStorage.getItem(WHERE) ?? "[]"));
  } catch {
    return [];
  }
}

export function useFavourites() {
  const [kept, set] = useState(read);
  const write = (next: Favourite[]) => {
    const some = checked(next);
    try {
      localStorage.setItem(WHERE, JSON.stringify(some));
    } catch {
      say("This browser keeps nothing; the favourite lasts until the page is closed.", true);
    }
    set(some);
  };
  const add = (one: Favourite) => write([one, ...kept.filter((each) => each.name !== one.name)]);
  return { kept, add, remove: (name: string) => write(kept.filter((each) => each.name !== name)), all: write };
}

export const address = (one: Favourite) => `/request?${new URLSearchParams({ task: one.task, ...one.values })}`;

type Given = { kept: Favourite[]; remove: (name: string) => void; all: (next: Favourite[]) => void; chosen: () => void };

export function Favourites({ kept, remove, all, chosen }: Given) {
  const save = () => {
    const url = URL.createObjectURL(new Blob([JSON.stringify(kept, null, 2)], { type: "application/json" }));
    Object.assign(document.createElement("a"), { href: url, download: "tandem-favourites.json" }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  };
  const load = async (input: HTMLInputElement) => {
    const file = input.files?.[0];
    if (!file) return;
    try {
      const found = checked(JSON.parse(await file.text()));
      if (!found.length) throw new Error();
      all([...found, ...kept.filter((each) => !found.some((one) => one.name === each.name))]);
      say(`${found.length} ${found.length === 1 ? "favourite" : "favourites"} taken from ${file.name}.`);
    } catch {
      say(`${file.name}: expected a list of favourites, as "Save as JSON" writes it.`, true);
    }
    input.value = "";
  };
  const choose = (event: MouseEvent, one: Favourite) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // another tab
    event.preventDefault();
    go(address(one));
    chosen();
  };
  return (
    <section class="favourites" aria-label="Favourites">
      <h2>Favourites</h2>
      {!kept.length && <p class="quiet">None yet. A form can be kept under a name.</p>}
      <ul class="plain">
        {kept.map((each) => (
          <li key={each.name}>
            <a href={address(each)} onClick={(event) => choose(event, each)}><strong>{each.name}</strong> <span class="quiet">{each.task}</span></a>
            <button class="small" aria-label={`Forget ${each.name}`} onClick={() => remove(each.name)}>✕</button>
          </li>
        ))}
      </ul>
      <p class="verbs">
        {kept.length > 0 && <button class="small" onClick={save}>Save as JSON</button>}
        <label class="button small">Load<input type="file" accept="application/json" hidden onChange={(event) => load(event.currentTarget)} /></label>
      </p>
    </section>
  );
}

export function Keep({ task, values, add }: { task: string; values: Values; add: (one: Favourite) => void }) {
  const [name, set] = useState("");
  const keep = () => {
    add({ name: name.trim(), task, values: Object.fromEntries(Object.entries(values).filter(([, value]) => value)) });
    say(`Kept as ${name.trim()}.`);
    set("");
  };
  return (
    <span class="keep">
      <input aria-label="Name of the favourite" placeholder="Name" maxLength={80} size={14} value={name} onInput={(event) => set(event.currentTarget.value)} />
      <button type="button" disabled={!name.trim()} onClick={keep}>Keep as favourite</button>
    </span>
  );
}
