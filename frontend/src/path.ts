// Places inside a scenario's table: "controller.alpha_4", "actuator.all.chain[0].slope", `task.constraint."my port"`.

import type { Table, Value } from "./protocol";

export type Key = string | number;
export type Path = readonly Key[];

const STEP = /\[(\d+)\]|"((?:[^"\\]|\\.)*)"|([^.[\]"]+)/g;

export function parsePath(text: string): Path {
  return [...text.matchAll(STEP)].map(([, index, quoted, bare]) => {
    if (index !== undefined) return Number(index);
    return quoted !== undefined ? (JSON.parse(`"${quoted}"`) as string) : (bare as string);
  });
}

/** The path as the server writes it; keys that TOML would quote are quoted. */
export function formatPath(path: Path): string {
  let text = "";
  for (const key of path) {
    if (typeof key === "number") text += `[${key}]`;
    else text += (text ? "." : "") + (/^[\w-]+$/.test(key) ? key : JSON.stringify(key));
  }
  return text;
}

export const isTable = (value: Value | undefined): value is Table =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** What is inside `value` under `key`; the keys that every object inherits are not there. */
function inside(value: Value | undefined, key: Key): Value | undefined {
  if (Array.isArray(value)) return typeof key === "number" ? value[key] : undefined;
  return isTable(value) && Object.hasOwn(value, key) ? value[key] : undefined;
}

export const valueAt = (root: Value | undefined, path: Path): Value | undefined => path.reduce(inside, root);

/** `root` with `value` at `path`; tables on the way are made, everything beside the way is shared. */
export function withValue(root: Value | undefined, path: Path, value: Value): Value {
  const [key, ...rest] = path;
  if (key === undefined) return value;
  const below = withValue(inside(root, key), rest, value);
  if (typeof key === "number") return Object.assign(Array.isArray(root) ? [...root] : [], { [key]: below });
  return { ...(isTable(root) ? root : {}), [key]: below };
}

/** `root` without what is at `path`, and without tables that this leaves empty. */
export function without(root: Table, path: Path): Table {
  const above = path.slice(0, -1);
  const holder = valueAt(root, above);
  const key = path[path.length - 1];
  if (key === undefined || valueAt(root, path) === undefined) return root;
  if (Array.isArray(holder))
    return withValue(
      root,
      above,
      holder.filter((_, index) => index !== key),
    ) as Table;
  const { [key]: _, ...kept } = holder as Table;
  const empty = Object.keys(kept).length === 0;
  if (empty && typeof above[above.length - 1] === "string") return without(root, above);
  return withValue(root, above, kept) as Table;
}

export function equal(a: Value | undefined, b: Value | undefined): boolean {
  if (a === b) return true;
  if (Array.isArray(a)) return Array.isArray(b) && a.length === b.length && a.every((value, index) => equal(value, b[index]));
  if (!isTable(a) || !isTable(b)) return false;
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((key) => Object.hasOwn(b, key) && equal(a[key], b[key]));
}
