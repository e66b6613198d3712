"""Scenario files to objects, and the scenarios that ship with the package."""
