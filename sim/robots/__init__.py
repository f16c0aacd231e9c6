"""The robots that the sim can stand in for: one file each, found by being here.

Robots: tiago_dual, tiago, tiago_base, panda, p3dx, summit_xl, locobot.
What such a file declares is in robot; registry finds them, model_check says what does not fit.
Parts that several share: pmb2, tiago_upper, wx250s, parallel_gripper, sensors, primitives, joint_limits,
finishing.
"""
