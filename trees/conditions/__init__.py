"""Conditions: what is believed of the world, one question each."""
