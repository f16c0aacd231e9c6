// The room from above. What one chooses there, an item or a place, becomes a request.
import { useMemo } from "preact/hooks";
import { may, who } from "./acting";
import { useKinds, useRobot, useSite, type Kinds } from "./loading";
import { go } from "./route";
import { RADIUS, useLive } from "./state";
import type { Site } from "./types";
import { Others } from "./others";
import { KeyedList } from "./keyed";
import { called, named } from "./words";

type Chosen = { item?: string; depot?: string; x?: string; y?: string };

export function Map({ url }: { url: URL }) {
  const site = useSite();
  const robot = useRobot();
  const kinds = useKinds();
  const { x, y, ...other }: Chosen = Object.fromEntries(url.searchParams);
  const chosen: Chosen = [x, y].every((each) => each && Number.isFinite(Number(each))) ? { ...other, x, y } : other;
  if (!site.value) return <p class="quiet">{site.error || "Loading the place…"}</p>;
  return (
    <div class="map">
      <Room site={site.value} chosen={chosen} radius={robot.value?.footprint_radius ?? RADIUS} />
      <div class="side">
        <Offers site={site.value} kinds={kinds.value} chosen={chosen} />
        <Believed site={site.value} />
        <Others />
      </div>
    </div>
  );
}

function Room({ site, chosen, radius }: { site: Site; chosen: Chosen; radius: number }) {
  const pose = useLive((live) => live.pose);
  const path = useLive((live) => live.path);
  const robots = useLive((live) => live.robots);
  const trails = useLive((live) => live.trails);
  const people = useLive((live) => live.people);
  const scene = useLive((live) => live.scene);
  const [x0, y0, x1, y1] = site.bounds;
  const things = (scene?.objects ?? []).filter((each) => each.kind !== "furniture" && !each.attached_to);
  const pick = (event: MouseEvent) => {
    const svg = event.currentTarget as SVGSVGElement;
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
    go(`/map?x=${point.x.toFixed(2)}&y=${(-point.y).toFixed(2)}`, true);
  };
  const choose = (address: string) => ({
    role: "button", tabindex: 0, // in SVG it is an attribute, and not tabIndex
    onClick: (event: Event) => { event.stopPropagation(); go(address, true); },
    onKeyDown: (event: KeyboardEvent) => (event.key === "Enter" || event.key === " ") && (event.preventDefault(), go(address, true)),
  } as const);
  return (
    <svg class="room" viewBox={`${x0 - 0.2} ${-y1 - 0.2} ${x1 - x0 + 0.4} ${y1 - y0 + 0.4}`} onClick={pick} aria-label="Map of the place" role="group">
      <rect class="floor" x={x0} y={-y1} width={x1 - x0} height={y1 - y0} />
      {site.furniture.flatMap((piece) => piece.boxes.map((box, i) => (
        <rect key={`${piece.name}${i}`} class="furniture" x={-box.size[0] / 2} y={-box.size[1] / 2} width={box.size[0]} height={box.size[1]}
          transform={turned(box.centre[0], box.centre[1], box.yaw)}><title>{piece.name}</title></rect>
      )))}
      {Object.entries(trails).map(([name, trail]) => trail.length > 1 && <polyline key={name} class="other-path" points={trail.map(([x, y]) => `${x},${-y}`).join(" ")}><title>the way of {name}</title></polyline>)}
      {path.length > 1 && <polyline class="path" points={path.map(([x, y]) => `${x},${-y}`).join(" ")} />}
      {site.spots.map((spot) => (
        <g key={spot.name} class="spot" transform={turned(spot.pose.x, spot.pose.y, spot.pose.yaw)} aria-label={`spot ${spot.name}`}
          {...choose(`/map?x=${spot.pose.x.toFixed(2)}&y=${spot.pose.y.toFixed(2)}`)}><circle r={0.06} /><path d="M0.06 0 L0.16 0" /><title>{spot.name}</title></g>
      ))}
      {site.depots.map((depot) => (
        <g key={depot.name} class={`depot ${chosen.depot === depot.name ? "chosen" : ""}`} aria-label={`depot ${depot.name}`} {...choose(`/map?depot=${encodeURIComponent(depot.name)}`)}>
          {depot.slots.map((slot, i) => <circle key={i} cx={slot.position[0]} cy={-slot.position[1]} r={0.05} />)}
          {depot.slots[0] && <text x={mean(depot.slots.map((slot) => slot.position[0]!))} y={-Math.max(...depot.slots.map((slot) => slot.position[1]!)) - 0.1}>{depot.name}</text>}
        </g>
      ))}
      {things.map((each) => {
        const [x, y] = each.box.pose.position;
        const [, , z, w] = each.box.pose.orientation;
        const item = each.item === null ? {} : { "aria-label": `item ${called(site, each.item)}`, ...choose(`/map?item=${each.item}`) };
        return (
          <g key={each.name} class={`thing ${each.kind} ${each.item !== null && chosen.item === String(each.item) ? "chosen" : ""}`} {...item}>
            <rect x={-each.box.size[0] / 2} y={-each.box.size[1] / 2} width={each.box.size[0]} height={each.box.size[1]} rx={each.box.shape === "cylinder" ? each.box.size[0] / 2 : 0} transform={turned(x!, y!, 2 * Math.atan2(z!, w!))} />
            {each.item !== null && <text x={x} y={-y! - 0.09}>{named(site, each.item)}</text>}
          </g>
        );
      })}
      {Object.entries(robots).map(([name, told]) => told.at && (
        <g key={name} class={`other ${told.silent ? "lost" : ""}`} transform={turned(...told.at)} aria-label={`robot ${name}`}>
          <Base radius={told.size?.[0] ?? RADIUS} />
          <text transform={`rotate(${(told.at[2] * 180) / Math.PI})`} y={-(told.size?.[0] ?? RADIUS) - 0.06}>{name}</text>
        </g>
      ))}
      {Object.entries(people).map(([id, [x, y, vx, vy, size]]) => (
        <g key={id} class="person" transform={`translate(${x} ${-y})`} aria-label={`person ${id}`}>
          <circle r={size} /><path d={`M0 0 L${vx} ${-vy}`} /><title>a person{Math.hypot(vx, vy) > 0.1 ? `, ${Math.hypot(vx, vy).toFixed(1)} m/s` : ""}</title>
        </g>
      ))}
      {pose && (
        <g class={`me ${pose.localised ? "" : "lost"}`} transform={turned(pose.x, pose.y, pose.yaw)}>
          <Base radius={radius} />
        </g>
      )}
      {chosen.x && chosen.y && <path class="mark" transform={`translate(${Number(chosen.x)} ${-Number(chosen.y)})`} d="M-0.12 0 H0.12 M0 -0.12 V0.12" />}
    </svg>
  );
}

// A base from above, and where it looks.
const Base = ({ radius }: { radius: number }) => (
  <>
    <circle r={radius} />
    <path d={`M${radius * 0.45} ${-radius * 0.4} L${radius * 0.92} 0 L${radius * 0.45} ${radius * 0.4} Z`} />
  </>
);

const mean = (values: number[]) => values.reduce((sum, each) => sum + each, 0) / values.length;
const turned = (x: number, y: number, yaw: number) => `translate(${x} ${-y}) rotate(${(-yaw * 180) / Math.PI})`;

// The kinds of request that are about what was chosen, and that this robot can do.
function Offers({ site, kinds, chosen }: { site: Site; kinds: Kinds | null; chosen: Chosen }) {
  const offers = useMemo(() => {
    const found: [string, URLSearchParams][] = [];
    for (const kind of kinds?.kinds ?? []) {
      if (kinds!.unable[kind.name]) continue;
      const fields = (kind.request.properties ?? {}) as Record<string, unknown>;
      const given: Record<string, string> = {};
      if (chosen.item && "item" in fields) given.item = chosen.item;
      else if (chosen.depot && "to" in fields) given.to = chosen.depot;
      else if (chosen.x && chosen.y && "x" in fields && "y" in fields) Object.assign(given, { x: chosen.x, y: chosen.y });
      else continue;
      found.push([kind.name, new URLSearchParams({ task: kind.name, ...given })]);
    }
    return found;
  }, [kinds, chosen.item, chosen.depot, chosen.x, chosen.y]);
  const what = chosen.item ? `Item ${called(site, Number(chosen.item))}` : chosen.depot ? `Depot ${chosen.depot}` : chosen.x ? `Place ${chosen.x}, ${chosen.y} m` : "";
  return (
    <section class="card">
      <h2>{what || "Choose an item or a place"}</h2>
      {!what && <p class="quiet">Items and depots can be chosen with Tab and Enter, too. {site.items.length} items are known here.</p>}
      {what && !may("request") && <p class="quiet">{who()?.role === "replay" ? "A record takes no requests." : "This key does not allow requests."}</p>}
      {what && may("request") && (
        <p class="verbs">{offers.map(([name, query]) => <a key={name} class="button" href={`/request?${query}`}>{name}</a>)}</p>
      )}
      {what && may("request") && kinds && !offers.length && <p class="quiet">No kind of task is about that.</p>}
    </section>
  );
}

// What the robot believes, and how old that is.
function Believed({ site }: { site: Site | null }) {
  const world = useLive((live) => live.world);
  const now = useLive((live) => Math.floor(live.now?.seconds ?? 0));
  const boot = useLive((live) => live.now?.boot);
  const items = [...(world?.items ?? [])].sort((a, b) => a.item - b.item);
  return (
    <section class="card">
      <h2>Items believed <span class="count">{items.length}</span></h2>
      <KeyedList empty="No item has been seen yet." rows={items.map((fact) => {
        const placed = world!.placed.find((each) => each.item === fact.item);
        const where = fact.held ? `in the ${fact.held} hand` : placed ? `in ${placed.depot}, slot ${placed.slot}`
          : `at ${fact.tag_in_map.position.map((each) => (each ?? 0).toFixed(2)).join(", ")}`;
        const age = !boot ? "" : fact.seen.boot === boot ? `seen ${Math.max(0, now - Math.floor(fact.seen.seconds))} s ago` : "seen before the last start";
        return [String(fact.item), <><a href={`/map?item=${fact.item}`}>{called(site, fact.item)}</a> {where} <span class="quiet">{age}</span></>];
      })} />
    </section>
  );
}
