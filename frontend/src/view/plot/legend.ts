// The legend of a plot: how each line looks, what it is, and its value where the cursor stands.

import { el, write } from "../../dom";
import type { Line } from "./plot";

const SVG = "http://www.w3.org/2000/svg";

export class Legend {
  readonly root = el("ul", { class: "legend" });
  #values: (HTMLElement | null)[] = [];

  list(lines: Line[]): void {
    this.#values = lines.map(({ unlisted, says }) => (unlisted || !says ? null : el("span", { class: "legend-value" })));
    const item = (line: Line) => {
      const value = this.#values[lines.indexOf(line)];
      return el("li", {}, swatch(line), line.label, ...(value ? [" ", value] : []));
    };
    const listed = lines.filter(({ unlisted }) => !unlisted);
    // What is drawn behind comes last.
    this.root.replaceChildren(
      ...listed.filter(({ alpha }) => !alpha).map(item),
      ...listed.filter(({ alpha }) => alpha).map(item),
    );
  }

  write(texts: string[]): void {
    this.#values.forEach((value, i) => value && write(value, texts[i] ?? ""));
  }
}

function swatch({ token, dash, width, alpha, marker }: Line): SVGElement {
  const svg = document.createElementNS(SVG, "svg");
  for (const [name, value] of Object.entries({ width: "22", height: "10", viewBox: "0 0 22 10", "aria-hidden": "true" }))
    svg.setAttribute(name, value);
  const line = document.createElementNS(SVG, "line");
  const look = {
    x1: "0",
    x2: "22",
    y1: "5",
    y2: "5",
    "stroke-width": `${width ?? 1.6}`,
    "stroke-dasharray": (dash ?? []).join(" "),
    opacity: `${alpha ?? 1}`,
  };
  for (const [name, value] of Object.entries(look)) line.setAttribute(name, value);
  line.style.stroke = `var(--${token})`;
  svg.append(line);
  if (marker) svg.append(symbol(marker, token));
  return svg;
}

function symbol(marker: NonNullable<Line["marker"]>, token: string): SVGElement {
  const path = document.createElementNS(SVG, "path");
  const outlines = {
    disc: "M7.5 5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z",
    square: "M8 2h6v6h-6z",
    diamond: "M11 1l4 4l-4 4l-4 -4z",
    triangle: "M11 1l4 7h-8z",
  };
  path.setAttribute("d", outlines[marker]);
  path.style.fill = `var(--${token})`;
  return path;
}
