// The ranges of axes.

type Values = Float32Array | Float64Array;

/** From the smallest to the largest of all finite values, with a little air. */
export function extent(all: Values[], air = 0.07): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const values of all) {
    for (let i = 0; i < values.length; i++) {
      const value = values[i]!;
      if (value < low && value > -Infinity) low = value;
      if (value > high && value < Infinity) high = value;
    }
  }
  if (low > high) return [-1, 1];
  const room = air * (high - low) || Math.abs(high) * 0.5 || 1;
  return [low - room, high + room];
}

/** For a logarithmic axis: of all positive values. */
export function decades(all: Values[]): [number, number] {
  let [low, high] = [Infinity, 0];
  for (const values of all) {
    for (const value of values) {
      if (value > 0 && value < low) low = value;
      if (value > high && value < Infinity) high = value;
    }
  }
  if (high === 0) return [0.1, 10];
  const room = Math.max(1.6, Math.sqrt((10 * low) / high)); // at least a decade
  return [low / room, high * room];
}

const MANY = 10; // decades, above which only powers of ten are marked

/** Marks of a logarithmic axis, exactly: added up they would miss the powers of ten by round-off. */
export function logMarks(low: number, high: number): number[] {
  const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  const leads = last - first > MANY ? [1] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
  const marks: number[] = [];
  for (let exponent = first; exponent <= last; exponent++) {
    for (const lead of leads) {
      const mark = Number(`${lead}e${exponent}`);
      if (mark >= low && mark <= high) marks.push(mark);
    }
  }
  return marks;
}
