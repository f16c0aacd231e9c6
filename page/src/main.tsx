import { render } from "preact";
import { loadSession, say } from "./acting";
import { App } from "./app";
import { follow } from "./link";
import { catchLinks } from "./route";

catchLinks();
follow();
const begin = () =>
  loadSession().catch((error) => {
    say(String(error.message ?? error), true);
    setTimeout(begin, 2000);
  });
void begin();
render(<App />, document.getElementById("page")!);
