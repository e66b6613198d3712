"""Figures of a study, one a file: each takes the study and gives the figure and a sentence about what it shows."""
