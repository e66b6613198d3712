// The line to the server: one request in flight, and of those that wait in a lane only the newest.

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

const FIRST_RETRY = 500; // ms
const LONGEST_RETRY = 8000; // ms

export class Connection {
  private socket: WebSocket | null = null;
  private retry = FIRST_RETRY;
  private newest = 0;
  private unanswered: { lane: Lane; asked: Asked } | null = null;
  private readonly waiting: { [lane in Lane]: Asked | null } = { now: null, beside: null };

  constructor(
    private readonly url: string,
    private readonly events: ConnectionEvents,
  ) {
    this.connect();
  }

  /** Asks as soon as nothing else is in flight, unless something newer comes first. */
  ask(lane: Lane, question: Question): number {
    const id = ++this.newest;
    this.waiting[lane] = { ...question, id };
    this.send();
    return id;
  }

  /** Whether nothing is in flight and nothing waits. */
  get idle(): boolean {
    return this.unanswered === null && LANES.every((lane) => this.waiting[lane] === null);
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
    if (this.unanswered) {
      const { lane, asked } = this.unanswered;
      this.waiting[lane] ??= asked;
      this.unanswered = null;
    }
    this.events.open(false);
    setTimeout(() => this.connect(), this.retry);
    this.retry = Math.min(2 * this.retry, LONGEST_RETRY);
  }

  private send(): void {
    if (!this.socket || this.unanswered) return;
    const lane = LANES.find((each) => this.waiting[each] !== null);
    const asked = lane && this.waiting[lane];
    if (!lane || !asked) return;
    this.waiting[lane] = null;
    this.unanswered = { lane, asked };
    this.socket.send(JSON.stringify(asked));
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data === "string") {
      const said = JSON.parse(data) as Said;
      if (said.say === "refused" || said.say === "failed" || said.say === "left") this.answered(said.id);
      this.events.said(said);
      return;
    }
    const frame = unframe(data);
    if (isPicture(frame)) {
      // The next question goes out before this answer is drawn: the server works while the page draws.
      this.answered(frame.header.id);
      this.events.picture(frame);
    } else this.events.detail(frame);
  }

  private answered(id: number): void {
    if (this.unanswered?.asked.id !== id) return;
    this.unanswered = null;
    this.send();
  }
}

const isPicture = (frame: Framed<Picture> | Framed<Detail>): frame is Framed<Picture> => frame.header.say === "picture";
