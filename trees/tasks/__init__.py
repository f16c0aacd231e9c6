"""One file a task; a task is found by being here."""
