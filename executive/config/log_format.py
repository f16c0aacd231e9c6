"""The forms of logs. Imports nothing, so that `tandem --help` is quick."""

from __future__ import annotations

from typing import Literal

LogFormat = Literal["text", "json"]
"""Logs for people, or as lines of JSON."""
