"""Fill the pages' blocks of figures: ``python -m benchmarks.figures FOLDER PAGE...``; see ``make figures``.

``FOLDER/fetch.json``, written by a command's ``--report``, fills what stands in a page between
``<!-- begin figures fetch -->`` and ``<!-- end figures fetch -->``. Blocks without a file stay as they are.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Final

from tandem.executive.trials.figure_file import Figures

BLOCK: Final = re.compile(r"(<!-- begin figures ([\w-]+) -->\n).*?(<!-- end figures \2 -->)", re.DOTALL)


def fill(page: str, folder: Path) -> str:
    """Return the page with each block filled whose file is in the folder."""

    def block(found: re.Match[str]) -> str:
        path = folder / f"{found[2]}.json"
        if not path.is_file():
            return found[0]
        return f"{found[1]}{told(Figures.model_validate_json(path.read_bytes()))}{found[3]}"

    return BLOCK.sub(block, page)


def told(figures: Figures) -> str:
    """Return a block's text: what was printed, and where it comes from."""
    lines = "\n".join(figures.summary)
    return f"\n```text\n{lines}\n```\n\n{figures.made.line()}.\n\n"


def names(page: str) -> tuple[str, ...]:
    """Return the names of a page's blocks."""
    return tuple(found[2] for found in BLOCK.finditer(page))


def main(argv: list[str]) -> int:
    """Fill the pages; say which blocks have no file."""
    folder, pages = Path(argv[0]), [Path(each) for each in argv[1:]]
    for path in pages:
        text = path.read_text("utf-8")
        path.write_text(fill(text, folder), "utf-8")
        missing = [name for name in names(text) if not (folder / f"{name}.json").is_file()]
        if missing:
            print(f"{path}: not made, left as it was: {', '.join(missing)}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
