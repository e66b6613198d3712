// Buttons with a drawn sign and a spoken name.

import { el } from "../dom";

const SVG = "http://www.w3.org/2000/svg";
const SIGNS = {
  play: "M5 3l9 6l-9 6z",
  pause: "M5 3h3v12h-3z M11 3h3v12h-3z",
  back: "M12 4l-6 5l6 5z M4 4h1.6v10h-1.6z",
  on: "M6 4l6 5l-6 5z M12.4 4h1.6v10h-1.6z",
  previous: "M11 4l-5 5l5 5",
  next: "M7 4l5 5l-5 5",
};
const OPEN = new Set(["previous", "next"]); // lines, not areas

export function icon(sign: "play" | "back" | "on" | "previous" | "next", name: string, onclick: () => void): HTMLButtonElement {
  const signs = sign === "play" ? [drawn("play"), drawn("pause")] : [drawn(sign)];
  return el("button", { type: "button", class: `icon ${sign}`, title: name, onclick, "aria-label": name }, ...signs);
}

function drawn(sign: keyof typeof SIGNS): SVGElement {
  const svg = document.createElementNS(SVG, "svg");
  const path = document.createElementNS(SVG, "path");
  const attributes = {
    viewBox: "0 0 18 18",
    width: "18",
    height: "18",
    "aria-hidden": "true",
    class: `sign-${sign}${OPEN.has(sign) ? " open" : ""}`,
  };
  for (const [name, value] of Object.entries(attributes)) svg.setAttribute(name, value);
  path.setAttribute("d", SIGNS[sign]);
  svg.append(path);
  return svg;
}
