"""The page: a web server beside the robot, itself an ordinary client of the executive.

Floor plan: ``options`` what was asked for; ``gate`` who may speak to it (host, origin, headers);
``sessions`` who has logged in, beyond this host; ``throttle`` how often one may be wrong; ``robot`` its
ends of the bus; ``feed`` what is heard, as updates; ``trees`` what has changed in a tree; ``others`` the
other robots of the site; ``occupied`` occupied space; ``viewers`` who is told, each at its own pace;
``sockets`` by what; ``audience`` hears for as long as there is one; ``verbs`` what a viewer may ask for;
``history`` the ledger's tasks with filters; ``camera`` what it sees; ``replay`` a record in place of a
robot; ``kept_records`` the records of a task, and what was known at a moment of one; ``meshes`` the files
that a robot's URDF names; ``app`` the addresses; ``by_port`` several robots' pages; ``serve`` and
``process`` how it is served. ``bundle`` is the page itself, made of ``page/`` at the top of the repository.
"""
