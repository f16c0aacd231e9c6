"""One tree at work: ticks, halts, pauses, ends."""
