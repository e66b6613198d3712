// A list of tables, a card each: stages of a chain, terms of a sum.

import { el } from "../dom";
import { formatPath, isTable, type Path } from "../path";
import type { Table, Type, Value } from "../protocol";
import { Parameters } from "./component";
import type { Described, Field, Form } from "./form";
import { KindField } from "./kind";
import { Row } from "./row";

type Item = Extract<Type, { is: "kind" | "component" }>;

export class CardList implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly list = el("ol", { class: "cards" });
  private cards: Field[] = [];
  private shape = "";

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
    private readonly item: Item,
  ) {
    this.row = new Row(form, path, parameter, true);
    const add = el(
      "button",
      { type: "button", class: "add", "data-add": formatPath(path), onclick: () => this.add() },
      `Add to ${parameter.name}`,
    );
    this.row.body.append(this.list, add);
    this.element = this.row.element;
    // What is inside has words of its own for the filter.
    this.element.removeAttribute("data-words");
    this.element.setAttribute("data-group", "");
    this.update();
  }

  update(): void {
    this.row.update();
    const { items } = this;
    const shape = items.map((item) => (isTable(item) ? String(item.kind ?? "") : "?")).join("|");
    if (shape === this.shape && items.length === this.cards.length) {
      for (const card of this.cards) card.update();
      return;
    }
    this.shape = shape;
    this.cards = items.map((_, index) => this.card(index));
    this.list.replaceChildren(...this.cards.map((card, index) => el("li", { class: "card" }, this.tools(index), card.element)));
  }

  private get items(): readonly Value[] {
    const value = this.form.scenario.value(this.path);
    return Array.isArray(value) ? value : [];
  }

  private card(index: number): Field {
    const path = [...this.path, index];
    if (this.item.is === "component") return new Parameters(this.form, path, this.item.parameters);
    const described = { name: `${this.item.family} ${index + 1}`, type: this.item, unit: "", doc: "", range: {}, required: true };
    return new KindField(this.form, path, described, this.item.family);
  }

  private tools(index: number): HTMLElement {
    const button = (sign: string, label: string, act: () => void, disabled = false) =>
      el("button", { type: "button", class: "tool", disabled, "aria-label": `${label} ${index + 1}`, onclick: act }, sign);
    return el(
      "div",
      { class: "tools" },
      button("↑", "Move up", () => this.move(index, index - 1), index === 0),
      button("↓", "Move down", () => this.move(index, index + 1), index === this.items.length - 1),
      button("×", "Remove", () => this.remove(index)),
    );
  }

  private add(): void {
    const fresh: Table = this.item.is === "kind" ? { kind: this.form.kinds(this.item.family)[0]?.kind ?? "" } : {};
    this.form.scenario.set(this.path, [...this.items, fresh]);
    this.focus(this.cards.length - 1, "select, input");
  }

  private move(from: number, to: number): void {
    const items = [...this.items];
    const [moved] = items.splice(from, 1);
    if (moved === undefined) return;
    items.splice(to, 0, moved);
    this.form.scenario.set(this.path, items);
    this.focus(to, `.tools button:nth-child(${from < to ? 2 : 1}):enabled`);
  }

  private remove(index: number): void {
    this.form.scenario.set(
      this.path,
      this.items.filter((_, other) => other !== index),
    );
    this.focus(Math.min(index, this.cards.length - 1), ".tools button:last-child");
  }

  /** Keeps the keyboard where the work is: in the card, or on the button that adds one. */
  private focus(index: number, inside: string): void {
    const card = this.list.children[index];
    const target = card?.querySelector<HTMLElement>(inside) ?? card?.querySelector<HTMLElement>(".tools button:enabled");
    (target ?? this.element.querySelector<HTMLElement>(".add"))?.focus();
  }
}
