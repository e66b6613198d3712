// Numbers and units as they are written on the page.

const PREFIXES: [number, string][] = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** With a true minus sign, and never a negative zero. */
function signed(text: string): string {
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text.replace("-", "−");
}

/** "10⁻³" */
export function powerOfTen(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((digit) => SUPERSCRIPTS[Number(digit)]).join("");
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** A number with so many significant digits: "0.0123", "1.4 · 10⁻⁷". */
export function number(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent < -4 || exponent > 5) {
    return `${signed((value / 10 ** exponent).toFixed(Math.max(0, digits - 1)))} · ${powerOfTen(exponent)}`;
  }
  return signed(value.toFixed(Math.max(0, digits - 1 - exponent)));
}

/** One unit and one number of decimals for everything up to a largest value, so that numbers that move keep their form. */
export class Measure {
  readonly unit: string; // with its prefix
  readonly factor: number; // value / factor is the number before the unit
  readonly decimals: number;

  constructor(largest: number, unit: string) {
    const size = Math.abs(largest);
    const usable = size > 0 && size < Infinity && unit !== "";
    const [factor, prefix] = (usable && PREFIXES.find(([least]) => size >= least * 0.9995)) || [1, ""];
    this.factor = factor;
    this.unit = prefix + unit;
    const scaled = size / factor;
    this.decimals = scaled > 0 && scaled < Infinity ? Math.min(6, Math.max(0, 2 - Math.floor(Math.log10(scaled)))) : 0;
  }

  number(value: number): string {
    return Number.isFinite(value) ? signed((value / this.factor).toFixed(this.decimals)) : number(value);
  }

  text(value: number): string {
    return `${this.number(value)} ${this.unit}`;
  }
}

/** One value with a prefix of its own: "160 mm". */
export function quantity(value: number, unit: string): string {
  return new Measure(value, unit).text(value);
}

/** Ticks of an axis: as many decimals as their distance asks for. */
export function ticks(values: number[], factor: number): string[] {
  const step = values.length > 1 ? Math.abs(values[1]! - values[0]!) / factor : 1;
  let decimals = 0;
  while (decimals < 8 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals++;
  return values.map((value) => signed((value / factor).toFixed(decimals)));
}

/** The powers of ten among ticks, or all of them where these are few; null for the others. */
export function wholePowers(values: number[]): (number | null)[] {
  const whole = values.map(isPower);
  return whole.filter(Boolean).length < 2 ? values : values.map((value, i) => (whole[i] ? value : null));
}

function isPower(value: number): boolean {
  return Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9;
}

/** Ticks of a logarithmic axis: powers of ten, and what lies between them only where there are few. */
export function powers(values: number[]): string[] {
  const whole = values.map(isPower);
  const few = whole.filter(Boolean).length < 2;
  return values.map((value, i) => {
    if (whole[i]) return powerOfTen(Math.round(Math.log10(value)));
    const lead = Math.round(value / 10 ** Math.floor(Math.log10(value)));
    return few && (lead === 2 || lead === 5) ? `${lead} · ${powerOfTen(Math.floor(Math.log10(value)))}` : "";
  });
}
