"""What is seen and answered at once, at its own rate, beside the tree: arms that would cross."""
