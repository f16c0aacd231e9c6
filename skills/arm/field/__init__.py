"""The improved potential field of one arm (two-arm thesis, 2.4 and 4.2).

The skill: approach, episode, approach_steps, approach_context, teller.
Where to: target, ends, escape, hand_surroundings.
The field: potential, desired_twist, velocities, field_controller, live.
Set-points: reference, setpoints, setpoint_guard, record, progress.
"""
