import { render } from "preact";
import { loadSession, say } from "./acting";
import { App } from "./app";
import { follow } from "./link";
import { catchLinks } from "./route";

catchLinks();
follow();
loadSession().catch((error) => say(String(error.message ?? error), true));
render(<App />, document.getElementById("page")!);
