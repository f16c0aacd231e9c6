"""The executive: requests come in, tasks wait and run, everyone is told."""
