"""Believe: the keeper of what is known of the world, and the edits that the trees ask for."""
