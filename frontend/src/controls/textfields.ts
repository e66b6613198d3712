// What is typed as text: words, lists of numbers or words, matrices.

import { el } from "../dom";
import { parseNumber } from "../numbers";
import { formatPath, type Path } from "../path";
import type { Type, Value } from "../protocol";
import type { Described, Field, Form } from "./form";
import { Row } from "./row";
import { onTyped } from "./typed";
import { isEmpty } from "./words";

/** How a value of one type is written in a text field. */
interface Notation {
  write(value: Value): string;
  /** Throws an Error that says what is wrong. */
  read(text: string): Value;
}

const words: Notation = { write: String, read: (text) => text.trim() };

const list = (of: Type): Notation => ({
  write: (value) => (Array.isArray(value) ? value.map(String).join(", ") : String(value)),
  read: (text) => {
    const items = text
      .replace(/^\s*\[|\]\s*$/g, "")
      .split(/[,;]/)
      .map((item) => item.trim())
      .filter(Boolean);
    if (of.is === "integer") return items.map(whole);
    return of.is === "number" ? items.map(number) : items;
  },
});

const matrix: Notation = {
  write: (value) => JSON.stringify(value),
  read: (text) => {
    try {
      // What is beyond all numbers, such as 1e400, would reach the server as null.
      if (JSON.stringify(JSON.parse(text)).includes("null")) throw new Error();
      return JSON.parse(text) as Value;
    } catch {
      throw new Error("Write rows of numbers in brackets: [[1, 0], [0, 1]].");
    }
  },
};

function number(text: string): number {
  const value = parseNumber(text);
  if (value === undefined) throw new Error(`“${text}” is not a number.`);
  return value;
}

function whole(text: string): number {
  const value = number(text);
  if (!Number.isSafeInteger(value)) throw new Error(`“${text}” is not a whole number, or too large.`);
  return value;
}

function notationOf(type: Type): Notation {
  if (type.is !== "list") return words;
  return type.of.is === "list" ? matrix : list(type.of);
}

export class TextField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly input: HTMLInputElement;
  private readonly notation: Notation;
  /** The value that the text in the field stands for. */
  private shown: Value | undefined;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
  ) {
    const { required, default: standard, type } = parameter;
    this.notation = notationOf(type);
    this.row = new Row(form, path, parameter);
    this.element = this.row.element;
    const usual = standard === undefined || isEmpty(standard) ? "" : this.notation.write(standard);
    this.input = el("input", {
      type: "text",
      placeholder: required ? "needed" : usual || (type.is === "list" ? "none" : "left out"),
      "aria-required": required ? "true" : undefined,
      ...this.row.control,
    });
    this.row.body.append(this.input);
    onTyped(
      this.input,
      () => this.typed(),
      () => form.scenario.settle(),
    );
    this.update();
  }

  update(): void {
    this.row.update();
    const given = this.form.scenario.value(this.path);
    if (given === this.shown) return;
    this.shown = given;
    this.input.value = given === undefined ? "" : this.notation.write(given);
    this.row.fail("");
  }

  private typed(): void {
    try {
      const empty = this.input.value.trim() === "";
      const value = empty ? undefined : this.notation.read(this.input.value);
      this.row.fail("");
      this.shown = value;
      if (value === undefined) this.form.scenario.remove(this.path);
      else this.form.scenario.set(this.path, value, `type ${formatPath(this.path)}`);
      this.shown = this.form.scenario.value(this.path);
    } catch (error) {
      this.row.fail((error as Error).message);
    }
  }
}
