"""What was heard of a robot, kept in files, and played back.

Floor plan: ``recording`` what a record is, and how one is opened; ``lines_file`` our own layout, of the black
box; ``mcap_file`` reads MCAP; ``player`` plays a record into a bus.
"""
