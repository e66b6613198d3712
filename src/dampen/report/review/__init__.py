"""The review of a run: what holds, what does not, why; its tables and figures."""
