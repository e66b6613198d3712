// Places among rising numbers.

type Numbers = ArrayLike<number>;

/** The index of the last that is not beyond `at`; -1 where all are. */
export function lastUpTo(rising: Numbers, at: number): number {
  let [low, high] = [0, rising.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rising[middle]! <= at) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** The index of the one nearest to `at`; -1 where `at` is farther beyond the ends than the last lies from the last but one. */
export function nearest(rising: Numbers, at: number): number {
  const last = rising.length - 1;
  const room = last > 0 ? rising[last]! - rising[last - 1]! : Infinity;
  if (!(at >= rising[0]! - room && at <= rising[last]! + room)) return -1;
  const before = Math.max(lastUpTo(rising, at), 0);
  return before < last && rising[before + 1]! - at < at - rising[before]! ? before + 1 : before;
}
