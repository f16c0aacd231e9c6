"""Moving an arm."""
