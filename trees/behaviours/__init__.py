"""Kinds of behaviours that leaves and subtrees are made of.

Leaves: act, check, decide, note, give_up, pause, stay, wait_for, ask.
Again and otherwise: again, each, recovery, give_way, remember.
While something goes on: guarded, interruptible, meanwhile, phase, watching.
Beside each other: side_by_side, barrier, take_turns.
"""
