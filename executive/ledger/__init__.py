"""What the executive must not forget: one SQLite file, or the same in memory."""
