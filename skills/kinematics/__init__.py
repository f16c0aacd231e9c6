"""Kinematics and collision: the only home of pinocchio and coal."""
