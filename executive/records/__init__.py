"""What was heard of a robot, kept in files, and played back.

Floor plan.
Files: ``recording`` what a record is, and how one is opened; ``lines_file`` our own layout, of the black box;
``mcap_file`` reads MCAP, ``mcap_growing`` while it is written; ``mcap_writing`` writes it, ``json_schemas``
has its schemas; ``recovering`` mends what was cut, ``mcap_copy`` record by record; ``cutting`` and
``exporting`` parts and text of one; ``lerobot`` makes data sets of many.
Writing: ``process`` is the role; ``recorder`` hears with ``ears``, keeps the last minute in a ``ring`` and
writes it into ``boxes`` when one of the ``incidents`` happens; ``attaching`` asks for what stands beside the
messages; ``recording_sink`` writes MCAP, with ``pictures`` and ``foxglove_view``; ``recordings`` tells
which of these are kept; ``dated`` how old such files are, by their names.
Playing: ``tape`` walks through a record and knows what was ``known``; ``player`` plays it into a bus in
memory, where ``answers`` has the answers of that time; ``moments`` says what happened when.
"""
