"""The sampled controller as C99."""
