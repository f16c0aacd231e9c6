// A form made of a JSON Schema. Values are text as typed; what is empty is left out of the document.
import type { Problem } from "./types";

export type Schema = {
  type?: string; enum?: unknown[]; const?: unknown; anyOf?: Schema[]; oneOf?: Schema[]; default?: unknown; description?: string; examples?: unknown[];
  minimum?: number; maximum?: number; exclusiveMinimum?: number; maxLength?: number; properties?: Record<string, Schema>;
  required?: string[]; items?: Schema; prefixItems?: Schema[]; $ref?: string; $defs?: Record<string, Schema>;
};
export type Values = Record<string, string>;

export function fields(schema: Schema): [string, Schema][] {
  return Object.entries(schema.properties ?? {}).map(([name, field]): [string, Schema] => [name, named(field, schema.$defs ?? {})]).filter(([, field]) => field.const === undefined);
}

// A field with what its names stand for; its own words before those of what is named.
function named(field: Schema, all: Record<string, Schema>): Schema {
  const meant = field.$ref ? all[field.$ref.split("/").at(-1)!] : undefined;
  const anyOf = field.anyOf?.map((each) => named(each, all));
  return { ...meant, ...field, ...(anyOf && { anyOf }) };
}

// The shape that a person fills in: of alternatives the first that is not null.
function shape(field: Schema): Schema {
  const several = field.anyOf ?? field.oneOf;
  const first = several?.find((each) => each.type !== "null");
  return first ? { ...first, description: field.description, default: field.default, examples: field.examples ?? first.examples } : field;
}

export function document(schema: Schema, values: Values): Record<string, unknown> {
  const made: Record<string, unknown> = {};
  for (const [name, plain] of Object.entries(schema.properties ?? {})) {
    const field = named(plain, schema.$defs ?? {});
    if (field.const !== undefined) made[name] = field.const;
    else if (values[name]?.trim()) made[name] = read(field, values[name]!.trim());
  }
  return made;
}

function read(field: Schema, text: string): unknown {
  const texts = (field.anyOf ?? [field]).some((each) => each.type === "string" || each.enum);
  const { type } = shape(field);
  if (type === "boolean") return text === "true";
  if (type === "string" || (shape(field).enum && texts)) return text;
  try {
    return JSON.parse(text); // a number, a list, an object
  } catch {
    return text; // the executive says what it expected
  }
}

type Given = {
  name: string; field: Schema; value: string; needed: boolean; offers: string[]; problem?: Problem;
  change: (value: string) => void;
};

export function Field({ name, field, value, needed, offers, problem, change }: Given) {
  const form = shape(field);
  const id = `field-${name}`;
  const type = (event: { currentTarget: { value: string } }) => change(event.currentTarget.value);
  const common = { id, required: needed, "aria-describedby": `${id}-about`, "aria-invalid": problem ? true : undefined };
  const hint = form.default === undefined || form.default === null || typeof form.default === "object" ? "" : String(form.default);
  let input;
  if (form.type === "boolean") {
    input = <select {...common} value={value} onChange={type}><option value="">{hint === "true" ? "yes" : "no"} (default)</option><option value="true">yes</option><option value="false">no</option></select>;
  } else if (form.enum) {
    input = <select {...common} value={value} onChange={type}><option value="">{hint ? `${hint} (default)` : "–"}</option>{form.enum.map((each) => <option key={String(each)} value={String(each)}>{String(each)}</option>)}</select>;
  } else {
    const numeric = (form.type === "integer" || form.type === "number") && !offers.length;
    input = (
      <input
        {...common} type={numeric ? "number" : "text"} value={value} onInput={type} placeholder={hint || example(form)}
        min={form.minimum} max={form.maximum} step={form.type === "integer" ? 1 : "any"} maxLength={form.maxLength}
        inputMode={form.type === "integer" ? "numeric" : undefined} list={offers.length ? `${id}-offers` : undefined} autoComplete="off"
      />
    );
  }
  return (
    <div class={`field ${problem ? "wrong" : ""}`}>
      <label for={id}>{name}{needed && <span class="needed" title="needed"> *</span>}</label>
      {input}
      {offers.length > 0 && <datalist id={`${id}-offers`}>{offers.map((each) => <option key={each} value={each} />)}</datalist>}
      <p class="quiet" id={`${id}-about`}>{form.description}</p>
      {problem && <p class="problem">{problem.path !== name && `${problem.path}: `}expected {problem.expected}{problem.found && `; found ${problem.found}`}</p>}
    </div>
  );
}

function example(form: Schema): string {
  const [first] = form.examples ?? [];
  if (first !== undefined) return typeof first === "string" ? first : JSON.stringify(first);
  if (form.type === "array") return form.prefixItems ? `[${form.prefixItems.map(() => "0.0").join(", ")}]` : "[…]";
  return form.type === "object" ? '{"name": "value"}' : "";
}
