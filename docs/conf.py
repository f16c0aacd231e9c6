"""The documentation as a site: ``make docs`` builds it into ``out/docs``. The pages read as well without."""
# ruff: noqa: INP001 - read by Sphinx, and no package

from __future__ import annotations

from importlib.metadata import version as installed

project = "Tandem"
version = release = installed("tandem-executive")
extensions = ["myst_parser"]
exclude_patterns = ["asyncapi.json", "deploy"]
html_theme = "furo"
html_title = f"Tandem {release}"
myst_heading_anchors = 4
"""Headings can be linked to as on a forge, by their words: h1 to h4."""
myst_enable_extensions = ["html_image"]
suppress_warnings = ["misc.highlighting_failure"]
"""Excerpts of programs' output are no source of any language."""
