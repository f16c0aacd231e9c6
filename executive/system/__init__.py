"""How processes are put together: what each role is made of, how they are started, watched and ended."""
