"""Subtrees: one step of a task each.

A fetch: request, search, get_item, stand, pick, place, home, put_back.
Two arms: two_arms, hand_pick, both_pick, rise, bring_safe.
On wheels: travel.
Shared: arms_in, recovery_steps, see_the_way.
"""
