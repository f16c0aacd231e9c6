"""How the robot does things: skills as generators, one folder a domain."""
