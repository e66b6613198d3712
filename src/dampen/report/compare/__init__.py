"""What a comparison leaves for people to read."""
