"""The improved potential field of one arm (document 002, 2.4 and 4.2)."""
