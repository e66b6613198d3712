"""What leaves the house: controllers and structures for benches, simulators and other people's tools."""
