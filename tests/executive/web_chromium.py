"""A real browser for the tests of the page. With ``TANDEM_PICTURES=FOLDER`` they leave pictures there."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

playwright = pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Page, expect, sync_playwright  # noqa: E402

NAMES = ("chromium", "chromium-browser", "google-chrome")
CHROMIUM = next((found for name in NAMES if (found := shutil.which(name))), "")
MARKS = [
    pytest.mark.processes,
    pytest.mark.xdist_group("page"),
    pytest.mark.skipif(not CHROMIUM, reason="no Chromium: apt-get install --no-install-recommends chromium"),
]
PICTURES = os.environ.get("TANDEM_PICTURES", "")
PATIENCE = 30_000
"""Milliseconds in which the page must show something, also beside other programs."""


@contextmanager
def launched() -> Iterator[Browser]:
    """Start the browser."""
    expect.set_options(timeout=PATIENCE)
    with sync_playwright() as driver:
        made = driver.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield made
        made.close()


@contextmanager
def opened(browser: Browser, address: str, width: int = 1280, beside: str = "") -> Iterator[Page]:
    """Open a tab; at its end there has been no error in it, and nothing was asked for from elsewhere.

    ``beside`` is the address of another page that may be gone to.
    """
    ours = (address, beside or address)
    size = {"width": width, "height": 800}
    made = browser.new_page(base_url=address, viewport=size, ignore_https_errors=True)  # type: ignore[arg-type]
    wrong: list[str] = []
    made.on("pageerror", lambda error: wrong.append(str(error)))
    made.on("request", lambda asked: wrong.append(asked.url) if not is_ours(asked.url, ours) else None)
    yield made
    made.close()
    assert wrong == [], "no error in the page, and nothing from elsewhere"


def is_ours(url: str, addresses: tuple[str, ...]) -> bool:
    sockets = tuple(each.replace("http", "ws") for each in addresses)
    return url.startswith((*addresses, *sockets, "data:", "blob:"))


def picture(page: Page, name: str) -> None:
    """Leave pictures of the page as it stands: as wide as it is, and as on a tablet."""
    if not PICTURES:
        return
    page.screenshot(path=f"{PICTURES}/{name}.png", type="png")
    size = page.viewport_size
    assert size is not None
    page.set_viewport_size({"width": 800, "height": 1000})
    page.screenshot(path=f"{PICTURES}/{name}-800.png", type="png")
    page.set_viewport_size(size)
