// The cells of occupied space as instances of one cube, the higher the lighter: one draw call for 10,000 of them.
import * as THREE from "three";
import type { Occupied } from "./state";

const LOW = new THREE.Color(0xa06ab0);
const HIGH = new THREE.Color(0xf2c25e);
const TOP = 1.6; // metres above the floor from which on a cube has the lightest colour
const GAP = 0.92; // share of a cell that its cube fills, so that cells can be told apart

export function cubes({ origin, shape, resolution, cells }: Occupied): THREE.InstancedMesh | null {
  const numbers = unpacked(cells);
  if (!numbers.length) return null;
  const edge = resolution * GAP;
  const mesh = new THREE.InstancedMesh(new THREE.BoxGeometry(edge, edge, edge), new THREE.MeshLambertMaterial(), numbers.length);
  const [nx, ny] = shape;
  const at = new THREE.Matrix4();
  const colour = new THREE.Color();
  numbers.forEach((number, i) => {
    const row = Math.floor(number / nx);
    const z = origin[2] + (Math.floor(row / ny) + 0.5) * resolution;
    at.setPosition(origin[0] + ((number % nx) + 0.5) * resolution, origin[1] + ((row % ny) + 0.5) * resolution, z);
    mesh.setMatrixAt(i, at);
    mesh.setColorAt(i, colour.lerpColors(LOW, HIGH, Math.min(1, Math.max(0, z / TOP))));
  });
  return mesh;
}

// Little-endian 32-bit numbers in base64, as ``world/occupancy`` has them.
function unpacked(cells: string): Uint32Array {
  const bytes = Uint8Array.from(atob(cells), (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Uint32Array.from({ length: bytes.length / 4 }, (_, i) => view.getUint32(4 * i, true));
}
