"""ROS 2 robots without ROS: topics over rmw_zenoh on one side, the hardware's keys on the other.

Words of rmw_zenoh: ``types`` (type names and hashes), ``naming`` (keys, liveliness tokens, attachments),
``cdr`` (payloads, by rosbags), ``node`` (publishers and subscriptions over a ``link``, the port to zenoh).
The robot: ``mapping`` (the YAML file), ``stamps`` (ROS time to robot time), ``messages`` (their fields),
``readings``, ``poses``, ``frames`` and ``pictures`` (messages to readings), ``inputs`` (each topic to its
key), ``wheels`` (velocities to ``cmd_vel``, with the dead-man), ``driver`` (the node that is the robot's
hardware).
"""
