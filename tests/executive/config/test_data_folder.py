"""What another user's start has left in a data folder is told before any process fails over it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tandem.executive.config.data_folder import DataFolderError, require_writable


@pytest.fixture
def barred(monkeypatch: pytest.MonkeyPatch) -> set[Path]:
    """Paths that another user has; the tests may run as root, who can write everywhere."""
    names, allowed = set[Path](), os.access
    monkeypatch.setattr(os, "access", lambda path, mode: path not in names and allowed(path, mode))
    return names


@pytest.mark.parametrize(
    ("where", "what"), [("held.jsonl", "a file"), ("logs", "a folder"), ("logs/router.log", "a file")]
)
def test_what_another_user_has_is_named(tmp_path: Path, barred: set[Path], where: str, what: str) -> None:
    (tmp_path / "logs").mkdir()
    (tmp_path / "logs" / "router.log").touch()
    (tmp_path / "held.jsonl").touch()
    require_writable(tmp_path)
    barred.add(tmp_path / where)
    with pytest.raises(DataFolderError, match="--data") as caught:
        require_writable(tmp_path)
    assert str(caught.value).startswith(
        f"{tmp_path / where}: expected {what} that this user can read and write"
    )


def test_what_is_not_ours_or_has_just_gone_is_passed_over(tmp_path: Path, barred: set[Path]) -> None:
    (tmp_path / "lost+found").mkdir()
    (tmp_path / "gone").symlink_to(tmp_path / "nowhere")
    barred.add(tmp_path / "lost+found")
    require_writable(tmp_path)


def test_a_folder_that_is_not_there_is_made(tmp_path: Path) -> None:
    require_writable(tmp_path / "a" / "b")
    assert (tmp_path / "a" / "b").is_dir()
