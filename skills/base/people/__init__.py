"""People: who is there, where they will be, and how the base keeps out of their way.

Seeing: segments (of one scan), still (where furniture stands), track (one person over time), tracker (the
monitor).
Keeping away: forecast (where they will be), cost (how near is too near), caution (how fast the base may go).
"""
