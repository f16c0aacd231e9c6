// Names in the 3D view that do not lie on each other: of two, the farther one is lifted, with a thread to its thing.
import * as THREE from "three";
import { CSS2DObject } from "three/examples/jsm/renderers/CSS2DRenderer.js";

type Size = { width: number; height: number };
type Spot = Size & { x: number; y: number; depth: number };
const APART = 1; // px between two
const sizes = new WeakMap<HTMLElement, Size & { words: string }>();

export function label(words: string, kind: string, x: number, y: number, z: number) {
  const element = document.createElement("span");
  const inner = document.createElement("span");
  element.className = `label ${kind}`;
  element.append(inner);
  const made = new CSS2DObject(element);
  made.position.set(x, y, z);
  write(made, words);
  return made;
}

export function write(tag: CSS2DObject, words: string) {
  tag.element.firstElementChild!.textContent = words;
}

// After they were placed where their things are.
export function spread(scene: THREE.Scene, camera: THREE.Camera, width: number, height: number) {
  const shown: { element: HTMLElement; spot: Spot }[] = [];
  const at = new THREE.Vector3();
  scene.traverseVisible((each) => {
    if (!(each instanceof CSS2DObject) || each.element.style.display === "none") return;
    at.setFromMatrixPosition(each.matrixWorld).project(camera);
    shown.push({ element: each.element, spot: { ...sized(each.element), x: ((at.x + 1) / 2) * width, y: ((1 - at.y) / 2) * height, depth: at.z } });
  });
  lifts(shown.map((each) => each.spot)).forEach((by, i) => shown[i]!.element.style.setProperty("--lift", `${by}px`));
}

// How far each is lifted (px), so that none lies on another; the nearest stay where they are.
export function lifts(spots: Spot[]): number[] {
  const lifted = spots.map(() => 0);
  const placed: Spot[] = [];
  const nearest = spots.map((_, i) => i).sort((a, b) => spots[a]!.depth - spots[b]!.depth);
  for (const i of nearest) {
    const spot = { ...spots[i]! };
    for (;;) {
      const under = placed.find((other) => touch(spot, other));
      if (!under) break;
      spot.y = under.y - (under.height + spot.height) / 2 - APART;
    }
    lifted[i] = Math.round(spots[i]!.y - spot.y);
    placed.push(spot);
  }
  return lifted;
}

const touch = (one: Spot, other: Spot) =>
  Math.abs(one.x - other.x) < (one.width + other.width) / 2 && Math.abs(one.y - other.y) < (one.height + other.height) / 2;

// Measured when its words change: measuring makes the browser lay out the page.
function sized(element: HTMLElement): Size {
  const words = element.className + element.textContent;
  let size = sizes.get(element);
  if (size?.words !== words) {
    size = { words, width: element.offsetWidth, height: element.offsetHeight };
    sizes.set(element, size);
  }
  return size;
}
