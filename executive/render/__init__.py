"""Pictures of trees: text, DOT, SVG, PNG, JSON. Nothing here needs Graphviz."""
