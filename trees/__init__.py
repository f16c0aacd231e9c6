"""What to do: behaviours, subtrees and tasks."""
