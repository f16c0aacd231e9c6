"""The experiments of the RoCS paper, 6.3 to 6.5: drawn, run in lockstep, judged by the truth."""
