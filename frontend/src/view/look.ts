// The colours of the page as numbers for canvases, and what tells one port from another.

import type { Port } from "../protocol";

const TOKENS = [
  "ink",
  "faint",
  "paper",
  "card",
  "line",
  "displacement",
  "rotation",
  "uncontrolled",
  "constraint",
  "learned",
  "reference",
] as const;
const SPARE: { [token: string]: Token } = { card: "paper", line: "faint" }; // where the page sets none

export type Token = (typeof TOKENS)[number];

export class Look {
  dark = false;
  readonly #colours = new Map<Token, string>();

  constructor() {
    this.read(document.documentElement.dataset["theme"] === "dark");
  }

  /** Takes the tokens that the page has now. */
  read(dark: boolean): void {
    this.dark = dark;
    const style = getComputedStyle(document.documentElement);
    for (const token of TOKENS) this.#colours.set(token, style.getPropertyValue(`--${token}`).trim());
  }

  colour(token: Token): string {
    return this.#colours.get(token) || this.#colours.get(SPARE[token] ?? "ink") || "#808080";
  }
}

/** A port's colour goes by what it moves; several of one kind differ by their dashes and markers. */
export interface PortLook {
  token: Token;
  dash: number[];
  marker: Marker;
}

export type Marker = "disc" | "square" | "diamond" | "triangle";

const DASHES = [[], [7, 3], [2, 2], [7, 2, 2, 2]];
const MARKERS: Marker[] = ["disc", "square", "diamond", "triangle"];

export function lookOf(ports: Port[], index: number): PortLook {
  const unit = ports[index]!.motion_unit;
  const nth = ports.slice(0, index).filter((port) => port.motion_unit === unit).length;
  return {
    token: unit === "m" ? "displacement" : unit === "rad" ? "rotation" : "ink",
    dash: DASHES[nth % DASHES.length]!,
    marker: MARKERS[index % MARKERS.length]!,
  };
}

/** "tip displacement", "hub rotation" */
export function motionOf(port: Port): string {
  const motion = port.motion_unit === "m" ? "displacement" : port.motion_unit === "rad" ? "rotation" : "motion";
  return `${placeOf(port)} ${motion}`;
}

/** "tip force", "hub torque" */
export function effortOf(port: Port): string {
  return `${placeOf(port)} ${port.kind}`;
}

export function placeOf(port: Port): string {
  return port.name.replace(/_(w|phi|theta|y)$/, "").replaceAll("_", " ");
}

/** The symbol with Greek letters: "φ(L, t)". */
export function symbolOf(port: Port): string {
  return greek(port.symbol);
}

export function greek(text: string): string {
  return text.replaceAll("phi", "φ").replaceAll("theta", "θ");
}

export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
