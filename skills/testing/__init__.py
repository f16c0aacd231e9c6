"""Fakes that ship with the product: for tests of trees, one's own among them, without a robot or a sim."""
