"""One module per view: what a figure shows, and the sentence that says it."""
