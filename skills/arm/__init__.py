"""Moving an arm. ``planning/`` finds ways, ``optimising/`` bends them, ``field/`` follows what moves.

Skills: move, survey, process.
From a goal to a motion: plan_move, problem, scene, finger_space, far_path, curve, timing,
trajectory, retreat, turned, slices.
While it moves: motion, motion_watch, doubt, followed, pushed, right_of_way, silence, status, hand_way.
"""
