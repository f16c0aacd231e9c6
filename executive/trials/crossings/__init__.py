"""Drives among people: draws, rig (the base alone in the simulated room), witness, run, summary."""
