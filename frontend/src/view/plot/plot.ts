// A plot against time, trials or anything else: uPlot with the page's colours, axes and cursor.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { el } from "../../dom";
import { powers, ticks, wholePowers } from "../format";
import type { Look, Marker, Token } from "../look";
import { Legend } from "./legend";
import { drawMarkers } from "./markers";
import { nearest } from "../nearest";
import { simplified } from "./path";
import { follow } from "./pointer";
import { logMarks } from "./range";

export interface Line {
  label: string;
  token: Token;
  values: Float32Array | Float64Array;
  time?: Float64Array; // of its values; left out: those of the plot
  dash?: number[];
  width?: number;
  alpha?: number;
  marker?: Marker;
  says?: (value: number) => string; // what the legend says of a value
  unlisted?: boolean; // not in the legend
}

export interface Scales {
  x: [number, number];
  y: [number, number];
  factor?: number; // ticks of y are written in units of it
  xFactor?: number; // the same for x
}

export interface PlotOptions {
  look: Look;
  height: number;
  xTitle: string | (() => string);
  log?: boolean; // y
  whole?: boolean; // x counts
  dot?: Token; // the colour of the dot of `point`
  seek?: (x: number) => void;
  hover?: (at: [number, number] | null) => void; // with the place under the pointer
  under?: (plot: uPlot) => void; // painted before the lines
  over?: (plot: uPlot) => void; // painted after them
}

const NOTHING = new Float64Array(0);
const FONT = '11px system-ui, -apple-system, "Segoe UI", sans-serif';
const PAUSE = 120; // between two renewals of the legend [ms]
const WHOLE = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/** How the pinned run is drawn: same hue, behind, thin, dashed. */
export const BEHIND = { dash: [4, 3], width: 1, alpha: 0.65 };

export class Plot {
  readonly legend = new Legend();
  readonly host: HTMLElement;
  readonly #options: PlotOptions;
  readonly #line = el("div", { class: "time-cursor", hidden: true });
  readonly #dot = el("div", { class: "dot", hidden: true });
  readonly #resizing: ResizeObserver;
  #plot: uPlot | null = null;
  #x: Float64Array = NOTHING;
  #lines: Line[] = [];
  #made = ""; // the lines that the plot has been made for
  #scales: Scales = { x: [0, 1], y: [0, 1] };
  #cursor: number | null = null;
  #point: [number, number] | null = null;
  #hovered = false;
  #readout = 0; // timer of the next renewal of the legend

  constructor(host: HTMLElement, options: PlotOptions) {
    this.host = host;
    this.#options = options;
    if (options.dot) this.#dot.style.background = `var(--${options.dot})`;
    host.style.minHeight = `${options.height}px`;
    this.#resizing = new ResizeObserver(() => {
      const width = Math.floor(host.clientWidth);
      if (this.#plot && width > 0 && width !== this.#plot.width) this.#plot.setSize({ width, height: options.height });
    });
    this.#resizing.observe(host);
  }

  draw(x: Float64Array, lines: Line[], scales: Scales): void {
    this.#x = x;
    this.#lines = lines;
    this.#scales = scales;
    // A line with times of its own is drawn from these, past uPlot, which knows one row of times only.
    const data = [x, ...lines.map((line) => (line.time ? NOTHING : line.values))] as uPlot.AlignedData;
    const wanted = JSON.stringify(lines.map(({ values: _, time: __, ...line }) => line));
    if (!this.#plot || wanted !== this.#made) {
      this.#made = wanted;
      this.#plot = this.#el(data);
    }
    const plot = this.#plot;
    plot.batch(() => {
      plot.setData(data, false);
      plot.setScale("x", { min: scales.x[0], max: scales.x[1] });
      plot.setScale("y", { min: scales.y[0], max: scales.y[1] });
    });
    this.#read();
  }

  /** Puts the cursor there; the legend says the values at it, a few times a second while it moves. */
  cursor(x: number | null): void {
    this.#cursor = x;
    if (!this.#plot) return;
    const outside = x === null || x < this.#scales.x[0] || x > this.#scales.x[1];
    this.#line.hidden = outside;
    if (outside) return;
    this.#line.style.transform = `translateX(${this.#plot.valToPos(x, "x")}px)`;
    if (!this.#hovered) this.#readout ||= window.setTimeout(() => this.#read(), PAUSE);
  }

  /** Puts a dot there, null for none. */
  point(at: [number, number] | null): void {
    this.#point = at;
    this.#dot.hidden = !at;
    if (at && this.#plot)
      this.#dot.style.transform = `translate(${this.#plot.valToPos(at[0], "x")}px, ${this.#plot.valToPos(at[1], "y")}px)`;
  }

  repaint(): void {
    this.#plot?.redraw(false, false);
  }

  destroy(): void {
    this.#resizing.disconnect();
    clearTimeout(this.#readout);
    this.#plot?.destroy();
  }

  /** Has the legend say what is at the cursor. */
  #read(): void {
    clearTimeout(this.#readout);
    this.#readout = 0;
    if (this.#plot && !this.#hovered) this.#write(this.#cursor);
  }

  /** Each line's own value that is nearest. */
  #write(x: number | null): void {
    const says = ({ says, time, values }: Line) => (x === null || !says ? "" : says(values[nearest(time ?? this.#x, x)] ?? NaN));
    this.legend.write(this.#lines.map(says));
  }

  #el(data: uPlot.AlignedData): uPlot {
    this.#plot?.destroy();
    this.legend.list(this.#lines);
    const { look, height, whole, seek } = this.#options;
    const grid = { stroke: () => look.colour("line"), width: 1 };
    const axis: uPlot.Axis = {
      stroke: () => look.colour("faint"),
      font: FONT,
      labelFont: FONT,
      grid,
      ticks: { ...grid, size: 4 },
      gap: 4,
    };
    const plot = new uPlot(
      {
        width: Math.max(80, Math.floor(this.host.clientWidth)),
        height,
        padding: [8, 10, 0, 0],
        legend: { show: false },
        cursor: { y: false, drag: { x: false, y: false }, points: { size: 6 }, bind: { dblclick: () => null } },
        scales: {
          x: { time: false, auto: false, min: this.#scales.x[0], max: this.#scales.x[1] },
          y: { auto: false, distr: this.#options.log ? 3 : 1, min: this.#scales.y[0], max: this.#scales.y[1] },
        },
        axes: [
          {
            ...axis,
            label: this.#options.xTitle,
            labelSize: 16,
            size: 26,
            values: (_, splits) => ticks(splits, this.#scales.xFactor ?? 1),
            ...(whole ? { incrs: WHOLE } : {}),
          },
          {
            ...axis,
            size: 52,
            space: 28,
            ...(this.#options.log
              ? {
                  splits: (_: uPlot, __: number, low: number, high: number) => logMarks(low, high),
                  filter: (_: uPlot, splits: number[]) => splits,
                  grid: { ...grid, filter: (_: uPlot, splits: number[]) => wholePowers(splits) },
                }
              : {}),
            values: (_, splits) => (this.#options.log ? powers(splits) : ticks(splits, this.#scales.factor ?? 1)),
          },
        ],
        series: [{}, ...this.#lines.map((line) => this.#series(line))],
        hooks: {
          drawClear: [(u) => this.#options.under?.(u)],
          draw: [(u) => this.#over(u)],
          setCursor: [(u) => this.#hover(u)],
        },
      },
      data,
      this.host,
    );
    plot.over.append(this.#line, this.#dot);
    if (seek) follow(plot.over, (left) => seek(plot.posToVal(left, "x")));
    return plot;
  }

  #series(line: Line): uPlot.Series {
    return {
      stroke: () => this.#options.look.colour(line.token),
      width: line.width ?? 1.4,
      dash: line.dash ?? [],
      alpha: line.alpha ?? 1,
      paths: (plot, series) => {
        const { time, values } = this.#lines[series - 1]!;
        return simplified(plot, time ?? this.#x, values);
      },
      points: { show: false },
    };
  }

  #over(plot: uPlot): void {
    for (const line of this.#lines) {
      if (line.marker) drawMarkers(plot, line, this.#options.look.colour(line.token), this.#options.look.colour("card"));
    }
    this.#options.over?.(plot);
    this.cursor(this.#cursor);
    this.point(this.#point);
  }

  #hover(plot: uPlot): void {
    const { idx: index, left = -1, top = -1 } = plot.cursor;
    const hovered = index != null;
    if (!hovered && !this.#hovered) return;
    this.#hovered = hovered;
    this.#options.hover?.(hovered ? [plot.posToVal(left, "x"), plot.posToVal(top, "y")] : null);
    if (hovered) this.#write(this.#x[index] ?? null);
    else this.#read();
  }
}
