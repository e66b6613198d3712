// A table of parameters, bare or behind a heading that folds.

import { el } from "../dom";
import { formatPath, isTable, type Path } from "../path";
import type { Parameter, Type } from "../protocol";
import type { Described, Field, Form } from "./form";
import { makeField } from "./makefield";
import { prose } from "./words";

/** The fields of parameters, one below the other. */
export class Parameters implements Field {
  readonly element = el("div", { class: "parameters" });
  private readonly fields: Field[];

  constructor(form: Form, path: Path, parameters: readonly Parameter[]) {
    this.fields = parameters.map((parameter) => makeField(form, [...path, parameter.name], parameter));
    this.element.append(...this.fields.map((field) => field.element));
  }

  update(): void {
    for (const field of this.fields) field.update();
  }
}

export class ComponentField implements Field {
  readonly element: HTMLElement;
  private readonly mark = el("span", { class: "mark", hidden: true }, el("span", { class: "unseen" }, "changed from the preset"));
  private readonly inner: Parameters;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
    type: Extract<Type, { is: "component" }>,
  ) {
    const at = formatPath(path);
    this.inner = new Parameters(form, path, type.parameters);
    const details = el(
      "details",
      { class: "group", "data-group": "" },
      el("summary", {}, el("span", { class: "name" }, parameter.name), this.mark),
      el("p", { class: "about" }, ...prose(parameter.doc || type.summary)),
      el("p", { class: "error", "data-error": at }),
      this.inner.element,
    );
    details.open = isTable(form.scenario.value(path));
    this.element = details;
    this.update();
  }

  update(): void {
    this.mark.hidden = !this.form.scenario.differs(this.path);
    this.inner.update();
  }
}
