"""What shakes the structure."""
