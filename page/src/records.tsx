// Which records have a task, why they were kept, and how one looks at them.
import { useEffect, useState } from "preact/hooks";
import { get } from "./api";
import { useLive } from "./state";
import type { RobotTime } from "./types";
import { size } from "./words";

type Box = { file: string; size: number; causes: { words: string; stamp: RobotTime | null }[]; command: string };
type Recording = Omit<Box, "causes">;
export type Kept = { boxes: Box[]; recordings: Recording[]; silent?: boolean };

export function useRecords(task: string, about: string): Kept | null {
  const replayed = useLive((live) => live.replay !== null); // a record does not know of itself
  const [kept, set] = useState<Kept | null>(null);
  useEffect(() => {
    if (replayed) return;
    let over = false;
    // A black box is written two seconds after a failure.
    const load = () => get<Kept>(`/api/task/${encodeURIComponent(task)}/records`).then((found) => over || set(found), () => undefined);
    void load();
    const again = setTimeout(load, 5000);
    return () => {
      over = true;
      clearTimeout(again);
    };
  }, [task, about, replayed]);
  return kept;
}

export function Records({ kept, task }: { kept: Kept | null; task: string }) {
  if (!kept) return null;
  const { boxes, recordings, silent } = kept;
  return (
    <section class="card">
      <h2>Records</h2>
      {boxes.map((box) => (
        <div key={box.file} class="record">
          <p><strong>Black box</strong>, the last minute, because {box.causes.map(({ words, stamp }, i) => (
            <span key={i}>{i > 0 && "; "}{stamp === null ? words : <a href={`/task/${encodeURIComponent(task)}?at=${stamp.seconds.toFixed(1)}`} title="What was known then">{words}</a>}</span>
          ))} <span class="quiet">({size(box.size)})</span></p>
          <File {...box} />
        </div>
      ))}
      {recordings.map((each) => (
        <div key={each.file} class="record">
          <p><strong>Recording</strong> <span class="quiet">({size(each.size)})</span></p>
          <File {...each} />
        </div>
      ))}
      {!boxes.length && !recordings.length && <p class="quiet">{silent ? "No recorder answers, so records are not known. " : "No record has this task. "}A black box is kept when a task fails, a stop is set or a process dies. <code>tandem up --record</code> records everything.</p>}
    </section>
  );
}

function File({ command }: { command: string }) {
  const [copied, say] = useState(false);
  const copy = () => void navigator.clipboard.writeText(command).then(() => say(true), () => undefined);
  return (
    <p class="copied">
      <code>{command}</code>
      {navigator.clipboard && <button class="small" onClick={copy}>{copied ? "Copied" : "Copy"}</button>}
    </p>
  );
}
