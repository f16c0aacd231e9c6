// A field whose words count once they are entered; what happens meanwhile does not touch what is being typed. What is
// refused gives way to what holds.
import { useEffect, useState } from "preact/hooks";

type Given = {
  value: string; take: (value: string) => unknown; type?: "text" | "search" | "number"; list?: string; size?: number; min?: number; max?: number;
};

export function Typed({ value, take, type = "text", ...more }: Given) {
  const [typed, set] = useState(value);
  useEffect(() => set(value), [value]);
  const enter = async () => {
    if ((await take(typed.trim())) === false) set(value);
  };
  return <input {...more} type={type} value={typed} onInput={(event) => set(event.currentTarget.value)} onChange={enter} />;
}
