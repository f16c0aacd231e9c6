"""What a process needs to speak TLS: three files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Credentials:
    """PEM files of mutual TLS: whom to trust, and who one is oneself."""

    authority: Path
    certificate: Path
    key: Path
