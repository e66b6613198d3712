// A table whose `kind` says which parameters it has.

import { el } from "../dom";
import { formatPath, type Path } from "../path";
import { Parameters } from "./component";
import type { Described, Field, Form } from "./form";
import { Row } from "./row";
import { prose } from "./words";

const UNSET = "";

export class KindField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly select: HTMLSelectElement;
  private readonly about = el("p", { class: "about" });
  private readonly body = el("div", {});
  private inner: Parameters | null = null;
  private shown: string | null = null;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
    private readonly family: string,
  ) {
    const at = [...path, "kind"];
    // What can be left out is left out as a whole; what cannot has its kind changed.
    this.row = new Row(form, parameter.required ? at : path, parameter);
    const kinds = form.kinds(family);
    const unset = parameter.required ? "needed" : "left out";
    this.select = el(
      "select",
      { ...this.row.control, "data-path": formatPath(at) },
      el("option", { value: UNSET }, unset),
      ...kinds.map(({ kind }) => el("option", { value: kind }, kind)),
    );
    // Another kind starts the table afresh: parameters of the same name need not mean the same.
    this.select.addEventListener("change", () => {
      if (this.select.value === UNSET) form.scenario.remove(path);
      else form.scenario.set(path, { kind: this.select.value });
    });
    this.row.body.append(this.select);
    this.element = el("div", { class: "kind", "data-group": "" }, this.row.element, this.about, this.body);
    this.update();
  }

  update(): void {
    this.row.update();
    const kind = String(this.form.scenario.value([...this.path, "kind"]) ?? UNSET);
    if (kind !== this.shown) this.build(kind);
    else this.inner?.update();
  }

  private build(kind: string): void {
    this.shown = kind;
    this.select.value = kind;
    const found = this.form.kinds(this.family).find((each) => each.kind === kind);
    const unknown = kind === UNSET ? "" : `“${kind}” is code of your own: edit the scenario file.`;
    this.about.replaceChildren(...prose(found?.summary ?? unknown));
    this.inner = found ? new Parameters(this.form, this.path, found.parameters) : null;
    this.body.replaceChildren(...(this.inner ? [this.inner.element] : []));
  }
}
