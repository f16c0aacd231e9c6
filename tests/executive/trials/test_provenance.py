"""What a figure says of its making."""

from __future__ import annotations

import pytest

from tandem.executive.trials.provenance import provenance

TYPED = "tandem campaign fetch --runs 60 --seed 1"


@pytest.mark.parametrize(
    "words",
    [
        TYPED,
        f"/home/me/.venv/bin/{TYPED}",
        f"{TYPED} --report out/figures/fetch.json",
        f"{TYPED} --report=fetch.json",
        "tandem campaign fetch --figures out --runs 60 --seed 1 --report",
    ],
)
def test_the_command_names_no_file_of_one_machine(words: str) -> None:
    assert provenance(words.split(), 0.0).command == TYPED
