"""A timed elastic band: the base's way among people, poses and times optimised together.

Sources: Rösmann, Feiten, Wösch, Hoffmann and Bertram, "Trajectory modification considering dynamic
constraints of autonomous robots", ROBOTIK 2012; Rösmann, Hoffmann and Bertram, "Integrated online trajectory
planning and optimization in distinctive topologies", Robotics and Autonomous Systems 88, 2017. How the base
uses it: docs/people.md.

- ``timed``: a band and the speeds that follow from it; ``limits``: what it is held to.
- ``terms``: what is minimised, with its derivatives; ``optimise``: damped Gauss-Newton, many bands at once.
- ``judge``: whether a band may be driven, and what it costs.
- ``routes``: bands to begin with (along the path, later, left and right of somebody), and old ones.
- ``elastic``: keeps the routes from plan to plan, takes the best; ``bend``: speeds for the wheels from it.
"""
