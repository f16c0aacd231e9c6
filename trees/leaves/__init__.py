"""Leaves that act: one goal of one skill each. ``hand/`` has those of one hand among two.

See: look, look_round, look_closely, look_at_slot, look_at_table, track, turn_head.
Drive: drive, go, follow, rotate, localise.
Choose: survey, choose_arm, bind_slot, slot_is_free, within_reach.
Move a hand: move_hand, pre_grasp, reach, retract, place_above, put_down, withdraw, retreat, tuck_arm.
Grip: grip, open_hand, edit_scene.
Both arms: coordinate, two_hands.
"""
