"""What the ports are to follow."""
