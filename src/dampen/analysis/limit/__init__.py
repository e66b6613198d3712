"""The least that any forces at the same ports could reach, knowing the disturbance in advance."""
