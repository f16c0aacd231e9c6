// Beyond the robot's host a viewer logs in, once, with a word of `tandem keys link`.
import { useEffect, useState } from "preact/hooks";
import { logIn } from "./acting";
import { go } from "./route";

// The word is behind the #, which no browser sends to a server; it leaves the address before it is used.
function wordInAddress(): string {
  const word = location.pathname === "/login" ? location.hash.slice(1) : "";
  if (word) history.replaceState(null, "", "/login");
  return word;
}

export function Login() {
  const [word, set] = useState("");
  const [error, fail] = useState("");
  const [busy, work] = useState(false);
  const enter = async (with_: string) => {
    work(true);
    fail("");
    try {
      await logIn(with_);
      if (location.pathname === "/login") go("/", true);
    } catch (wrong) {
      fail(wrong instanceof Error ? wrong.message : String(wrong));
      work(false);
    }
  };
  useEffect(() => {
    const found = wordInAddress();
    if (found) void enter(found);
  }, []);
  return (
    <form class="card login" onSubmit={(event) => { event.preventDefault(); void enter(word.trim()); }}>
      <h2>Log in</h2>
      <p>On a computer that has your key: <code>tandem keys link NAME --page {location.origin}</code></p>
      <p class="quiet">Open the address that it prints, or paste the word of <code>--word</code> here. It opens this page once, within ten minutes.</p>
      <p class="verbs">
        <input type="password" aria-label="Word" autoComplete="off" value={word} onInput={(event) => set(event.currentTarget.value)} />
        <button class="primary" disabled={busy || !word.trim()}>Log in</button>
      </p>
      {error && <p class="failure" role="alert">{error}</p>}
    </form>
  );
}
