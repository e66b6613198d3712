// A value that may take one of several forms: a number, a list, a table, a signal.

import { el } from "../dom";
import { formatPath, isTable, type Path } from "../path";
import type { Type, Value } from "../protocol";
import { Parameters } from "./component";
import type { Described, Field, Form } from "./form";
import { makeField } from "./makefield";
import { formName, prose } from "./words";

export class AnyField implements Field {
  readonly element = el("div", {});
  private readonly select: HTMLSelectElement;
  private chosen = -1;
  private inner: Field | null = null;
  private seen: Value | undefined;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    private readonly parameter: Described,
    private readonly types: readonly Type[],
  ) {
    const open = types.filter(({ is }) => is !== "function");
    const options = types.map((type, index) => el("option", { value: index, disabled: type.is === "function" }, formName(type)));
    const label = { "aria-label": `${parameter.name}: form`, "data-form": formatPath(path) };
    this.select = el("select", { class: "form", ...label }, ...options);
    this.select.addEventListener("change", () => this.choose(Number(this.select.value)));
    this.select.hidden = open.length < 2;
    this.update();
  }

  update(): void {
    const value = this.form.scenario.value(this.path);
    // A form that was chosen while nothing is set stays until something else is.
    const keep = this.chosen >= 0 && value === this.seen && value === undefined;
    this.seen = value;
    const fitting = keep ? this.chosen : this.formOf(value ?? this.parameter.default);
    if (fitting !== this.chosen) this.build(fitting);
    else this.inner?.update();
  }

  private formOf(value: Value | undefined): number {
    const found = this.types.findIndex((type) => value !== undefined && fits(type, value));
    const code = typeof value === "string" ? this.types.findIndex(({ is }) => is === "function") : -1;
    return found >= 0 ? found : Math.max(0, code);
  }

  private build(form: number): void {
    const type = this.types[form];
    if (!type) return;
    this.chosen = form;
    this.select.value = String(form);
    const { default: standard, ...rest } = this.parameter;
    const usual = standard !== undefined && fits(type, standard) ? { default: standard } : {};
    const described = { ...rest, ...usual, type };
    this.inner = type.is === "component" ? new Unfolded(this.form, this.path, type) : makeField(this.form, this.path, described);
    this.element.replaceChildren(this.inner.element);
    // Beside the name of what it is a form of.
    this.element.querySelector(".naming")?.append(this.select);
  }

  /** Another form keeps what of the value has a meaning in it. */
  private choose(form: number): void {
    const type = this.types[form];
    if (!type) return;
    const value = converted(this.form.scenario.value(this.path) ?? this.parameter.default, type, this.form);
    this.build(form);
    if (value === undefined) this.form.scenario.remove(this.path);
    else this.form.scenario.set(this.path, value);
    this.seen = this.form.scenario.value(this.path);
    if (this.chosen !== form) this.build(form);
    this.select.focus();
  }
}

/** The parameters of a component whose name has been given by the row above. */
class Unfolded implements Field {
  readonly element: HTMLElement;
  private readonly inner: Parameters;

  constructor(form: Form, path: Path, type: Extract<Type, { is: "component" }>) {
    this.inner = new Parameters(form, path, type.parameters);
    const name = String(path[path.length - 1]);
    this.element = el(
      "div",
      { class: "unfolded", "data-group": "", role: "group", "aria-label": name },
      el("div", { class: "naming" }, el("span", { class: "name" }, name)),
      el("p", { class: "about" }, ...prose(type.summary)),
      el("p", { class: "error", "data-error": formatPath(path) }),
      this.inner.element,
    );
  }

  update(): void {
    this.inner.update();
  }
}

function fits(type: Type, value: Value): boolean {
  switch (type.is) {
    case "number":
    case "integer":
      return typeof value === "number";
    case "boolean":
      return typeof value === "boolean";
    case "text":
    case "file":
      return typeof value === "string";
    case "choice":
      return typeof value === "string" && type.of.includes(value);
    case "list":
      return Array.isArray(value) && value.every((item) => fits(type.of, item));
    case "kind":
      return isTable(value) && "kind" in value;
    case "table":
    case "component":
      return isTable(value) && !("kind" in value);
    case "any":
      return type.of.some((inner) => fits(inner, value));
    case "function":
      return false;
  }
}

/** `value` in another form: a number becomes a list of it, a list its last number, a table the parameter it must have. */
function converted(value: Value | undefined, type: Type, form: Form): Value | undefined {
  const number = Array.isArray(value) ? value[value.length - 1] : value;
  switch (type.is) {
    case "number":
    case "integer":
      return typeof number === "number" ? number : undefined;
    case "list":
      return typeof number === "number" && type.of.is === "number" ? [number] : undefined;
    case "kind": {
      const [first] = form.kinds(type.family);
      return first && { kind: first.kind };
    }
    case "component": {
      const needed = type.parameters.find(({ required }) => required);
      return needed && number !== undefined && fits(needed.type, number) ? { [needed.name]: number } : undefined;
    }
    default:
      return undefined;
  }
}
