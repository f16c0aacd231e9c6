"""Paths without collision: the only home of OMPL."""
