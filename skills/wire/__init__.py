"""Buses, clocks and process loops: the only home of zenoh.

zenoh: zenoh_bus, foreign_session, zenoh_ends, subscriptions, direct, threads, configs, credentials,
endpoints, linger, keyed_queue, kept_states, strays.
In memory: memory.
A process: loop, clocks, workers, forked_worker, waking, pulse, beats.
One of each role: presence, lease_holder.
"""
