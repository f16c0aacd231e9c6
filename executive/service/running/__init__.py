"""One tree at work: ticks, halts, pauses, ends.

The task whose turn it is: task_builder, current_task. Its tree: tree_run, tick_timer, tree_view, shown_tree,
pausing, wind_down, endings, time_limits. Of the hardware: emergency_stop, orphaned_goals, sent_goals. What is
kept of it: timeline, failure_pictures. uncollected keeps Python's collector out of a step.
"""
