"""Leaves that act: one goal of one skill each."""
