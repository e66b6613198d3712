// The line to the server: the newest question of a lane wins, there as here.

import { type Asked, type Detail, type Framed, type Picture, type Said, unframe } from "./protocol";

type Unnumbered<A> = A extends Asked ? Omit<A, "id"> : never;
export type Question = Unnumbered<Asked>;

/** Questions about the run that is worked on come before those about the run beside it. */
const LANES = ["now", "beside"] as const;
export type Lane = (typeof LANES)[number];

export interface ConnectionEvents {
  picture(frame: Framed<Picture>): void;
  detail(frame: Framed<Detail>): void;
  said(said: Said): void;
  /** The line is there again, or gone. */
  open(open: boolean): void;
}

interface Sent {
  lane: Lane;
  asked: Asked;
  at: number; // [ms]
}

const FIRST_RETRY = 500; // ms
const LONGEST_RETRY = 8000; // ms
/** Most runs are done by then, and are seen; one that takes longer is given up for a newer question [ms]. */
const HOLD = 250;

export class Connection {
  private socket: WebSocket | null = null;
  private retry = FIRST_RETRY;
  private newest = 0;
  /** What has been sent and not been answered, in order. */
  private unanswered: Sent[] = [];
  private readonly waiting: { [lane in Lane]: Asked | null } = { now: null, beside: null };
  private timer = 0;

  constructor(
    private readonly url: string,
    private readonly events: ConnectionEvents,
  ) {
    this.connect();
  }

  /** Asks as soon as nothing else is in flight, or has been for too long, unless something newer comes first. */
  ask(lane: Lane, question: Question): number {
    const id = ++this.newest;
    this.waiting[lane] = { ...question, id };
    this.send();
    return id;
  }

  /** Whether nothing is in flight and nothing waits. */
  get idle(): boolean {
    return this.unanswered.length === 0 && LANES.every((lane) => this.waiting[lane] === null);
  }

  private connect(): void {
    const socket = new WebSocket(this.url);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.socket = socket;
      this.retry = FIRST_RETRY;
      this.events.open(true);
      this.send();
    };
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => this.receive(data);
    socket.onclose = () => this.lost();
  }

  private lost(): void {
    this.socket = null;
    this.askAgain(this.unanswered.splice(0));
    this.events.open(false);
    setTimeout(() => this.connect(), this.retry);
    this.retry = Math.min(2 * this.retry, LONGEST_RETRY);
  }

  private send(): void {
    clearTimeout(this.timer);
    const lane = LANES.find((each) => this.waiting[each] !== null);
    const asked = lane && this.waiting[lane];
    if (!this.socket || !lane || !asked) return;
    const last = this.unanswered.at(-1);
    if (last) {
      // The run beside waits for the one that is worked on, however long that takes.
      if (lane === "beside" && this.unanswered.some((sent) => sent.lane === "now")) return;
      const hold = last.at + HOLD - performance.now();
      if (hold > 0) {
        this.timer = window.setTimeout(() => this.send(), hold);
        return;
      }
    }
    this.waiting[lane] = null;
    this.unanswered.push({ lane, asked, at: performance.now() });
    this.socket.send(JSON.stringify(asked));
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data === "string") {
      const said = JSON.parse(data) as Said;
      if (said.say === "refused" || said.say === "failed" || said.say === "left") this.answered(said.id, said.say !== "left");
      this.events.said(said);
      return;
    }
    const frame = unframe(data);
    if (isPicture(frame)) {
      // The next question goes out before this answer is drawn: the server works while the page draws.
      this.answered(frame.header.id, true);
      this.events.picture(frame);
    } else this.events.detail(frame);
  }

  /** The server answers in order: what was sent before has been overtaken, and gets no answer. `done`: this one got one. */
  private answered(id: number, done: boolean): void {
    const place = this.unanswered.findIndex(({ asked }) => asked.id === id);
    if (place < 0) return;
    this.askAgain(this.unanswered.splice(0, place + 1), done ? id : null);
    this.send();
  }

  /** What is over without an answer is asked again, unless its lane has something newer. */
  private askAgain(over: readonly Sent[], answered: number | null = null): void {
    for (const { lane, asked } of over) {
      const newer = [...over, ...this.unanswered].some((sent) => sent.lane === lane && sent.asked.id > asked.id);
      if (asked.id !== answered && !newer) this.waiting[lane] ??= asked;
    }
  }
}

const isPicture = (frame: Framed<Picture> | Framed<Detail>): frame is Framed<Picture> => frame.header.say === "picture";
