"""Many runs: grids, robustness, tuning, on one core or many machines."""
