"""The service: requests in, trees ticked, everyone told."""
