"""Series of seeded runs, each with its aim.

All of them: series, mock_roles.
Fetches in the physics: fetch, recovery, troubles, reachable, oracle, recording.
Crashes: crash, crash_points, crash_rig, crash_world, crash_physics, hardware_restart.
Crashes around a verb: crash_verbs, verb_cases, verb_scene.
Hostile input: fuzz, fuzz_all, fuzz_inputs, fuzz_keys, from_schema.
Uptime: soak.
"""
