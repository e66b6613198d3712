// The peaks as a table, for those who do not see the plot.

import type { Run } from "../../run";
import { make, say } from "../dom";
import { quantity } from "../format";
import { motionOf } from "../look";

export class PeaksTable {
  readonly root = make("div", { class: "unseen" });
  #cells: HTMLTableCellElement[] = [];
  #made = "";

  fill(run: Run): void {
    const { trials, ports } = run.picture;
    const wanted = [trials, ...ports.map(({ name }) => name)].join();
    if (wanted !== this.#made) {
      this.#made = wanted;
      this.#make(run);
    }
    this.#cells.forEach((cell, i) => {
      const value = run.peaks[i]!;
      cell.dataset["value"] = String(value);
      say(cell, quantity(value, ports[i % ports.length]!.motion_unit));
    });
  }

  #make({ picture: { trials, ports } }: Run): void {
    this.#cells = [];
    const head = make("tr", {}, make("th", { scope: "col" }, "Trial"), ...ports.map((port) => make("th", { scope: "col" }, `Largest ${motionOf(port)}`)));
    const rows = Array.from({ length: trials }, (_, trial) => {
      const cells = ports.map((port) => make("td", { attributes: { "data-port": port.name, "data-trial": String(trial) } }));
      this.#cells.push(...cells);
      return make("tr", {}, make("th", { scope: "row" }, String(trial)), ...cells);
    });
    const caption = make("caption", {}, "Peaks of every trial");
    this.root.replaceChildren(make("table", { attributes: { "data-role": "peaks" } }, caption, make("thead", {}, head), make("tbody", {}, ...rows)));
  }
}
