// The address of the page follows its state, so that a reload, a bookmark or a copy of it brings everything back.

import { fromHash, type Linked, toHash } from "./link";

const PAUSE = 600; // ms: browsers allow the address to change only so often

export class Address {
  private timer = 0;

  constructor(private readonly state: () => Linked) {}

  /** What the address holds; null where there is nothing. Throws where it is broken. */
  read(): Promise<Linked | null> {
    return fromHash(location.hash);
  }

  /** The state has changed: writes it once it rests. */
  renew(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.write(), PAUSE);
  }

  async write(): Promise<void> {
    history.replaceState(null, "", await toHash(this.state()));
  }
}
