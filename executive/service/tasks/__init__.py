"""The tasks: their store, their queue, their states, what a restart means to them."""
