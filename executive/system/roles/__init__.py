"""What a process of the system can play: one file for each role, found by being here.

What a role is, and how it is found: role, skill_type, registry.
The robot: hardware, or ros instead of it.
Skills: arm, base, bimanual, keeper, perception; or skills, which is all of them in one process.
The rest: executive, observer, recorder, router, web.
"""
