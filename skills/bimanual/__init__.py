"""Both arms at once: workspace zones, coordination, two hands.

Zones: zones, zones_node.
Coordination: coordinate, coordination, coordinator, observer, announced, way, uncoordinated_stop.
Two hands on one thing: two_hands, object_frame, ready, glide, hold, squeeze,
supervision, landing, way_trial, lead.
All of it: process.
"""
