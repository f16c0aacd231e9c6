"""The stand-in for the hardware: a pybullet world that speaks the hardware's messages."""
