"""The ``tandem`` command.

Entry: start, main; the commands themselves are in ``commands/``.
Options: arguments, system_options, option_checks, defaults, completing, opening, allowed, display.
Talking to the executive: connection, sending, waiting, kinds, kinds_group, schema_options.
What users see: telling, confirming, shapes, task_lines, errors, exit_codes, logs.
Whole systems: running_system, carrying_out, run_ending, interrupting, lockstep_run, film.
Documentation: pages.
"""
