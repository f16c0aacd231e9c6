"""What clients ask of a task that is there: verbs and queries."""
