"""The commands: one file each, or one for a family.

Run a robot: run_commands, run_task_command, stop_commands, reflex_commands, doctor_command, keys_command,
plugins_command, new_command, hardware_command, ros_command.
Ask for tasks: request_command, retry_command, cancel_command, verb_commands, task_commands, history_command.
Look on: web_command, watch_command, logs_command, why_command, tree_commands, zones_command, map_command.
Look back: log_command, lerobot_export, replay_command, run_again.
Files and schemas: scenario_commands, schema_command.
Try and measure: campaign_command, recorded_campaign, restart_command, experiment_command, crossings_command,
picking_command, bench_command.
"""
