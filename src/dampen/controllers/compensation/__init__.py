"""Inverses that stand between a law and its actuator, each with its own idea of what the actuator does."""
