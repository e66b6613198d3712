// The sections of the form, in the order in which they stand.

import type { Table, Type } from "../protocol";
import { Chains } from "./chains";
import { Parameters } from "./component";
import type { Field, Form } from "./form";
import { KindField } from "./kind";
import { TableField } from "./tablefield";

export interface SectionPlan {
  /** The table of the scenario that the section is about. */
  key: string;
  title: string;
  make(form: Form): Field;
  /** A remark that depends on the rest of the scenario; "" for none. */
  remark?(table: Table): string;
  /** Left away until the scenario has such a table, or one is added. */
  onDemand?: boolean;
}

const ofKind = (key: string, title: string): SectionPlan => ({
  key,
  title,
  make: (form) => {
    const type = { is: "kind", family: key } as const;
    return new KindField(form, [key], { name: "kind", type, unit: "", doc: "", range: {}, required: true }, key);
  },
});

const chains = (key: string, title: string): SectionPlan => ({ key, title, make: (form) => new Chains(form, [key], key) });

const ofParameters = (key: string, title: string): SectionPlan => ({
  key,
  title,
  make: (form) => new Parameters(form, [key], form.schema.tables[key]?.parameters ?? []),
});

/** The load along the structure, beside the ports' own disturbances. */
const LOAD = { f: "N/m" };

const bounds: SectionPlan = {
  key: "bounds",
  title: "Bounds",
  make: (form) => {
    const type: Type = { is: "table", of: { is: "number" } };
    const doc = "what the controller is told of the disturbances: at each port, and along the structure";
    const described = { name: "bounds", type, unit: "N, N m", doc, range: { ge: 0 }, required: false };
    return new TableField(form, ["bounds"], described, { is: "number" }, LOAD);
  },
};

const isSampled = ({ numerics }: Table): boolean =>
  typeof numerics === "object" && !Array.isArray(numerics) && numerics.mode === "sampled";

export const SECTIONS: readonly SectionPlan[] = [
  ofKind("controller", "Controller"),
  chains("actuator", "Actuators"),
  { ...chains("compensation", "Compensation"), onDemand: true },
  ofKind("disturbance", "Disturbance"),
  ofKind("plant", "Plant"),
  ofParameters("task", "Task"),
  bounds,
  {
    ...ofParameters("sampling", "Sampling"),
    remark: (table) => (isSampled(table) ? "" : "Without effect while numerics.mode is not “sampled”."),
  },
  ofParameters("numerics", "Numerics"),
  ofParameters("output", "Output"),
];
