"""The tutorial's code, put into a new project where the tutorial says, does what the tutorial says."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from tandem.executive.cli.main import main

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "tutorial.md").read_text("utf-8")
SAVED = re.compile(r"[Ss]ave this as `([^`]+)`.*?```python\n(.*?)```", re.DOTALL)


def test_its_task_and_its_tests_run_in_a_new_project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "my_robot_app"]) == 0
    saved = SAVED.findall(PAGE)
    assert [name for name, _ in saved] == ["src/my_robot_app/count_items.py", "tests/test_count_items.py"]
    for name, text in saved:
        (tmp_path / "my_robot_app" / name).write_text(text, "utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"],
        cwd=tmp_path / "my_robot_app",
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout
    assert re.search(r"\b7 passed", done.stdout), done.stdout
