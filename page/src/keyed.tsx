import type { ComponentChildren } from "preact";

export function KeyedList({ rows, empty }: { rows: [string, ComponentChildren][]; empty: string }) {
  if (!rows.length) return <p class="quiet">{empty}</p>;
  return <ul class="plain">{rows.map(([key, row]) => <li key={key}>{row}</li>)}</ul>;
}
