"""The contracts of the actions: goal, feedback and result of each, one file a domain."""
