"""The base's reflexes, one a file."""
