"""The robots that the sim can stand in for: one file each, found by being here.

``robot.py`` says what such a file declares, ``registry.py`` finds them. ``pmb2.py``, ``tiago_upper.py``,
``parallel_gripper.py`` and ``sensors.py`` are parts that several robots share.
"""
