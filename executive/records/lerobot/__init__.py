"""Records as a LeRobot v3 data set: each task an episode, each leaf that ran a subtask."""
