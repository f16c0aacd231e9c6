"""The order-picking paper's experiment (IV): fetches in its room, timed by its phases, with its figures."""
