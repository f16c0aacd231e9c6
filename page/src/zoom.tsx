// How large a tree is drawn: in the steps that browsers take, one for all trees of this browser.
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";

const WHERE = "tandem.zoom";
const STEPS = [50, 67, 80, 90, 100, 110, 125, 150, 175, 200]; // per cent
const PLAIN = 100;
const NOTCH = 50; // pixels of the wheel for a step: a mouse tells 100 or more a notch, two fingers a few at a time
let last = PLAIN; // what the page was set to, where the browser keeps nothing

function read(): number {
  try {
    const kept = Number(localStorage.getItem(WHERE));
    return STEPS.includes(kept) ? kept : last;
  } catch {
    return last;
  }
}

function write(percent: number) {
  last = percent;
  try {
    localStorage.setItem(WHERE, String(percent));
  } catch { /* it lasts until the page is closed */ }
  dispatchEvent(new Event("zoomed"));
}

export type List = { current: HTMLUListElement | null };
export type Zoom = { percent: number; turn: (steps: number) => void; reset: () => void };

// The row under the pointer, or else the one that has the keyboard, stays where it is on the screen.
export function useZoom(list: List): Zoom {
  const [percent, set] = useState(read);
  const held = useRef<{ row: Element; top: number } | null>(null);
  const to = (next: number) => {
    const row = list.current?.querySelector(":scope > :hover") ?? list.current?.querySelector(":scope > :focus");
    held.current = row ? { row, top: row.getBoundingClientRect().top } : null;
    write(next);
  };
  useLayoutEffect(() => {
    if (held.current) scrollBy(0, held.current.row.getBoundingClientRect().top - held.current.top);
    held.current = null;
  }, [percent]);
  useEffect(() => {
    const again = () => set(read());
    for (const event of ["zoomed", "storage"]) addEventListener(event, again);
    return () => ["zoomed", "storage"].forEach((event) => removeEventListener(event, again));
  }, []);
  const turn = (steps: number) => to(STEPS[Math.max(0, Math.min(STEPS.length - 1, STEPS.indexOf(read()) + steps))]!);
  return { percent, turn, reset: () => to(PLAIN) };
}

// What + - and 0 do in a tree. With Ctrl they are the browser's, for the whole page.
export function zoomKeys({ turn, reset }: Zoom): Record<string, () => void> {
  return { "+": () => turn(1), "=": () => turn(1), "-": () => turn(-1), "0": reset };
}

// Ctrl and the wheel, or two fingers that part: a step for each notch.
export function useWheel({ turn }: Zoom) {
  const [gone] = useState({ by: 0 });
  return (event: WheelEvent) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    gone.by += event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY : NOTCH * Math.sign(event.deltaY);
    if (Math.abs(gone.by) < NOTCH) return;
    turn(gone.by < 0 ? 1 : -1);
    gone.by = 0;
  };
}

export function ZoomButtons({ zoom: { percent, turn, reset } }: { zoom: Zoom }) {
  return (
    <span class="zoom" role="group" aria-label="Size of the tree">
      <button class="small" aria-label="Smaller" title="Smaller (−, or Ctrl and the wheel)" aria-keyshortcuts="-" disabled={percent === STEPS[0]} onClick={() => turn(-1)}>−</button>
      <button class="small percent" aria-label={`${percent} %: back to ${PLAIN} %`} title={`Back to ${PLAIN} % (0)`} aria-keyshortcuts="0" onClick={reset}>{percent} %</button>
      <button class="small" aria-label="Larger" title="Larger (+, or Ctrl and the wheel)" aria-keyshortcuts="+" disabled={percent === STEPS.at(-1)} onClick={() => turn(1)}>+</button>
    </span>
  );
}
