// Chains of stages: one for all ports, or one for each.

import { el } from "../dom";
import { isTable, type Path } from "../path";
import type { Table, Value } from "../protocol";
import { CardList } from "./cards";
import type { Field, Form } from "./form";

const ALL = "all";

export class Chains implements Field {
  readonly element: HTMLElement;
  private readonly same: HTMLInputElement;
  private readonly each: HTMLInputElement;
  private readonly lists = el("div", {});
  private fields: Field[] = [];
  private names = "";

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    private readonly family: string,
  ) {
    const radio = (change: () => void) => el("input", { type: "radio", name: `chains-${family}`, onchange: change });
    this.same = radio(() => this.join());
    this.each = radio(() => this.split());
    this.element = el(
      "div",
      { "data-group": "" },
      el(
        "fieldset",
        { class: "segments" },
        el("legend", { class: "unseen" }, "Chains"),
        el("label", {}, this.same, el("span", {}, "same for all ports")),
        el("label", {}, this.each, el("span", {}, "port by port")),
      ),
      this.lists,
    );
    this.update();
  }

  update(): void {
    const given = Object.keys(this.tables);
    const split = given.some((name) => name !== ALL);
    const ports = this.form.ports.map(({ name }) => name);
    const names = split ? [...new Set([...given, ...ports])] : [ALL];
    this.same.checked = !split;
    this.each.checked = split;
    this.each.disabled = ports.length === 0 && !split;
    if (names.join() === this.names) {
      for (const field of this.fields) field.update();
      return;
    }
    this.names = names.join();
    this.fields = names.map((name) => this.list(name, split));
    this.lists.replaceChildren(...this.fields.map((field) => field.element));
  }

  private list(name: string, split: boolean): Field {
    const doc =
      "Stages between the command and what is delivered, in this order. Without any, the command goes through as it is.";
    const item = { is: "kind", family: this.family } as const;
    const described = {
      name: name !== ALL ? name : split ? "all other ports" : "all ports",
      type: { is: "list", of: item } as const,
      unit: "",
      doc,
      range: {},
      required: false,
    };
    return new CardList(this.form, [...this.path, name, "chain"], described, item);
  }

  private get tables(): Table {
    const value = this.form.scenario.value(this.path);
    return isTable(value) ? value : {};
  }

  private chain(name: string): Value {
    return this.form.scenario.value([...this.path, name, "chain"]) ?? [];
  }

  private split(): void {
    const ports = this.form.ports.map(({ name }) => name);
    this.form.scenario.set(this.path, Object.fromEntries(ports.map((name) => [name, { chain: this.chain(ALL) }])));
  }

  private join(): void {
    const [first] = Object.keys(this.tables);
    this.form.scenario.set(this.path, { [ALL]: { chain: this.chain(ALL in this.tables ? ALL : (first ?? ALL)) } });
  }
}
