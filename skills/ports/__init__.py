"""The vocabulary that all rooms share: messages, failure kinds, protocols and keys."""
