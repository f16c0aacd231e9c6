"""Subtrees: one step of a task each."""
