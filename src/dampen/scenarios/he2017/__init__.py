"""He et al. 2017: the scenario, its claims and its figures."""
