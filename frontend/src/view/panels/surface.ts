// A field over time and place; that of the pinned run below it, with the same limits.

import { el } from "../../dom";
import { Measure, number } from "../format";
import { greek } from "../look";
import { ColourBar } from "../plot/colour_bar";
import { ramp } from "../plot/diverging";
import { type Field, HeatMap } from "../plot/heat_map";
import type { Run } from "../../run";
import { cursorOf, endOf, type Scene } from "../scene";
import { Card } from "./card";
import type { Hands, Panel } from "./panel";

export class Surface implements Panel {
  readonly card: Card;
  readonly #hands: Hands;
  readonly #bar = new ColourBar();
  readonly #choice = el("select", { "aria-label": "Field to be seen" });
  readonly #now: HeatMap;
  readonly #pinned: HeatMap;
  readonly #label = el("p", { class: "card-note" });
  #scene: Scene | null = null;
  #caption = "";
  #name = "";
  #measure = new Measure(1, "");
  #colours: Uint32Array;

  constructor(hands: Hands, fields: { name: string }[]) {
    this.#hands = hands;
    this.#colours = ramp(hands.look.dark);
    const hovered = (value: number, time: number, place: number) => this.#hovered(value, time, place);
    this.#now = new HeatMap(hands.look, 170, hands.seek, hovered);
    this.#pinned = new HeatMap(hands.look, 150, hands.seek, hovered);
    this.#choice.append(...fields.map(({ name }) => el("option", { value: name }, `${greek(name)}(x, t)`)));
    this.#choice.onchange = () => this.#scene && (this.draw(this.#scene), this.cursor(this.#scene));
    this.card = new Card(el("div", { class: "card-tools" }, ...(fields.length > 1 ? [this.#choice] : []), this.#bar.root));
    this.card.body.append(this.#now.root, this.#label, this.#pinned.root);
  }

  draw(scene: Scene): void {
    this.#scene = scene;
    const { run, pinned, trial, span } = scene;
    const { name, unit } = run.picture.fields.find((field) => field.name === this.#choice.value) ?? run.picture.fields[0]!;
    const beside = pinned?.run.picture.fields.some((field) => field.name === name) ? pinned : null;
    const within = span === "trial" ? trial : null;
    const limit = Math.max(run.largestOfField(name, within), beside?.run.largestOfField(name, within) ?? 0);
    const measure = new Measure(limit || 1, unit);
    const words = `${greek(name)}(x, t) ${within === null ? "in all trials" : `in trial ${trial}`}`;
    const own = `Largest ${measure.text(run.largestOfField(name, within))} ${within === null ? "in all trials" : `in trial ${trial}`}`;

    this.#bar.draw(limit, measure, this.#colours);
    this.#now.draw(
      fieldOf(run, name, within),
      run.picture.span,
      endOf(scene),
      limit,
      this.#colours,
      `${words} as a map of time and place. ${own}.`,
    );
    this.#pinned.root.hidden = this.#label.hidden = !beside;
    if (beside) {
      this.#label.textContent = `${beside.label}, same colours`;
      const field = fieldOf(beside.run, name, within);
      this.#pinned.draw(field, beside.run.picture.span, endOf(scene), limit, this.#colours, `${words} of ${beside.label}.`);
    }
    this.card.title(`Shape ${greek(name)}(x, t) over place x [m] and time`, `[${measure.unit}]`);
    [this.#caption, this.#name, this.#measure] = [`${own}.`, greek(name), measure];
    this.card.caption(this.#caption);
  }

  #hovered(value: number, time: number, place: number): void {
    const at = `${this.#name} = ${this.#measure.text(value)} at x = ${number(place)} m, t = ${number(time)} s`;
    this.card.caption(Number.isNaN(value) ? this.#caption : at);
  }

  cursor(scene: Scene): void {
    this.#now.cursor(cursorOf(scene));
    if (scene.pinned) this.#pinned.cursor(cursorOf(scene));
  }

  repaint(): void {
    this.#colours = ramp(this.#hands.look.dark);
    if (this.#scene) this.draw(this.#scene);
  }

  destroy(): void {
    this.#now.destroy();
    this.#pinned.destroy();
  }
}

function fieldOf(run: Run, name: string, trial: number | null): Field {
  const { duration, trials } = run.picture;
  return { ...run.field(name, trial), place: run.x, end: trial === null ? duration * trials : duration };
}
