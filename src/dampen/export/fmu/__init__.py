"""Plant, sampled controller, or both in closed loop as a functional mock-up unit (FMI 2.0, co-simulation), with C inside."""
