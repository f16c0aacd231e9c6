"""Kinematics and collision: the only home of pinocchio and coal.

The robot: model, described, transforms, hulls, extent, lever_arms.
Where a hand gets: ik, follow, batch.
What touches what: collision, bodies, pairs, clearance, proximity.
Many at once: distance_field, moving_spheres.
"""
