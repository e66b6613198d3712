"""Signals on the clock of the trial: what the tip is to follow, how a limit moves, a feedforward."""
