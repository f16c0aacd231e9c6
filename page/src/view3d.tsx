// The 3D view in the page; where there is no WebGL, it says so and the map stays.
import { useEffect, useRef, useState } from "preact/hooks";
import { Camera } from "./camera";
import { useRobot, useSite } from "./loading";
import { go, mark, useRoute } from "./route";
import { RobotScene } from "./scene";
import { clearPath, current, listen, useLive, type Live } from "./state";

// As it is now, or as it was `then`; a small one stands beside other things and has no camera.
export function View3d({ then, small = false }: { then?: Live; small?: boolean }) {
  const shown = useRef(then);
  shown.current = then;
  const box = useRef<HTMLDivElement>(null);
  const scene = useRef<RobotScene | null>(null);
  const [error, fail] = useState("");
  const words = useRoute().searchParams;
  const looks = !small && words.has("camera");
  const hides = words.has("unoccupied");
  const measured = useLive((live) => (then ?? live).occupied !== null);
  const robot = useRobot();
  const site = useSite();
  useEffect(() => {
    try {
      scene.current = new RobotScene(box.current!, ({ item, x, y }) =>
        go(item === undefined ? `/map?x=${x.toFixed(2)}&y=${y.toFixed(2)}` : `/map?item=${item}`));
    } catch {
      fail("This browser has no WebGL. The map shows the robot from above.");
      return;
    }
    const show = () => scene.current?.show(shown.current ?? current());
    show();
    const off = listen(() => shown.current || show());
    return () => {
      off();
      scene.current?.close();
      scene.current = null;
    };
  }, []);
  useEffect(() => {
    if (robot.value) scene.current?.setRobot(robot.value);
    scene.current?.show(then ?? current());
  }, [robot.value, then]);
  useEffect(() => {
    if (site.value) scene.current?.setSite(site.value);
  }, [site.value]);
  useEffect(() => scene.current?.showOccupied(!hides), [hides]);
  return (
    <section class={small ? "view3d inset" : "view3d"} aria-label={then ? "The robot in its room, then" : "The robot in its room"}>
      <div class="canvas" ref={box} />
      {error && <p class="quiet over">{error} <a href="/map">Map</a></p>}
      {looks && <Camera name={words.get("camera") ?? ""} carry={(from, to, point) => scene.current?.carry(from.frame, to.frame, point) ?? null} />}
      <div class="tools">
        <button onClick={() => scene.current?.look("side")}>Side</button>
        <button onClick={() => scene.current?.look("above")}>Above</button>
        {!small && <button onClick={clearPath}>Clear path</button>}
        {!small && Boolean(robot.value?.cameras.length) && <button aria-pressed={looks} onClick={() => mark("camera", !looks)}>Camera</button>}
        {measured && <button aria-pressed={!hides} onClick={() => mark("unoccupied", !hides)}>Occupied space</button>}
      </div>
    </section>
  );
}
