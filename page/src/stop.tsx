// The stop, always in reach; and who may release it.
import { useState } from "preact/hooks";
import { act, may, useActing } from "./acting";
import { ask } from "./api";
import { useLive } from "./state";

export function StopButton() {
  const stop = useLive((live) => live.stop);
  const { session } = useActing();
  const [asked, ask_] = useState(false);
  if (!session) return null;
  if (session.role === "replay") return null;
  if (!may("stop")) return <span class="quiet" title="The stop needs the key of an operator. The robot's own stop button works for everybody.">no stop with this key</span>;
  const press = async () => {
    ask_(true);
    await act(() => ask("stop"), "Stopped. Nothing moves until somebody releases the stop.");
    ask_(false);
  };
  return (
    <button class="stop" onClick={press} disabled={asked} title="Stop the robot at once (Ctrl+.)" aria-keyshortcuts="Control+Period">
      {stop?.stopped ? "STOP (set)" : "STOP"}
    </button>
  );
}

export function StopBanner() {
  const stop = useLive((live) => live.stop);
  if (!stop?.stopped) return null;
  return (
    <section class="stopped" role="alert">
      <p>
        <strong>Stopped</strong> by {stop.by || "somebody"}{stop.reason && `: ${stop.reason}`}.{" "}
        {may("release")
          ? "You may release it, when you have seen that nobody is in the robot's reach."
          : "An operator may release it, here or with tandem release."}
      </p>
      {may("release") && <button onClick={() => act(() => ask("release"), "Released. The robot may move again.")}>Release</button>}
    </section>
  );
}

addEventListener("keydown", (event) => {
  if (event.key === "." && event.ctrlKey && may("stop")) {
    event.preventDefault();
    void act(() => ask("stop"), "Stopped. Nothing moves until somebody releases the stop.");
  }
});
