"""What is typed once and read by several rooms: how a run is wanted, what a process is told."""
