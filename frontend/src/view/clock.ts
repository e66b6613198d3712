// Playing: time goes on, trial after trial, and round again at the end.

export interface Instant {
  trial: number;
  time: number;
}

/** `now`, so many seconds of the run later; in a run of `trials` trials of `duration` seconds, from the end back to the start. */
export function later(now: Instant, seconds: number, trials: number, duration: number): Instant {
  const whole = trials * duration;
  const at = (now.trial * duration + now.time + seconds) % whole;
  const trial = Math.min(Math.floor(at / duration), trials - 1);
  return { trial, time: Math.min(Math.max(at - trial * duration, 0), duration) };
}

/** The place of a time on the axis of the whole run; the end of a trial belongs to it, not to the next. */
export function instantOf(at: number, trials: number, duration: number): Instant {
  const trial = Math.min(Math.max(Math.floor(at / duration), 0), trials - 1);
  return { trial, time: Math.min(Math.max(at - trial * duration, 0), duration) };
}
