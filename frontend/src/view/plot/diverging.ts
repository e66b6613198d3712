// A diverging map: blue below zero, the panel's own background at zero, red above.

import type { Grid } from "./grid";

type Colour = [number, number, number];

const LIGHT: Colour[] = [
  [5, 48, 97],
  [33, 102, 172],
  [67, 147, 195],
  [146, 197, 222],
  [209, 229, 240],
  [247, 247, 247],
  [253, 219, 199],
  [244, 165, 130],
  [214, 96, 77],
  [178, 24, 43],
  [103, 0, 31],
];
const DARK: Colour[] = [
  [166, 216, 250],
  [110, 182, 235],
  [66, 142, 204],
  [42, 98, 148],
  [31, 58, 86],
  [29, 33, 37],
  [84, 46, 38],
  [148, 66, 50],
  [206, 96, 74],
  [240, 144, 118],
  [255, 200, 180],
];
const SIZE = 256;

/** The colours of 256 values from the lowest to the highest, as ABGR words for image data. */
export function ramp(dark: boolean): Uint32Array {
  const stops = dark ? DARK : LIGHT;
  return Uint32Array.from({ length: SIZE }, (_, i) => {
    const place = (i / (SIZE - 1)) * (stops.length - 1);
    const before = Math.min(Math.floor(place), stops.length - 2);
    const [from, to] = [stops[before]!, stops[before + 1]!];
    const [red, green, blue] = from.map((value, k) => Math.round(value + (place - before) * (to[k]! - value))) as Colour;
    return (255 << 24) | (blue << 16) | (green << 8) | red;
  });
}

/** Values (time, place) as an image with time to the right and place upwards. */
export function paintField(
  image: ImageData,
  values: Float32Array,
  time: Grid,
  place: Grid,
  limit: number,
  colours: Uint32Array,
): void {
  const { width, height } = image;
  const pixels = new Uint32Array(image.data.buffer);
  const scale = limit > 0 ? (SIZE - 1) / (2 * limit) : 0;
  for (let column = 0; column < width; column++) {
    const from = time.before[column]! * place.places;
    const onward = time.share[column]!;
    const to = onward > 0 ? from + place.places : from;
    for (let row = 0; row < height; row++) {
      const [k, up] = [place.before[row]!, place.share[row]!];
      const next = up > 0 ? k + 1 : k;
      const now = values[from + k]! * (1 - up) + values[from + next]! * up;
      const later = onward > 0 ? values[to + k]! * (1 - up) + values[to + next]! * up : now;
      const level = (now + onward * (later - now) + limit) * scale;
      pixels[(height - 1 - row) * width + column] = colours[level < 0 ? 0 : level > SIZE - 1 ? SIZE - 1 : level | 0]!;
    }
  }
}
