"""The experiments of the two-arm thesis, chapter 5: drawn, run in lockstep, and set beside its figures."""
