"""How an item is taken and put down: frames of items and the poses of a hand around them."""
