"""The audit of a run: what holds, what does not, and the numbers that say so."""
