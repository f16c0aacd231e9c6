// The robot and its room in 3D. Drawn only when something has changed: software GL would eat a core otherwise.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { CSS2DObject, CSS2DRenderer } from "three/examples/jsm/renderers/CSS2DRenderer.js";
import URDFLoader, { type URDFRobot } from "urdf-loader";
import { cubes } from "./cubes";
import { Drawing } from "./drawing";
import { label, spread, write } from "./labels";
import { type Live, RADIUS } from "./state";
import type { Box, RobotDescription, Site } from "./types";
import { named } from "./words";

const KINDS = { furniture: 0xb9b2a6, clutter: 0xc98a5a, item: 0x3f7fbf };
// Seen through the arm that moves along it.
const REACHING = new THREE.LineDashedMaterial({ color: 0xb8267a, dashSize: 0.03, gapSize: 0.015, depthTest: false, transparent: true });
const REACHED = new THREE.MeshBasicMaterial({ color: 0xb8267a, depthTest: false, transparent: true, opacity: 0.8 });
const PERSON = 0x0f8a8a;
const OTHER = 0x8a6fb0;
const TALL = 1.7; // m, a grown-up: the laser does not see how tall
type Picked = (what: { item?: number; x: number; y: number }) => void;

export class RobotScene {
  private renderer: THREE.WebGLRenderer;
  private labels = new CSS2DRenderer();
  private scene = new THREE.Scene();
  private camera = new THREE.PerspectiveCamera(45, 1, 0.05, 100);
  private drawing: Drawing;
  private seen = new THREE.PerspectiveCamera(); // from where the picture under way is seen
  private size = { width: 0, height: 0 };
  private complete = false; // whether all of the robot is there, and whether the picture under way has it
  private whole = false;
  private controls: OrbitControls;
  private robot: URDFRobot | null = null;
  private base = new THREE.Group();
  private room = new THREE.Group();
  private things = new THREE.Group();
  private others = new THREE.Group();
  private people = new THREE.Group();
  private held: THREE.Object3D[] = [];
  private gone: Element[] = []; // names of what is drawn no more, until the next picture has the others
  private path = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x2f8f6f }));
  private plan = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineDashedMaterial({ color: 0x1257c8, dashSize: 0.1, gapSize: 0.06 }));
  private hands = new THREE.Group();
  private scan = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ color: 0xd0402f, size: 0.03 }));
  private occupied = new THREE.Group();
  private shown: Partial<Live> = {};
  private dirty = true;
  private over = false;
  private description: RobotDescription | null = null;
  private site: Site | null = null;
  private watch: ResizeObserver;
  frames = 0;

  constructor(private box: HTMLElement, private picked: Picked) {
    this.renderer = new THREE.WebGLRenderer({ antialias: false, depth: false, powerPreference: "low-power" }); // pictures are drawn beside it
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.drawing = new Drawing(this.renderer);
    this.labels.domElement.className = "labels";
    box.append(this.renderer.domElement, this.labels.domElement);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.maxPolarAngle = Math.PI / 2;
    this.controls.addEventListener("change", () => this.touch());
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8a80, 2.2), this.base, this.room, this.things, this.others, this.people, this.occupied, this.path, this.plan, this.scan);
    const sun = new THREE.DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 6);
    this.scene.add(sun);
    this.base.add(this.hands); // their ways are told in its frame
    this.path.frustumCulled = this.plan.frustumCulled = this.scan.frustumCulled = false;
    this.renderer.domElement.addEventListener("dblclick", (event) => this.pick(event));
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(box);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", this.paint);
    this.paint();
    this.look("side");
    const draw = () => {
      if (this.over) return;
      requestAnimationFrame(draw);
      if (this.drawing.show()) return this.name(); // the next picture begins after this one is on the screen, or it would be waited for
      if (!this.dirty || this.drawing.busy || !this.size.width) return;
      this.dirty = false;
      this.seen.copy(this.camera);
      this.whole = this.complete;
      this.drawing.begin(this.scene, this.seen, this.size);
    };
    draw();
  }

  // What is shown has its names, and says of itself what it is.
  private name() {
    this.frames += 1;
    this.labels.render(this.scene, this.seen);
    for (const each of this.gone.splice(0)) each.remove();
    spread(this.scene, this.seen, this.size.width, this.size.height);
    this.box.dataset.frames = String(this.frames);
    if (this.whole) this.box.dataset.robot = "loaded";
    this.box.dataset.shapes = String(this.renderer.info.memory.geometries);
    this.box.dataset.latest = String(!this.dirty); // names are as of now; the picture is as of when it was begun
  }

  close() {
    this.over = true;
    this.watch.disconnect();
    this.controls.dispose();
    this.drawing.close();
    this.renderer.dispose();
    this.box.replaceChildren();
  }

  // A point of one frame of the robot in another, by its joints as they are; null: the robot has no such frame.
  carry(from: string, to: string, point: readonly [number, number, number]): readonly [number, number, number] | null {
    const [one, other] = [this.robot?.frames[from], this.robot?.frames[to]];
    if (!one || !other) return null;
    for (const each of [one, other]) each.updateWorldMatrix(true, false);
    return other.worldToLocal(one.localToWorld(new THREE.Vector3(...point))).toArray();
  }

  touch() {
    this.dirty = true;
    this.box.dataset.latest = "false";
  }

  private paint = () => {
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    this.scene.background = new THREE.Color(dark ? 0x1b1f24 : 0xe9ecef);
    this.touch();
  };

  look(from: "side" | "above") {
    const { x, y } = this.base.position;
    if (from === "above") this.camera.position.set(x, y - 0.01, 8);
    else this.camera.position.set(x - 3.0, y - 2.6, 2.6);
    this.controls.target.set(x + (from === "side" ? 0.3 : 0), y, from === "side" ? 0.6 : 0);
    this.controls.update();
    this.touch();
  }

  private resize() {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (!width || !height) return;
    this.size = { width, height };
    this.labels.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.touch();
  }

  setRobot(description: RobotDescription) {
    if (this.description?.urdf === description.urdf) return;
    this.description = description;
    const manager = new THREE.LoadingManager(() => this.loaded());
    manager.onError = (url) => console.warn("missing", url);
    const loader = new URDFLoader(manager);
    loader.packages = (name) => `/mesh/${name}`;
    loader.parseCollision = false;
    const robot = loader.parse(description.urdf);
    if (this.robot) this.base.remove(this.robot);
    // The pose is that of the base's frame, wherever the URDF has its root.
    this.robot = robot;
    this.base.add(robot);
    this.shown = {};
    if (!/<mesh/.test(description.urdf)) this.loaded();
    this.touch();
  }

  private loaded() {
    this.complete = true;
    this.touch();
  }

  setSite(site: Site) {
    this.site = site;
    if (this.shown.scene) this.place(this.shown as Live); // its items have their names now
    discard(this.room, this.gone);
    this.room.clear();
    const [x0, y0, x1, y1] = site.bounds;
    const floor = new THREE.Mesh(
      new THREE.PlaneGeometry(x1 - x0, y1 - y0),
      new THREE.MeshLambertMaterial({ color: 0xd9d6cd }),
    );
    floor.position.set((x0 + x1) / 2, (y0 + y1) / 2, -0.002);
    floor.name = "floor";
    const grid = new THREE.GridHelper(Math.ceil(Math.max(x1 - x0, y1 - y0)), Math.ceil(Math.max(x1 - x0, y1 - y0)), 0xa8a498, 0xc4c0b5);
    grid.rotation.x = Math.PI / 2;
    grid.position.set(floor.position.x, floor.position.y, 0);
    this.room.add(floor, grid);
    for (const piece of site.furniture) {
      const wall = /^wall/.test(piece.name);
      for (const each of piece.boxes) {
        const colour = new THREE.Color(...(piece.colour as [number, number, number]));
        const height = wall ? Math.min(each.size[2], 0.25) : each.size[2];
        const mesh = boxMesh([each.size[0], each.size[1], height], colour, wall ? 0.6 : 1);
        mesh.position.set(each.centre[0], each.centre[1], each.centre[2] - (each.size[2] - height) / 2);
        mesh.rotation.z = each.yaw;
        this.room.add(mesh);
      }
    }
    for (const depot of site.depots) {
      for (const slot of depot.slots) {
        const ring = new THREE.Mesh(new THREE.RingGeometry(0.035, 0.045, 24), new THREE.MeshBasicMaterial({ color: 0x2f6f4f, side: THREE.DoubleSide }));
        ring.position.set(slot.position[0], slot.position[1], slot.position[2] + 0.003);
        this.room.add(ring);
      }
      const first = depot.slots[0];
      if (first) this.room.add(label(depot.name, "place", first.position[0], first.position[1], first.position[2] + 0.12));
    }
    this.touch();
  }

  show(live: Live) {
    if (live.joints !== this.shown.joints && this.robot) {
      for (const [name, position] of Object.entries(live.joints)) this.robot.setJointValue(name, position);
      this.touch();
    }
    if (live.pose !== this.shown.pose && live.pose) {
      const first = !this.shown.pose && this.base.position.lengthSq() === 0;
      this.base.position.set(live.pose.x, live.pose.y, 0);
      this.base.rotation.z = live.pose.yaw;
      if (first) this.look("side");
      this.touch();
    }
    if (live.scene !== this.shown.scene || live.world !== this.shown.world || live.now?.boot !== this.shown.now?.boot) this.place(live);
    else if (live.now?.seconds != null && Math.floor(live.now.seconds) !== Math.floor(this.shown.now?.seconds ?? -1)) this.age(live);
    if (live.path !== this.shown.path) this.draw(this.path, live.path, 0.012);
    if (live.plan !== this.shown.plan) {
      this.draw(this.plan, live.plan, 0.02);
      this.plan.computeLineDistances();
      this.box.dataset.plan = String(live.plan.length);
    }
    if (live.hands !== this.shown.hands) this.reach(live.hands);
    if (live.robots !== this.shown.robots || live.trails !== this.shown.trails) this.placeOthers(live.robots, live.trails);
    if (live.people !== this.shown.people) this.placePeople(live.people);
    if (live.occupied !== this.shown.occupied) this.fill(live.occupied);
    if (live.lasers !== this.shown.lasers) this.beams(live.lasers);
    this.shown = live;
  }

  // Where each hand will be: a line, and a ball where it will end.
  private reach(hands: Live["hands"]) {
    for (const each of this.hands.children) (each as THREE.Mesh).geometry.dispose();
    this.hands.clear();
    const ways = Object.values(hands).filter((way) => way.length > 1);
    for (const way of ways) {
      const corners = way.map((corner) => new THREE.Vector3(...corner));
      const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(corners), REACHING);
      const ball = new THREE.Mesh(new THREE.SphereGeometry(0.025, 16, 12), REACHED);
      ball.position.copy(corners.at(-1)!);
      line.computeLineDistances();
      line.renderOrder = ball.renderOrder = 1;
      this.hands.add(line, ball);
    }
    this.box.dataset.hands = String(ways.length);
    this.touch();
  }

  // Of another robot its place and its size are told: a drum with its name, and a nose that says where it looks.
  private placeOthers(robots: Live["robots"], trails: Live["trails"]) {
    discard(this.others, this.gone);
    this.others.clear();
    for (const trail of Object.values(trails)) {
      const way = new THREE.BufferGeometry().setFromPoints(trail.map(([x, y]) => new THREE.Vector3(x, y, 0.012)));
      const line = new THREE.Line(way, new THREE.LineDashedMaterial({ color: OTHER, dashSize: 0.08, gapSize: 0.05 }));
      line.computeLineDistances();
      this.others.add(line);
    }
    for (const [name, { at, silent, size }] of Object.entries(robots)) {
      if (!at) continue;
      const colour = new THREE.MeshLambertMaterial({ color: OTHER, transparent: true, opacity: silent ? 0.3 : 0.75 });
      const [radius, height] = [size?.[0] ?? RADIUS, size?.[1] ?? 0.5];
      const drum = new THREE.Mesh(new THREE.CylinderGeometry(radius, radius, height, 32), colour);
      const nose = new THREE.Mesh(new THREE.BoxGeometry(0.2, 0.06, 0.06), colour);
      drum.rotation.x = Math.PI / 2;
      drum.position.z = height / 2;
      nose.position.set(radius + 0.05, 0, height * 0.75);
      const robot = new THREE.Group();
      robot.add(drum, nose, label(silent ? `${name} · silent` : name, silent ? "old" : "item", 0, 0, height + 0.2));
      robot.position.set(at[0], at[1], 0);
      robot.rotation.z = at[2];
      this.others.add(robot);
    }
    this.touch();
  }

  // A column for each person, as wide as the base takes them to be, and where they will be in a second.
  private placePeople(people: Live["people"]) {
    discard(this.people, this.gone);
    this.people.clear();
    for (const [x, y, vx, vy, radius] of Object.values(people)) {
      const column = new THREE.Mesh(new THREE.CylinderGeometry(radius, radius, TALL, 32), new THREE.MeshLambertMaterial({ color: PERSON, transparent: true, opacity: 0.4 }));
      column.rotation.x = Math.PI / 2;
      column.position.z = TALL / 2;
      const ahead = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(0, 0, 0.03), new THREE.Vector3(vx, vy, 0.03)]);
      const person = new THREE.Group();
      person.add(column, new THREE.Line(ahead, new THREE.LineBasicMaterial({ color: PERSON })));
      person.position.set(x, y, 0);
      this.people.add(person);
    }
    this.box.dataset.people = String(this.people.children.length);
    this.touch();
  }

  private fill(occupied: Live["occupied"]) {
    for (const each of this.occupied.children) (each as THREE.InstancedMesh).dispose();
    this.occupied.clear();
    const mesh = occupied && cubes(occupied);
    if (mesh) this.occupied.add(mesh);
    this.box.dataset.occupied = String(mesh?.count ?? 0);
    this.touch();
  }

  showOccupied(yes: boolean) {
    this.occupied.visible = yes;
    this.touch();
  }

  private draw(line: THREE.Line, corners: [number, number][], height: number) {
    line.geometry.dispose();
    line.geometry = new THREE.BufferGeometry();
    line.geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners.flatMap(([x, y]) => [x, y, height]), 3));
    this.touch();
  }

  private beams(lasers: Live["lasers"]) {
    const points: number[] = [];
    const point = new THREE.Vector3();
    for (const sensor of this.description?.lasers ?? []) {
      const frame = this.robot?.frames[sensor.frame];
      if (!frame) continue;
      frame.updateWorldMatrix(true, false);
      (lasers[sensor.name] ?? []).forEach((range, i) => {
        if (range >= sensor.range_max) return;
        const angle = sensor.angle_min + i * sensor.angle_step;
        point.set(range * Math.cos(angle), range * Math.sin(angle), 0).applyMatrix4(frame.matrixWorld);
        points.push(point.x, point.y, point.z);
      });
    }
    this.box.dataset.beams = String(points.length / 3);
    this.scan.geometry.dispose();
    this.scan.geometry = new THREE.BufferGeometry();
    this.scan.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    this.touch();
  }

  // Items as they are believed, and what else stands in the planning scene; what is held hangs on its hand.
  private place(live: Live) {
    for (const each of [this.things, ...this.held]) discard(each, this.gone);
    this.things.clear();
    for (const each of this.held) each.removeFromParent();
    this.held = [];
    for (const each of live.scene?.objects ?? []) {
      if (each.kind === "furniture") continue;
      const mesh = solidMesh(each.box, new THREE.Color(KINDS[each.kind]), each.kind === "clutter" ? 0.5 : 1);
      pose(mesh, each.box);
      if (each.item !== null) {
        mesh.userData.item = each.item;
        const tag = label(named(this.site, each.item), "item", 0, 0, each.box.size[2] / 2 + 0.06);
        tag.userData.item = each.item;
        mesh.add(tag);
      }
      const hand = each.attached_to && this.description?.end_effectors.find((one) => one.side === each.attached_to);
      const frame = hand && this.robot?.frames[hand.frame];
      if (frame) {
        frame.add(mesh);
        this.held.push(mesh);
      } else this.things.add(mesh);
    }
    this.age(live);
  }

  private age(live: Live) {
    const facts = new Map((live.world?.items ?? []).map((fact) => [fact.item, fact]));
    const date = (each: THREE.Object3D) => {
      if (!(each instanceof CSS2DObject)) return;
      const fact = facts.get(each.userData.item);
      if (!fact) return;
      const same = live.now?.seconds != null && fact.seen.boot === live.now.boot;
      const old = same ? live.now!.seconds! - fact.seen.seconds : null;
      const name = named(this.site, fact.item);
      write(each, fact.held ? `${name} · held` : `${name}${old === null ? (live.now ? " · old" : "") : old < 2 ? "" : ` · ${old < 90 ? `${old.toFixed(0)} s` : `${(old / 60).toFixed(0)} min`}`}`);
      each.element.classList.toggle("old", !fact.held && live.now !== null && (old === null || old > 60));
    };
    this.things.traverse(date);
    for (const each of this.held) each.traverse(date);
    this.touch();
  }

  private pick(event: MouseEvent) {
    const { left, top, width, height } = this.renderer.domElement.getBoundingClientRect();
    const at = new THREE.Vector2(((event.clientX - left) / width) * 2 - 1, 1 - ((event.clientY - top) / height) * 2);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.camera);
    const [hit] = ray.intersectObjects([...this.things.children, ...this.room.children.filter((each) => each.name === "floor")], false);
    if (hit) this.picked({ item: hit.object.userData.item, x: hit.point.x, y: hit.point.y });
  }
}

function boxMesh(size: readonly number[], colour: THREE.Color, opacity: number) {
  return meshOf(new THREE.BoxGeometry(size[0], size[1], size[2]), colour, opacity);
}

// A robot of an older release tells no shape: all is a box to it.
function solidMesh(box: Box, colour: THREE.Color, opacity: number) {
  const [x, y, z] = box.size;
  if (box.shape !== "cylinder") return boxMesh(box.size, colour, opacity);
  const upright = new THREE.CylinderGeometry(x / 2, y / 2, z, 32).rotateX(Math.PI / 2); // three's stands along y
  return meshOf(upright, colour, opacity);
}

function meshOf(geometry: THREE.BufferGeometry, colour: THREE.Color, opacity: number) {
  const material = new THREE.MeshLambertMaterial({ color: colour, opacity, transparent: opacity < 1 });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 30), new THREE.LineBasicMaterial({ color: 0x555550, transparent: true, opacity: 0.45 })));
  return mesh;
}

// What is drawn no more: a name's element stays in the document, and shapes stay on the graphics card, unless they
// are taken out. Names go with the next picture: without any until then, they would flicker.
function discard(object: THREE.Object3D, gone: Element[]) {
  object.traverse((each) => {
    if (each instanceof CSS2DObject) gone.push(each.element);
    const { geometry, material } = each as Partial<THREE.Mesh>;
    geometry?.dispose();
    for (const one of material ? [material].flat() : []) one.dispose();
  });
}

function pose(object: THREE.Object3D, box: Box) {
  object.position.set(...(box.pose.position as [number, number, number]));
  object.quaternion.set(...(box.pose.orientation as [number, number, number, number]));
}
