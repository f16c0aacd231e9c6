"""Kinds of behaviours that leaves and subtrees are made of."""
