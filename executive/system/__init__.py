"""How processes are put together. ``roles/`` has one file for each role.

One process: worker, playing, leased_loop, skill_process, router, command_line, quiet_screen.
All of them: systems, process_system, settings_of_processes, processes, births, nursery, deferred_signals,
    crews, hung_processes, process_usage, lockstep.
Plug-ins: plugins, plugin_probe.
The start: free_endpoint, startup_notice, first_request, declared_reflexes.
"""
