// The live link: connects, connects again by itself, and gives up a link on which nothing comes.
import { ended, loadSession, who } from "./acting";
import { connected, take } from "./state";

const SILENT = 4000;
const ENDED = 4401;
const AGAIN = [300, 600, 1200, 2500];

export function follow() {
  let tries = 0;
  const open = () => {
    if (!who()) return void setTimeout(open, 500); // not logged in (any more)
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live`);
    let timer = setTimeout(() => socket.close(), SILENT);
    socket.onmessage = (event) => {
      clearTimeout(timer);
      timer = setTimeout(() => socket.close(), SILENT);
      if (tries >= 0) connected(true);
      tries = -1;
      take(JSON.parse(String(event.data)));
    };
    socket.onclose = (event) => {
      clearTimeout(timer);
      connected(false);
      if (event.code === ENDED) ended();
      else if (who()?.login) void loadSession().catch(() => undefined); // it may have been refused for that
      tries = Math.min(tries + 1, AGAIN.length - 1);
      setTimeout(open, AGAIN[tries]);
    };
  };
  open();
}
