"""Kinematics and collision: the only home of pinocchio and coal.

The robot: model, described, transforms, hulls, extent, levers.
Where a hand gets: ik, follow, batch.
What touches what: collision, bodies, pairs, clearance, proximity.
"""
