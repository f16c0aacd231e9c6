"""What is recorded of a running system: logs, metrics, traces."""
