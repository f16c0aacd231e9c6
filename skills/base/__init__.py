"""The base: where the robot is, and how it gets elsewhere."""
