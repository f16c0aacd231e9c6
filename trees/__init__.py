"""What to do: tasks in ``tasks/``, made of ``subtrees/``, ``leaves/``, ``conditions/`` and ``behaviours/``.

Tasks: task, needs, registry, hand_requests; nodes of plug-ins: nodes.
A task's surroundings: context, branch, knowledge, clients, client, resources, elapsed, failure_log,
task_notes, dialogue.
What leaves hand to each other: board, hand_board, hand_task, fetch_notes, inspection, told_board.
The same on wheels: course, rounds, pursuit.
In requests: places, item_number.
Failures: recovery_kinds, item_failures, closing.
A tree as data: node_paths, snapshot, possible, breakpoints; its end: dissolve.
"""
