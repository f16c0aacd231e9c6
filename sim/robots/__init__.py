"""The robots that the sim can stand in for: one file each, found by being here.

``robot.py`` says what such a file declares, ``registry.py`` finds them. Parts that several robots share:
``pmb2.py``, ``tiago_upper.py``,
``parallel_gripper.py``, ``sensors.py``, ``joint_limits.py`` and ``finishing.py``.
"""
