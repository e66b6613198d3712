"""The time axis (kernel, compiled) and the trial axis (trials), and the result."""
