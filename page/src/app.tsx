// The frame: where one is, how old the data is, the stop, and the view that the address names.
import { useEffect, useState } from "preact/hooks";
import { logOut, useActing, who } from "./acting";
import { History } from "./history";
import { Login } from "./login";
import { Map } from "./map";
import { NowView } from "./now";
import { Request } from "./request";
import { ReplayBar } from "./replay";
import { useRoute } from "./route";
import { useLive } from "./state";
import { StopButton, StopBanner } from "./stop";
import { TaskPage } from "./task";

const VIEWS: [string, string][] = [["/", "Now"], ["/map", "Map"], ["/request", "Request"], ["/history", "History"]];

export function App() {
  const url = useRoute();
  const { session, notice, strange } = useActing();
  const [first = ""] = url.pathname.slice(1).split("/");
  return (
    <>
      <a class="skip" href="#main" onClick={(event) => { event.preventDefault(); document.getElementById("main")?.focus(); }}>To the content</a>
      <header>
        <strong class="robot">{session ? `${session.site}/${session.robot}` : "Tandem"}</strong>
        <nav aria-label="Views">
          {VIEWS.filter(([path]) => path !== "/request" || session?.role !== "replay").map(([path, name]) => (
            <a key={path} href={path} aria-current={path === `/${first}` ? "page" : undefined}>{name}</a>
          ))}
        </nav>
        {session ? <LinkState /> : <span class="link" />}
        {session && session.role !== "replay" && <span class="role" title={session.keys ? `the key of ${session.who}` : "nobody logs in on this host"}>{session.role}</span>}
        {session?.login && <button class="small" title={`${session.who} is logged in`} onClick={logOut}>Log out</button>}
        <StopButton />
      </header>
      <StopBanner />
      <main id="main" tabIndex={-1}>{session ? <View first={first} url={url} /> : strange ? <Login /> : <p class="quiet">Asking the page's server…</p>}</main>
      <ReplayBar />
      <Said key={notice.count} words={notice.words} bad={notice.bad} />
    </>
  );
}

function View({ first, url }: { first: string; url: URL }) {
  if (first === "") return <NowView />;
  if (first === "map") return <Map url={url} />;
  if (first === "request") return who()?.role === "replay" ? <p class="quiet">A record takes no requests. <a href="/">Now</a></p> : <Request url={url} />;
  if (first === "login") return <NowView />;
  if (first === "history") return <History url={url} />;
  if (first === "task") return <TaskPage task={plain(url.pathname.split("/")[2] ?? "")} />;
  return <p class="quiet">There is nothing at this address. <a href="/">Now</a></p>;
}

// A word of the address; one that is cut in the middle of a character stays as it is.
function plain(word: string): string {
  try {
    return decodeURIComponent(word);
  } catch {
    return word;
  }
}

function Said({ words, bad }: { words: string; bad: boolean }) {
  const [open, set] = useState(words !== "");
  useEffect(() => {
    if (!words || bad) return;
    const timer = setTimeout(() => set(false), 5000);
    return () => clearTimeout(timer);
  }, []);
  return (
    <div class={`said-bar ${open ? "" : "gone"} ${bad ? "bad" : ""}`} role={bad ? "alert" : "status"}>
      <span>{words}</span>
      {open && <button class="small" onClick={() => set(false)} aria-label="Close">✕</button>}
    </div>
  );
}

const FIRST = 3000; // ms in which a page that was just opened is not said to have lost its link

// How old the data is: of the link to the server, of the robot's clock, of the executive.
function LinkState() {
  const connected = useLive((live) => live.connected);
  const link = useLive((live) => live.link);
  const replayed = useLive((live) => live.replay !== null);
  const executive = useLive((live) => live.executive);
  const silent = useLive((live) => live.now?.silent ?? null);
  const heardAt = useLive((live) => (live.connected ? 0 : live.heardAt));
  const [, again] = useState(0);
  useEffect(() => {
    if (connected) return;
    const timer = setInterval(() => again((count) => count + 1), 1000);
    return () => clearInterval(timer);
  }, [connected]);
  let words = "live";
  let state = "good";
  if (!connected && !heardAt && performance.now() < FIRST) [words, state] = ["connecting", "wait"];
  else if (!connected) {
    const age = heardAt ? ` – data is ${Math.round((performance.now() - heardAt) / 1000)} s old` : "";
    [words, state] = [`no link to the page's server${age}`, "bad"];
  } else if (link) [words, state] = [link, "bad"];
  else if (replayed) [words, state] = ["replay of a record", "good"];
  else if (executive === false) [words, state] = ["the executive is gone; waiting for it", "bad"];
  else if (silent !== null && silent > 1) [words, state] = [`the robot has been silent for ${silent.toFixed(0)} s`, "bad"];
  else if (silent === null) [words, state] = ["nothing heard of the robot yet", "wait"];
  return <span class={`link ${state}`} role="status"><span aria-hidden="true">{state === "good" ? "●" : "▲"}</span> {words}</span>;
}
