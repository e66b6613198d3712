// A link that holds the whole state: JSON, deflated, in the part of the address that never leaves the browser.

import { isTable } from "./path";
import type { Table, Value } from "./protocol";
import { stateIn, type ViewState } from "./view/state";

export interface Linked {
  v: 1;
  preset: string;
  table: Table;
  view: ViewState;
}

const LARGEST = 4_000_000; // bytes once inflated: no scenario is as large, a bomb is

export async function toHash(state: Linked): Promise<string> {
  const deflated = await through(new TextEncoder().encode(JSON.stringify(state)), new CompressionStream("deflate-raw"));
  const binary = Array.from(deflated, (byte) => String.fromCharCode(byte)).join("");
  return `#s=${btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** The state in a hash; null where there is none. Throws where it is broken. */
export async function fromHash(hash: string): Promise<Linked | null> {
  const [, code] = /^#s=(.*)$/.exec(hash) ?? [];
  if (code === undefined) return null;
  const binary = atob(code.replaceAll("-", "+").replaceAll("_", "/"));
  const deflated = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const inflated = await through(deflated, new DecompressionStream("deflate-raw"));
  // Anyone can have written it.
  const state = JSON.parse(new TextDecoder().decode(inflated)) as { [field in keyof Linked]?: unknown } | null;
  const table = state?.table as Value | undefined;
  if (state?.v !== 1 || typeof state.preset !== "string" || !isTable(table)) throw new Error("The link holds no state.");
  return { v: 1, preset: state.preset, table, view: stateIn(state.view) };
}

async function through(bytes: Uint8Array<ArrayBuffer>, filter: GenericTransformStream): Promise<Uint8Array> {
  const reader = (new Blob([bytes]).stream().pipeThrough(filter) as ReadableStream<Uint8Array>).getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (let read = await reader.read(); !read.done; read = await reader.read()) {
    parts.push(read.value);
    size += read.value.length;
    if (size > LARGEST) throw new Error("The link holds too much.");
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
