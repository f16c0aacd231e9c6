"""Arithmetic on poses, chains of joints and the plan of a site, in plain Python."""
