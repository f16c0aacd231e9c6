"""Conditions over failures: what would help? One question each, by the failure's kind."""
