"""What a study of many runs leaves for people to read."""
