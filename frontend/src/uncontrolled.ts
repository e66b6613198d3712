// The same experiment without control.

import { isTable } from "./path";
import type { Table } from "./protocol";

/** Nothing is commanded, so that nothing is compensated and nothing sampled either. */
export function uncontrolled({ compensation: _, numerics, ...rest }: Table): Table {
  const continuous: Table = isTable(numerics) ? { numerics: { ...numerics, mode: "continuous" } } : {};
  return { ...rest, ...continuous, controller: { kind: "none" } };
}
