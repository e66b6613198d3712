// What every field of the form knows of the world around it.

import type { ScenarioDocument } from "../document";
import type { Parameter, Picture, Port, Schema } from "../protocol";

/** A part of the form. It is built once; `update` shows the document's present value in it. */
export interface Field {
  readonly element: HTMLElement;
  update(): void;
}

/** Of a parameter: what a field is made for. A port's own field has a narrower unit than the whole table's. */
export type Described = Pick<Parameter, "name" | "type" | "unit" | "doc" | "range" | "required" | "default">;

export class Form {
  ports: readonly Port[] = [];
  /** Ranges that the code itself would search, by path. */
  sliders: Picture["sliders"] = {};

  constructor(
    readonly schema: Schema,
    readonly scenario: ScenarioDocument,
    /** Gives the server a file; the promise is of the name to put into the scenario. */
    readonly attach: (file: File) => Promise<string>,
  ) {}

  kinds(family: string) {
    return this.schema.kinds[family] ?? [];
  }
}
