"""What leaves for other tools: plants and controllers as models and code."""
