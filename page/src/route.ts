// The address is the state of the view: it can be sent to a colleague, and the browser's buttons work.
import { useEffect, useState } from "preact/hooks";

export function go(address: string, replace = false) {
  if (replace) history.replaceState(null, "", address);
  else history.pushState(null, "", address);
  dispatchEvent(new Event("routed"));
}

// Sets a word of the address, with or without a value, or takes it out; the rest stays as it is.
export function mark(name: string, value: string | boolean) {
  const url = new URL(location.href);
  if (value === false) url.searchParams.delete(name);
  else url.searchParams.set(name, value === true ? "" : value);
  go(url.pathname + url.search.replace(/=(?=&|$)/g, ""), true);
}

export function useRoute(): URL {
  const [url, set] = useState(() => new URL(location.href));
  useEffect(() => {
    const read = () => set(new URL(location.href));
    for (const event of ["popstate", "routed"]) addEventListener(event, read);
    return () => ["popstate", "routed"].forEach((event) => removeEventListener(event, read));
  }, []);
  return url;
}

// Links inside the page do not load it anew.
export function catchLinks() {
  document.addEventListener("click", (event) => {
    const link = (event.target as Element | null)?.closest?.("a");
    const plain = !event.defaultPrevented && event.button === 0 && !event.metaKey && !event.ctrlKey && !event.shiftKey;
    if (!link || !plain || link.target || link.origin !== location.origin || link.hasAttribute("download")) return;
    if (/^\/(static|api|mesh)\//.test(link.pathname)) return;
    event.preventDefault();
    go(link.pathname + link.search);
  });
}
