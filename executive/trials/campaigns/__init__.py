"""Series of seeded runs, each with its aim."""
