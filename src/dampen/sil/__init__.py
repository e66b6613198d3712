"""Software in the loop: a controller that runs as a program of its own, in lock step with the simulated structure."""
