// What page and server say to each other. Text messages are JSON; what carries arrays is one binary frame:
//
//   uint32  length of the header, little-endian
//   header  JSON, UTF-8, padded with spaces so that the arrays begin at a multiple of 8
//   arrays  float32 or float64, little-endian, each at the offset that the header's `arrays` gives it

/** A scenario as a TOML file holds it: tables, lists, numbers, strings, booleans. */
export type Value = number | string | boolean | Value[] | Table;
export type Table = { [key: string]: Value };

/** The type of one parameter, as the code declares it. */
export type Type =
  | { is: "number" }
  | { is: "integer" }
  | { is: "boolean" }
  | { is: "text" }
  | { is: "file" } // the name of an attachment
  | { is: "function" } // code of the user's own: never from a browser
  | { is: "choice"; of: string[] }
  | { is: "list"; of: Type }
  | { is: "table"; of: Type } // by port, or by any other name
  | { is: "component"; summary: string; parameters: Parameter[] } // a table without `kind`
  | { is: "kind"; family: string } // a table whose `kind` is one of schema.kinds[family]
  | { is: "any"; of: Type[] };

export interface Parameter {
  name: string;
  type: Type;
  required: boolean;
  default?: Value; // left out: there is none, the parameter is optional
  unit: string;
  doc: string;
  range: { gt?: number; ge?: number; lt?: number; le?: number };
}

export interface Kind {
  kind: string;
  summary: string;
  parameters: Parameter[];
}

export interface Palette {
  displacement: string;
  rotation: string;
  uncontrolled: string;
  constraint: string;
  learned: string;
  reference: string;
  ink: string;
  faint: string;
  paper: string;
}

/** GET /schema */
export interface Schema {
  version: string;
  scenarios: { name: string; title: string }[];
  kinds: { [family: string]: Kind[] }; // plant, actuator, compensation, disturbance, controller, signal
  tables: { [name: string]: { summary: string; parameters: Parameter[] } }; // task, sampling, numerics, output
  colours: { light: Palette; dark: Palette };
}

/** GET /start: what the command line asked for.  GET /scenario/NAME: a shipped one.  POST /read: an uploaded TOML file. */
export interface Opened {
  name: string;
  table: Table;
  token?: string; // a stored result to be shown first (see `open`)
}

/** One fault, and the field that it belongs to: a path such as "actuator.all.chain[0].slope"; "" for the whole. */
export interface Fault {
  at: string;
  text: string; // "must be > 0, but is -1."
}

export type Asked =
  | { do: "run"; id: number; table: Table; trial: number } // trial: the one that is being looked at
  | { do: "open"; id: number; token: string; trial: number };

export type Said =
  | { say: "refused"; id: number; faults: Fault[] }
  | { say: "failed"; id: number; text: string } // the server's own trouble, or a limit of the server
  | { say: "note"; id: number; text: string } // "Compiling the simulation kernel; ..."
  | { say: "review"; id: number; verdict: string; claims: Row[]; audit: string; findings: Row[] }
  | { say: "complete"; id: number } // every trial has been sent, and the review
  | { say: "left"; id: number }; // broken off for something newer; ask again for what is missing

/** A claim or a finding. */
export interface Row {
  section: string;
  id: string;
  statement: string;
  criterion: string;
  measured: string;
  verdict: "PASS" | "FAIL" | "n/a" | "note";
}

export interface Port {
  name: string;
  field: string; // the field that it is the end of, "" for none
  x: number; // where it acts [m]
  kind: "force" | "torque";
  motion_unit: string; // "m", "rad"
  effort_unit: string; // "N", "N m"
  symbol: string; // "w(L, t)"
}

export interface Picture {
  say: "picture";
  id: number;
  name: string;
  title: string;
  source: "run" | "file";
  status: "complete" | "constraint_lost" | "diverged" | "interrupted";
  warnings: string[];
  trials: number; // finished
  asked: number; // asked for
  duration: number; // of a trial [s]
  steps: number; // of a trial
  step: number; // [s]
  span: number; // length of the structure [m]
  tip: { mass: number; inertia: number }; // payload [kg, kg m^2]; 0 for none
  clamped: "clamped" | "pinned" | "free"; // the base: whether it turns
  ports: Port[];
  fields: { name: string; unit: string }[];
  gains: number[]; // by port, slope of the whole actuator chain in full motion
  sampled: boolean;
  controlled: boolean;
  tracking: boolean; // whether there is a reference
  reset: boolean; // whether trials start afresh
  seconds: number; // what the run took
  energy: { [name: string]: number | null }; // the account [J], see `energy_account`; null: not finite
  sliders: { [path: string]: { low: number; high: number; log: boolean } }; // ranges that the code itself would search
  trial: number; // the trial that comes with it: its arrays are the same as those of a `trial` frame
  arrays: { [name: string]: { type: "f4" | "f8"; shape: number[]; at: number } };
}

// Arrays of a picture. B = buckets in a trial, each with its smallest and its largest value in order of time, so that no peak is
// lost; P = ports, X = points along the structure, N = steps, S = snapshots.
//
//   time (B,)                    middle of a bucket [s]
//   all.y, all.reference, all.low, all.high, all.command, all.delivered (trials, B, 2, P)
//   all.energy (trials, B, 2)
//   peaks (trials, P) f8         largest |tracking error| of each trial, as `error_peaks` gives it
//   x (X,)                       points along the structure [m]
//   all.FIELD (trials, C, X)     each field, in C columns a trial: the value of largest modulus in each
//   time_out (S,)                times of the snapshots of a trial [s]
//   y, low, high (N + 1, P), reference (N + 1, P), command, delivered (N, P), energy, barrier (N + 1,), FIELD (S, X): the trial
//
// `reference` is there where `tracking` is true; `low`, `high` are infinite where a port has no constraint.

export interface Detail {
  say: "trial";
  id: number;
  trial: number;
  arrays: Picture["arrays"];
}

export interface Framed<Header> {
  header: Header;
  array(name: string): Float32Array | Float64Array;
  shape(name: string): number[];
  has(name: string): boolean;
}

/** A binary frame, its arrays as views of the buffer. */
export function unframe(buffer: ArrayBuffer): Framed<Picture> | Framed<Detail> {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))) as Picture | Detail;
  const start = 4 + length;
  const entry = (name: string) => {
    const found = header.arrays[name];
    if (!found) throw new Error(`The frame has no array ${name}.`);
    return found;
  };
  return {
    header,
    has: (name: string) => name in header.arrays,
    shape: (name: string) => entry(name).shape,
    array: (name: string) => {
      const { type, shape, at } = entry(name);
      const size = shape.reduce((product, n) => product * n, 1);
      return type === "f4" ? new Float32Array(buffer, start + at, size) : new Float64Array(buffer, start + at, size);
    },
  } as Framed<Picture> | Framed<Detail>;
}
