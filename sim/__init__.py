"""The stand-in for the hardware: a pybullet world that speaks the hardware's messages.

The whole: station, stationed (one robot of it), hardware, parts, rest, pace, told_together, controls,
chatter.
The robot: robot, model, urdf, meshes, postures, footprint, body.
Controllers: joints, motors, gripper, base, spline.
Sensors: camera, render, render_world, pixels, lens, laser, wrench, range_sensor, cliff_sensor, pose_sensor,
robot_sensor, sensor_nodes, sensing.
The room: scenario, demonstration, starts, wanderer, scene, world, room, things, tags, placing,
floor_plan, draw.
People: people, crowd, walker, walker_body.
Physics and truth: physics, diverging, truth, disturbances.
Faults: faults, trouble, events, defects, faulty_link.
"""
