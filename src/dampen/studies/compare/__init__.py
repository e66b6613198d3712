"""Comparisons: one experiment under several controllers, each with gains tuned on the same budget."""
