"""The experiments of document 002, chapter 5: drawn, run in lockstep, and set beside its own figures."""
