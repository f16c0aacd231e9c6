// A record plays: the moment, and how fast. All who look at this page's server see the same moment.
import { useState } from "preact/hooks";
import { act } from "./acting";
import { post } from "./api";
import { useLive, type Replayed } from "./state";
import { clock } from "./words";

const SPEEDS = [0.25, 0.5, 1, 2, 4, 16];
export const move = (document: { at?: number; seconds?: number; speed?: number }) => act(() => post("/api/replay", document), "");

export function ReplayBar() {
  const replay = useLive((live) => live.replay);
  if (!replay) return null;
  return <Bar replay={replay} />;
}

function Bar({ replay }: { replay: Replayed }) {
  const [held, hold] = useState<number | null>(null); // while the slider is drawn
  const [before, keep] = useState(1); // the speed to go on with
  const { begin, end, cause } = replay;
  const at = held ?? replay.at;
  const stands = replay.speed === 0 || replay.at >= end;
  const toggle = () => {
    if (!stands) {
      keep(replay.speed);
      void move({ speed: 0 });
    } else void move({ speed: replay.speed || before, ...(replay.at >= end ? { at: begin } : {}) });
  };
  const share = (value: number) => `${(100 * (value - begin)) / Math.max(end - begin, 0.001)}%`;
  return (
    <section class="replay" aria-label="Replay">
      <button onClick={toggle} aria-label={stands ? "Play" : "Stand still"}>{stands ? "▶" : "‖"}</button>
      <span class="slider">
        <input type="range" min={begin} max={end} step={0.1} value={at} aria-label="Moment" aria-valuetext={clock(at - begin)}
          onInput={(event) => hold(Number(event.currentTarget.value))}
          onChange={(event) => { const to = Number(event.currentTarget.value); void move({ at: to }).then(() => hold(null)); }} />
        {cause && <span class="cause" style={{ left: share(cause.at) }} title={cause.words} aria-hidden="true">▲</span>}
      </span>
      <span class="number">{clock(at - begin)} of {clock(end - begin)}</span>
      <label>speed <select value={String(replay.speed || before)} onChange={(event) => { keep(Number(event.currentTarget.value)); void move({ speed: Number(event.currentTarget.value) }); }}>
        {SPEEDS.map((each) => <option key={each} value={String(each)}>{each} ×</option>)}
      </select></label>
      <span class="quiet">recorded {new Date((replay.began + at) * 1000).toLocaleString()}{cause && `; kept because ${cause.words}`}</span>
    </section>
  );
}
