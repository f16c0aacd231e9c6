// What a camera sees, with the items that perception has found. Asked for only while it is open and in view.
import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";
import { picture } from "./api";
import { useRobot, useSite } from "./loading";
import { mark } from "./route";
import { useLive, type Tags } from "./state";
import type { CameraSensor } from "./types";
import { named } from "./words";

const EVERY = 1000;
const NEAREST = 0.01; // m before the camera; what is behind it is not in its picture
const FRESH = 3; // robot seconds for which an item is drawn where it was seen
const FACE = 0.8; // share of the edge of an untagged item that is outlined: what a tag would take, as the site has it

// Where a tag that one camera has seen is for another one, both of them where the robot has them now; null: not known.
export type Carry = (from: CameraSensor, to: CameraSensor, point: readonly [number, number, number]) => readonly [number, number, number] | null;

// The camera of that name, or the first: with that one perception looks, so that the tags are as it saw them.
export function Camera({ name, carry }: { name: string; carry: Carry }) {
  const cameras = useRobot().value?.cameras;
  if (!cameras?.length) return null;
  const sensor = cameras.find((each) => each.name === name) ?? cameras[0]!;
  const choice = cameras.length > 1 && (
    <select aria-label="Camera" value={sensor.name} onChange={(event) => mark("camera", event.currentTarget.value)}>
      {cameras.map((each) => <option key={each.name} value={each.name}>{each.name}</option>)}
    </select>
  );
  return <View key={sensor.name} sensor={sensor} looks={cameras[0]!} carry={carry}>{choice}</View>;
}

type Given = { sensor: CameraSensor; looks: CameraSensor; carry: Carry };

function View({ sensor, looks, carry, children }: Given & { children: ComponentChildren }) {
  const [shown, show] = useState<{ url: string; came: number } | null>(null);
  const [error, fail] = useState("");
  const [now, tick] = useState(performance.now());
  useEffect(() => {
    let over = false;
    let timer = 0;
    let last = "";
    const look = async () => {
      if (!document.hidden) {
        try {
          const { blob, age } = await picture(`/api/camera?name=${encodeURIComponent(sensor.name)}`);
          if (over) return;
          URL.revokeObjectURL(last);
          last = URL.createObjectURL(blob);
          show({ url: last, came: performance.now() - age * 1000 });
          fail("");
        } catch (wrong) {
          if (over) return;
          fail(wrong instanceof Error ? wrong.message : String(wrong));
        }
        tick(performance.now());
      }
      timer = setTimeout(look, EVERY);
    };
    void look();
    return () => {
      over = true;
      clearTimeout(timer);
      URL.revokeObjectURL(last);
    };
  }, []);
  const age = shown ? Math.max(0, (now - shown.came) / 1000) : null;
  return (
    <figure class="camera">
      {shown ? <span class="shot"><img src={shown.url} alt={`What the camera ${sensor.name} sees`} /><Found sensor={sensor} looks={looks} carry={carry} /></span>
        : <p class="quiet">{children}{error || "Asking for a picture…"}</p>}
      {shown && <figcaption>{children}{error ? `${error}; this one is ${age!.toFixed(0)} s old` : `${age! < 1.5 ? "now" : `${age!.toFixed(0)} s old`}`}<Seen by={sensor === looks ? "" : looks.name} /></figcaption>}
    </figure>
  );
}

function useTags(): { tags: Tags | null; age: number | null } {
  const tags = useLive((live) => live.tags);
  const now = useLive((live) => live.now);
  const same = tags && now?.seconds != null && tags.stamp.boot === now.boot;
  return { tags, age: same ? Math.max(0, now.seconds! - tags.stamp.seconds) : null };
}

function Seen({ by }: { by: string }) {
  const { tags, age } = useTags();
  const site = useSite().value;
  if (!tags?.seen.length || age === null) return <span class="quiet"> · no item seen yet</span>;
  return <span class="quiet"> · {tags.seen.length > 1 ? "items" : "item"} {tags.seen.map((each) => named(site, each.item)).join(", ")} seen {by && `by ${by} `}{age < 1 ? "now" : `${age.toFixed(0)} s ago`}</span>;
}

// The outlines of tags, or of faces as large, by a pinhole camera, in its optical frame: z forward, x to the right, y down. In the picture of
// another camera than that which perception looks with they are dashed: something may stand before them.
function Found({ sensor, looks, carry }: Given) {
  const { tags, age } = useTags();
  const site = useSite().value;
  if (!tags || age === null || age > FRESH) return null;
  const focal = sensor.width / 2 / Math.tan(sensor.horizontal_fov / 2);
  return (
    <svg viewBox={`0 0 ${sensor.width} ${sensor.height}`} aria-hidden="true">
      {tags.seen.map((each, i) => {
        const item = site?.items.find((one) => one.item === each.item);
        const half = (item?.tag_size ?? FACE * Math.min(...(item?.size ?? [0.06]))) / 2;
        const corners = [[-half, -half], [half, -half], [half, half], [-half, half]].map(([x, y]) => {
          const [px, py, pz] = turned(each.tag.orientation, [x!, y!, 0]);
          const [tx, ty, tz] = each.tag.position;
          const seen = [tx + px, ty + py, tz + pz] as const;
          const [cx, cy, cz] = (sensor === looks ? seen : carry(looks, sensor, seen)) ?? [0, 0, -1];
          return cz < NEAREST ? null : [sensor.width / 2 + (focal * cx) / cz, sensor.height / 2 + (focal * cy) / cz] as const;
        }).filter((each) => each !== null);
        if (corners.length < 4 || !corners.some(([u, v]) => u >= 0 && v >= 0 && u <= sensor.width && v <= sensor.height)) return null;
        const top = corners.reduce((one, other) => (other[1] < one[1] ? other : one));
        return (
          <g key={i} class={sensor === looks ? "" : "guessed"}>
            <polygon points={corners.map((each) => each.join(",")).join(" ")} />
            <text x={top[0]} y={top[1] - sensor.height / 60} font-size={sensor.height / 20}>{named(site, each.item)}</text>
          </g>
        );
      })}
    </svg>
  );
}

function turned([x, y, z, w]: readonly number[], [a, b, c]: readonly number[]): [number, number, number] {
  const [ux, uy, uz] = [2 * (y! * c! - z! * b!), 2 * (z! * a! - x! * c!), 2 * (x! * b! - y! * a!)];
  return [a! + w! * ux + y! * uz - z! * uy, b! + w! * uy + z! * ux - x! * uz, c! + w! * uz + x! * uy - y! * ux];
}
