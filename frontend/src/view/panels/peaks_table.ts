// The peaks as a table, for those who do not see the plot.

import type { Run } from "../../run";
import { el, write } from "../../dom";
import { quantity } from "../format";
import { motionOf } from "../look";

export class PeaksTable {
  readonly root = el("div", { class: "unseen" });
  #cells: HTMLTableCellElement[] = [];
  #made = "";

  fill(run: Run): void {
    const { trials, ports } = run.picture;
    const wanted = [trials, ...ports.map(({ name }) => name)].join();
    if (wanted !== this.#made) {
      this.#made = wanted;
      this.#el(run);
    }
    this.#cells.forEach((cell, i) => {
      const value = run.peaks[i]!;
      cell.dataset["value"] = String(value);
      write(cell, quantity(value, ports[i % ports.length]!.motion_unit));
    });
  }

  #el({ picture: { trials, ports } }: Run): void {
    this.#cells = [];
    const head = el(
      "tr",
      {},
      el("th", { scope: "col" }, "Trial"),
      ...ports.map((port) => el("th", { scope: "col" }, `Largest ${motionOf(port)}`)),
    );
    const rows = Array.from({ length: trials }, (_, trial) => {
      const cells = ports.map((port) => el("td", { "data-port": port.name, "data-trial": String(trial) }));
      this.#cells.push(...cells);
      return el("tr", {}, el("th", { scope: "row" }, String(trial)), ...cells);
    });
    const caption = el("caption", {}, "Peaks of every trial");
    this.root.replaceChildren(el("table", { "data-role": "peaks" }, caption, el("thead", {}, head), el("tbody", {}, ...rows)));
  }
}
