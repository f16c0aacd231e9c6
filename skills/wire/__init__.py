"""Buses, clocks and process loops: the only home of zenoh."""
