// Numbers and units, as they are typed, written and rounded.

const PLAIN = "-0123456789n";
const RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ";

/** "N m^2" as "N m²". */
export const prettyUnit = (unit: string): string =>
  unit.replace(/\^(-?[\dn]+)/g, (_, power: string) => [...power].map((character) => RAISED[PLAIN.indexOf(character)]).join(""));

/** The number that was typed, with a true minus sign as well; undefined where it is none yet, or none that can be held. */
export function parseNumber(text: string): number | undefined {
  const plain = text.trim().replace(/^−/, "-").replace(/e−/i, "e-");
  const number = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
  return Number.isFinite(number) ? number : undefined;
}

/** `value` to so many significant digits. */
export const significant = (value: number, digits: number): number => Number(value.toPrecision(digits));

/** A number for reading, not for typing: with a true minus sign. */
export const readable = (value: number): string => String(significant(value, 6)).replaceAll("-", "−");

/** A duration for reading: "41 ms", "1.3 s". */
export const readableTime = (seconds: number): string =>
  seconds < 1 ? `${Math.max(1, Math.round(seconds * 1000))} ms` : `${seconds.toFixed(seconds < 10 ? 1 : 0)} s`;
