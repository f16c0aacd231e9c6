"""The vocabulary that all rooms share: messages, failure kinds, protocols and keys.

What a message is: message, utc, pose, shapes, image, picture_header, sources.
What a document says: problems, documents, plain_json.
What a robot says it is: robot_description, sensors.
What is said: hardware, world, whereabouts, tasks, site, action, failure; goals are in ``actions/``.
Occupied space: occupancy, lattice. Ways: planners.
The table of keys: keys, match, delivery.
Items by name or number: item_number.
Protocols: bus, forwarding_bus, clocks, compute, node, skill, steps.
Serving and hearing: serving, endpoint, limits, hearing, checks, refusals.
Who commands: lease, fencing; reflex, reflex_setting.
Robot descriptions: packages, urdf_check, description_check.
What other packages add: plugins, plugin_trials, plugin_memory. What is kept: records.
How Python programs of ours are started: isolation.
"""
