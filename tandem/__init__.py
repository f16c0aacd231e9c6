"""Tandem: the one name under which everything is imported; each room is a folder of the repository."""
