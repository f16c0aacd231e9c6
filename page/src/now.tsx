// What happens now: the robot in its room, the task at work with its tree, and what waits.
import { TaskCard } from "./card";
import { Others } from "./others";
import { Overridden, Resources } from "./reflexes";
import { at, atWork, ended, queued, useLive } from "./state";
import { LiveTree } from "./tree";
import { View3d } from "./view3d";
import { STATE_SIGNS, summary } from "./words";

export function NowView() {
  const tasks = useLive((live) => live.tasks);
  const treeOf = useLive((live) => live.tree?.task);
  const running = atWork(tasks);
  const last = Object.values(tasks).filter(ended).sort((a, b) => at(b) - at(a))[0];
  const shown = running ?? (treeOf ? tasks[treeOf] : undefined) ?? last;
  return (
    <div class="now">
      <View3d />
      <div class="side">
        {shown ? <TaskCard status={shown} /> : <section class="card"><h2>Nothing runs</h2><p class="quiet">No task yet. <a href="/request">Send a request</a></p></section>}
        <NotRecorded />
        <Overridden />
        <Queue />
        <Resources />
        <Others />
        <section class="card grow"><h2>Tree</h2><LiveTree failed={shown?.state === "FAILED"} /></section>
      </div>
    </div>
  );
}

// Only where recording was asked for, and has stopped.
function NotRecorded() {
  const told = useLive((live) => live.recording);
  if (!told || told.recording) return null;
  return (
    <section class="card warn" role="status">
      <p><strong>Recording has stopped:</strong> {told.reason}. It goes on by itself once there is space on the disk of the robot's computer.{told.file && <span class="quiet"> Until then: <code>tandem log recover {told.file}</code></span>}</p>
    </section>
  );
}

function Queue() {
  const tasks = useLive((live) => live.tasks);
  const waiting = queued(tasks);
  if (!waiting.length) return null;
  return (
    <section class="card">
      <h2>Queue <span class="count">{waiting.length}</span></h2>
      <ol class="queue">
        {waiting.slice(0, 20).map((each) => (
          <li key={each.task}>
            <span class="sign" aria-hidden="true">{STATE_SIGNS[each.state]}</span>
            <a href={`/task/${encodeURIComponent(each.task)}`}>{each.kind}</a> <span class="what">{summary(each.request)}</span>
            {each.priority !== 0 && <span class="chip">priority {each.priority}</span>}
            {each.waits_for && <span class="quiet"> · waits for {each.waits_for}</span>}
          </li>
        ))}
      </ol>
      {waiting.length > 20 && <p class="quiet">and {waiting.length - 20} more</p>}
    </section>
  );
}
