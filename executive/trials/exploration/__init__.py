"""Trees tried with mocked skills: each leaf fails in each way, and the task must end."""
