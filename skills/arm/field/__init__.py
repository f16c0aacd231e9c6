"""The improved potential field of one arm (two-arm thesis, 2.4 and 4.2).

The skill: approach, episode, ride, parts, teller.
Where to: target, ends, escape, around.
The field: potential, desired_twist, velocities, field_controller, live.
Set-points: reference, motion, guard, record, progress.
"""
