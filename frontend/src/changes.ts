// What differs between two tables.

import { equal, isTable, type Path } from "./path";
import type { Table, Value } from "./protocol";

export interface Change {
  path: Path;
  before: Value | undefined;
  after: Value | undefined;
}

/** The differences, each as deep as it can be told; a table of another `kind` is one difference. */
export function changes(before: Value | undefined, after: Value | undefined, path: Path = []): Change[] {
  if (equal(before, after)) return [];
  if (isTable(before) && isTable(after) && before.kind === after.kind) {
    const keys = new Set([...Object.keys(before), ...Object.keys(after)]);
    return [...keys].flatMap((key) => changes(before[key], after[key], [...path, key]));
  }
  if (areTables(before) && areTables(after) && before.length === after.length) {
    return before.flatMap((value, index) => changes(value, after[index], [...path, index]));
  }
  return [{ path, before, after }];
}

/** Whether it is a list of tables, which can be compared one by one; lists of numbers are compared as a whole. */
const areTables = (value: Value | undefined): value is Table[] => Array.isArray(value) && value.every(isTable);

/** A value in a few words. */
export function inBrief(value: Value | undefined): string {
  if (value === undefined) return "left out";
  if (Array.isArray(value)) return `[${value.map(inBrief).join(", ")}]`;
  if (!isTable(value)) return String(value).replace(/^-(?=\d)/, "−");
  const { kind, ...rest } = value;
  const parts = Object.entries(rest).map(([key, inner]) => `${key} = ${inBrief(inner)}`);
  return [...(kind === undefined ? [] : [String(kind)]), ...parts].join(", ") || "empty";
}

/** A name for a run: the preset and what was changed in it, as far as that is short. */
export function nameOf(preset: string, table: Table, base: Table): string {
  const all = changes(base, table);
  const told = all.slice(0, 2).map(({ path, after }) => {
    const short = isTable(after) && after.kind !== undefined ? String(after.kind) : inBrief(after);
    return `${path[path.length - 1]} = ${short.length > 24 ? `${short.slice(0, 22)}…` : short}`;
  });
  const more = all.length > told.length ? [`${all.length - told.length} more`] : [];
  return [preset, ...told, ...more].join(", ");
}
