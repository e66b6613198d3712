// Values at uneven places on the even rows of an image.

/** Rows of an image, each between two of the places; with the room that the image takes so that each value is centred on its place. */
export interface Grid {
  readonly places: number; // how many there are
  readonly before: Int32Array;
  readonly share: Float32Array; // of the way from the place before to the next one
  readonly low: number; // edges of the image
  readonly high: number;
}

/** A row for each place where they are even; as many more as are needed to tell the closest ones apart where they are not. */
export function gridOf(places: ArrayLike<number>, most: number): Grid {
  const last = places.length - 1;
  const [first, whole] = [places[0]!, places[last]! - places[0]!];
  let closest = Infinity;
  for (let i = 0; i < last; i++) closest = Math.min(closest, places[i + 1]! - places[i]!);
  const gaps = whole > 0 ? Math.max(1, Math.min(Math.round(whole / closest), most - 1)) : 0;
  const before = new Int32Array(gaps + 1);
  const share = new Float32Array(gaps + 1);
  for (let row = 0, k = 0; row <= gaps; row++) {
    const at = first + (gaps > 0 ? (row / gaps) * whole : 0);
    while (k < last - 1 && places[k + 1]! <= at) k++;
    before[row] = k;
    share[row] = last > 0 ? Math.min((at - places[k]!) / (places[k + 1]! - places[k]!), 1) : 0;
  }
  const room = gaps > 0 ? whole / gaps / 2 : 0;
  return { places: places.length, before, share, low: first - room, high: places[last]! + room };
}
