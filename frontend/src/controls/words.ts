// What the form says of a parameter.

import { inBrief } from "../changes";
import { el } from "../dom";
import { prettyUnit, readable } from "../numbers";
import type { Parameter, Port, Type } from "../protocol";
import type { Described } from "./form";

/** A text of the code's, the names in it set as code. */
export const prose = (text: string): (Node | string)[] =>
  text.split("`").map((part, index) => (index % 2 === 1 ? el("code", {}, part) : part));

/** The same where there is no room for that, without the marks around names. */
export const plain = (text: string): string => text.replaceAll("`", "");

/** Meaning, range and default, as sentences. */
export function describe({ doc, range, default: standard, required, unit }: Described): string {
  const parts = [doc, inWords(range), unit && `In ${prettyUnit(unit)}`];
  if (required) parts.push("Needed");
  else if (!isEmpty(standard)) parts.push(`Default ${typeof standard === "number" ? readable(standard) : inBrief(standard)}`);
  return parts.filter(Boolean).map(asSentence).join(" ");
}

/** "Greater than 0, at most 5". */
function inWords({ gt, ge, lt, le }: Parameter["range"]): string {
  const low = gt !== undefined ? `greater than ${readable(gt)}` : ge !== undefined ? `at least ${readable(ge)}` : "";
  const high = lt !== undefined ? `less than ${readable(lt)}` : le !== undefined ? `at most ${readable(le)}` : "";
  return [low, high].filter(Boolean).join(", ");
}

const asSentence = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1) + (/[.;:!?]$/.test(text) ? "" : ".");

/** Whether a default says nothing: there is none, or it is an empty text, table or list. */
export const isEmpty = (value: Parameter["default"]): boolean =>
  value === undefined || value === "" || (typeof value === "object" && Object.keys(value).length === 0);

/** The unit at one port: that of a table by port names one for forces and one for torques, "N/m, N m/rad". */
export function unitAt(port: Port | undefined, { unit }: Pick<Described, "unit">): string {
  const [force, torque] = unit.split(",").map((part) => part.trim());
  if (torque === undefined) return force ?? "";
  return (port?.kind === "torque" ? torque : port && force) || "";
}

/** The name of a type's form, for choosing between several. */
export function formName(type: Type): string {
  switch (type.is) {
    case "number":
    case "integer":
      return "number";
    case "list":
      return type.of.is === "list" ? "matrix" : "list";
    case "component":
      return "table";
    case "kind":
      return type.family;
    case "function":
      return "code of your own";
    default:
      return type.is;
  }
}
