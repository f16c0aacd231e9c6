"""The base: where the robot is, and how it gets elsewhere.

Skills: drive, rotate, localise, process.
Where the robot is: whereabouts; localiser, matcher, search, scan, odometry, odometry_drift, map, field,
floor; fixed.
The way: planner, quicker, path, journey, journey_context, leg, headway, obstacles, occupied, cliffs, ranger;
``people/`` has who walks about, ``band/`` how the path is left for them.
Where nothing is mapped: pose_filter, surround, macros, go, company, follow_robot, sights, way_back.
Driving it: with_wheels, wheels_run, path_follower, ending, wheels, guard, way_watch, status;
``reflexes/`` take the wheels from it.
"""
