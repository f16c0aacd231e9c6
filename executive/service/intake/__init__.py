"""From bytes to an accepted request."""
