"""The picture of the page at work in the documentation: a fetch in the Demo's room, as a browser shows it.

``python -m benchmarks.page_pictures docs/images`` starts a system with its page, has TIAGo++ fetch item 29,
and writes ``page-now.png`` while an arm is about to grasp. It needs Chromium and the extra ``dev``.
``page-task.png`` (there ``page-moment.png``) and ``page-replay.png`` are left by the tests of the page:
``TANDEM_PICTURES=FOLDER pytest tests/executive/web/test_replay_views.py``.
"""

from __future__ import annotations

import argparse
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from playwright.sync_api import Page, sync_playwright

from tandem.client import Client

SIZE: Final = (1280, 800)
"""Pixels: a small laptop."""
SHOWS: Final = "grasp"
"""The leaf that runs in the picture of a task at work: room, robot, item and tree have something to show."""
PATIENCE: Final = 300.0
"""Seconds for what takes 60 on two idle cores."""
SITE: Final = "pictures"
ROBOT: Final = "tiago"
PORT: Final = 7953
WEB_PORT: Final = 8453
BROWSERS: Final = ("chromium", "chromium-browser", "google-chrome")


@contextmanager
def system(folder: Path) -> Iterator[tuple[str, str]]:
    """Run everything; yields the router's endpoint and the page's address."""
    endpoint, page = f"tcp/127.0.0.1:{PORT}", f"127.0.0.1:{WEB_PORT}"
    way = ["--connect", endpoint, "--site-key", SITE, "--robot", ROBOT]
    log = folder / "up.log"
    with log.open("w") as out:
        process = subprocess.Popen(  # noqa: S603 - our own command
            [sys.executable, "-m", "tandem", "up", *way, "--web-at", page, "--data", str(folder / "data")],
            stdout=out,
            stderr=out,
        )
    try:
        deadline = time.monotonic() + PATIENCE
        while "press Ctrl-C" not in log.read_text("utf-8"):
            if process.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError(f"tandem up: {log.read_text('utf-8')}")
            time.sleep(0.2)
        yield endpoint, f"http://{page}"
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(60)


def take(page: Page, endpoint: str, folder: Path) -> None:
    """Have an item fetched, and take the picture."""
    page.goto("/")
    page.wait_for_selector(".canvas[data-robot=loaded]", timeout=1e3 * PATIENCE)
    with Client(endpoint, site=SITE, robot=ROBOT) as client:
        client.submit({"task": "fetch", "item": 29, "to": "depot"})
        page.locator(".node.RUNNING .name", has_text=re.compile(f"^{SHOWS}$")).wait_for(
            timeout=1e3 * PATIENCE
        )
        page.screenshot(path=folder / "page-now.png")


def main() -> int:
    """Take the picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    folder: Path = parser.parse_args().folder
    chromium = next((found for name in BROWSERS if (found := shutil.which(name))), None)
    if chromium is None:
        sys.stderr.write("no Chromium: apt-get install --no-install-recommends chromium\n")
        return 2
    with (
        tempfile.TemporaryDirectory(prefix="tandem-pictures-") as data,
        system(Path(data)) as (endpoint, address),
        sync_playwright() as driver,
    ):
        browser = driver.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        width, height = SIZE
        page = browser.new_page(base_url=address, viewport={"width": width, "height": height})
        take(page, endpoint, folder)
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
