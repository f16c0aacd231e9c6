"""Leaves of one hand among two: each is made for a side, which is a part of its name."""
