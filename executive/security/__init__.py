"""Keys, roles and access rules: who may do what on the bus."""
