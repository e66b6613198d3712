// What the page says of itself: the line of status, banners, the warnings of a run.

import { plain, prose } from "../controls/words";
import { el, place, write } from "../dom";
import { readableTime } from "../numbers";
import type { Fault, Picture, Said } from "../protocol";
import { Menu } from "./menu";

const PATIENCE = 600; // ms

export class Status {
  private readonly sentence = place("status");
  private readonly banner = place("banner");
  private readonly warnings = new Menu("");
  private readonly verdict = el("button", {
    type: "button",
    class: "quiet",
    hidden: true,
    onclick: () => place("verdicts").scrollIntoView(),
  });
  private open = true;
  private message = "";
  private timer = 0;

  constructor() {
    this.warnings.element.hidden = true;
    this.sentence.after(this.verdict, this.warnings.element);
  }

  /** Something has been asked for: says so if the answer takes its time. What stood in the banner is over. */
  expect(): void {
    this.timer ||= window.setTimeout(() => this.say("Running."), PATIENCE);
    this.verdict.classList.add("pending");
    this.tell("");
  }

  /** The scenario has no run that anything could be said of. */
  withoutRun(): void {
    this.verdict.hidden = true;
    this.warnings.element.hidden = true;
  }

  /** One sentence, read aloud when the reader is free. */
  say(text: string, bad = false): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.sentence.classList.toggle("bad", bad);
    write(this.sentence, text);
  }

  picture(picture: Picture): void {
    this.say(outcome(picture), picture.status !== "complete");
    const { warnings } = picture;
    this.warnings.element.hidden = warnings.length === 0;
    write(this.warnings.button, warnings.length === 1 ? "1 remark" : `${warnings.length} remarks`);
    this.warnings.panel.replaceChildren(el("ul", {}, ...warnings.map((warning) => el("li", {}, ...prose(warning)))));
  }

  /** How many of the claims hold, or of the audit's findings where there are no claims; null: being worked out. */
  reviewed(review: Extract<Said, { say: "review" }> | null): void {
    this.verdict.classList.toggle("pending", review === null);
    if (review === null) return;
    const [rows, what] = review.claims.length > 0 ? [review.claims, "claims"] : [review.findings, "findings"];
    const judged = rows.filter(({ verdict }) => verdict === "PASS" || verdict === "FAIL");
    const holding = judged.filter(({ verdict }) => verdict === "PASS").length;
    this.verdict.hidden = judged.length === 0;
    write(this.verdict, `${holding} of ${judged.length} ${what} hold`);
  }

  /** The first of what is wrong; `undone` is what has not been done for it. */
  faults([first, ...others]: readonly Fault[], undone: string): void {
    if (!first) return;
    const more = others.length === 0 ? "" : ` And ${others.length} more.`;
    this.say(plain(`${undone}: ${first.at} ${first.text}${more}`.replace(/\s+/g, " ")), true);
  }

  /** More than fits into the line: a banner, which stays until it is taken away with "". */
  tell(text: string): void {
    this.message = text;
    this.showBanner();
  }

  /** The line to the server is there again, or gone. */
  line(open: boolean): void {
    this.open = open;
    this.showBanner();
  }

  private showBanner(): void {
    const text = this.open ? this.message : "The lab has been closed; start `dampen lab` again.";
    this.banner.hidden = text === "";
    write(this.banner, text);
  }
}

/** "25 trials in 41 ms"; or how it ended. */
function outcome({ status, trials, asked, seconds, source }: Picture): string {
  if (status === "diverged") return `The run diverged in trial ${trials}, of ${asked}.`;
  const count = `${trials} ${trials === 1 ? "trial" : "trials"}`;
  if (status === "interrupted") return `Interrupted after ${count} of ${asked}.`;
  const how = source === "file" ? `${count}, from a file` : `${count} in ${readableTime(seconds)}`;
  return status === "constraint_lost" ? `${how}; the constraint was lost` : how;
}
