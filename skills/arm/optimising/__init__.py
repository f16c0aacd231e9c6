"""Paths that are optimised as a whole: STOMP and CHOMP.

What is asked of the world: ``spaces``. What a path costs: ``smoothness``, ``obstacle_cost``. The methods:
``chomp``, ``stomp``. From where to where, and when it is good enough: ``first_guess``, ``optimised``.

Paths are arrays in weighed joint positions, x = w * q (metres, see ``planning/motions.py``), so that a step
of one joint weighs as much as one of another that moves the arm as far.
"""
