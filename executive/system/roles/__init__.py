"""What a process of the system can play: one file for each role, found by being here."""
