"""Both arms at once: workspace zones, coordination, two hands on one thing."""
