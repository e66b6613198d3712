// A table by port: a row for each port of the plant, and for every other name that the scenario gives.

import { el } from "../dom";
import { isTable, type Path } from "../path";
import type { Type } from "../protocol";
import type { Described, Field, Form } from "./form";
import { makeField } from "./makefield";
import { Row } from "./row";
import { unitAt } from "./words";

export class TableField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly rows = el("div", { class: "by-port" });
  private fields: Field[] = [];
  private names = "";

  /** `more`: names besides the ports', with their units. */
  constructor(
    private readonly form: Form,
    private readonly path: Path,
    private readonly parameter: Described,
    private readonly of: Type,
    private readonly more: { readonly [name: string]: string } = {},
  ) {
    this.row = new Row(form, path, { ...parameter, unit: "" }, true);
    this.row.body.append(this.rows);
    this.element = this.row.element;
    this.element.setAttribute("data-group", "");
    this.update();
  }

  update(): void {
    this.row.update();
    const given = this.form.scenario.value(this.path);
    const ports = this.form.ports.map(({ name }) => name);
    const names = new Set([...ports, ...Object.keys(this.more), ...(isTable(given) ? Object.keys(given) : [])]);
    const signature = JSON.stringify([...names].map((name) => [name, this.unit(name)]));
    if (signature === this.names) {
      for (const field of this.fields) field.update();
      return;
    }
    this.names = signature;
    this.fields = [...names].map((name) => this.field(name));
    this.rows.replaceChildren(...this.fields.map((field) => field.element));
  }

  private unit(name: string): string {
    return (
      this.more[name] ??
      unitAt(
        this.form.ports.find((port) => port.name === name),
        this.parameter,
      )
    );
  }

  private field(name: string): Field {
    const { range } = this.parameter;
    // The row above has said what it is about.
    const described = { name, type: this.of, unit: this.unit(name), doc: "", range, required: false };
    return makeField(this.form, [...this.path, name], described);
  }
}
