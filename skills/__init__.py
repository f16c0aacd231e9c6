"""How the robot does things: skills as generators, one folder a domain.

What turns a skill into an action: server, goal_statuses, ended_goals, goal_journal.
Who moves what: pipeline, claimed, reflexes, reflex_owners, limbs.
What lives for a while: one_boot, scoped_bus.
What people write: yaml_file, site. What is kept on disk: map_file, journal_file, synced_file.
"""
