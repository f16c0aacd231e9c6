"""Whether what serves ``hw/`` keeps the hardware's contract: clauses, each a generator over typed keys.

``clause`` says what a clause is, ``recording`` and ``bench`` what it works with, ``suite`` lists all, and
``running`` carries them out. The clauses themselves:

- ``described``, ``described_urdf``: the description;
- ``clocks``, ``joints``, ``sensors``, ``states``: what is told;
- ``leases``, ``documents``, ``stops``: what is asked and refused;
- ``motions``, ``trajectories``, ``streams``, ``hands``, ``braking``: what moves;
- ``harmless``: commands that move nothing even if they are obeyed.
"""
