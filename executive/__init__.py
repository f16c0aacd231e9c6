"""The task executive: its service, its command, and what puts whole systems together."""
