"""Kinematics and collision: the only home of pinocchio and coal.

The robot: model, described, transforms, hulls, extent, lever_arms.
Where a hand gets: ik, hand_following, batch, turning.
What touches what: collision, bodies, pairs, clearance, proximity.
From a distance field: quick, kernel, world_field, distance_field, spheres, balls, pair_tables, forward,
moving_spheres.
"""
