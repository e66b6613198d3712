"""What is kept of a trial when figures of merit are all that is wanted: a few numbers for each port. Compiled before use."""

from __future__ import annotations

import math

from dampen.simulation.ports import PORTS

BY_PORT = ("peak", "mean_square", "share", "mean_square_force", "variation", "stuck")
WHOLE = ("energy", "unsettled", "steps")
PEAK, MEAN_SQUARE, SHARE, MEAN_SQUARE_FORCE, VARIATION, STUCK = range(len(BY_PORT))
ENERGY, UNSETTLED, STEPS = range(len(WHOLE))


def tally(record, low, high, done, before, by_port, whole):
    """Write the figures of a trial of `done` steps.

    by_port, (ports, BY_PORT): largest |error|, mean square error, largest share of the constraint that was used, mean square
    of the delivered force, total variation of the command (from `before`, the last one of the trial before, unless nan), share
    of steps in which the port stuck.   whole, (WHOLE,): mean energy, steps that did not settle, steps done.
    low, high: (steps + 1, ports) limits of the error.
    """
    for p in range(PORTS):
        of_error(record, low, high, done, p, by_port[p])
        of_force(record, done, p, before, by_port[p])
    energy = 0.0
    for k in range(done + 1):
        energy += record.energy[k]
    whole[ENERGY], whole[UNSETTLED], whole[STEPS] = energy / (done + 1), record.unsettled[0], done


def of_error(record, low, high, done, p, figures):
    """The figures of port p that come from its tracking error, at times."""
    peak, square, share = 0.0, 0.0, 0.0
    for k in range(done + 1):
        error = record.y[k, p]
        square += error * error
        peak = max(peak, abs(error))
        limit = high[k, p] if error >= 0.0 else low[k, p]
        if abs(error) > share * abs(limit):
            share = error / limit
    figures[PEAK], figures[MEAN_SQUARE], figures[SHARE] = peak, square / (done + 1), share


def of_force(record, done, p, before, figures):
    """The figures of port p that come from command and force, at steps; `before` goes on to the last command."""
    force, variation, stuck, last = 0.0, 0.0, 0, before[p]
    for k in range(done):
        delivered, command = record.delivered[k, p], record.command[k, p]
        force += delivered * delivered
        if not math.isnan(last):
            variation += abs(command - last)
        last = command
        stuck += record.v[k, p] == 0.0
    steps = max(done, 1)
    before[p] = last
    figures[MEAN_SQUARE_FORCE], figures[VARIATION], figures[STUCK] = force / steps, variation, stuck / steps
