"""What tries the whole: the only room that reads the truth of the simulation."""
