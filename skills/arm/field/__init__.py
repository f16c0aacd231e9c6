"""The improved potential field of one arm (two-arm thesis, 2.4 and 4.2)."""
