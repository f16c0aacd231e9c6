"""Trees, zones and failures as text and pictures; no window, no robot.

What is drawn of a tree: view, outline, folded.
Where its boxes stand, and how nodes look: layout, signs.
Drawing it: text, svg, png, dot; formats has them by name, and example makes a tree without a robot.
Beside the room, as a moving picture: frame.
Other things: zones, failure_words.
"""
