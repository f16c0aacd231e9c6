"""A browser plays the videos of a LeRobot data set."""

from __future__ import annotations

import base64
from pathlib import Path

import pytest
from synthetic_record import RED, picture

pytest.importorskip("av", reason="no PyAV: pip install av")
pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from web_chromium import MARKS, PATIENCE, launched

from tandem.executive.records.lerobot.videos import Film, VideoFiles

pytestmark = MARKS
SEEN = """([source, patience]) => new Promise(done => {
  const video = document.createElement("video");
  video.onloadeddata = () => { video.currentTime = 0.25; };
  video.onerror = () => done(video.error.message);
  const canvas = document.createElement("canvas");
  const pixels = canvas.getContext("2d");
  const look = () => {
    pixels.drawImage(video, 0, 0);
    const [red, green, blue, opaque] = pixels.getImageData(5, 5, 1, 1).data;
    if (opaque) done([canvas.width, canvas.height, video.duration, red, green, blue]);
    else requestAnimationFrame(look);
  };
  video.onseeked = () => {
    [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
    look();
  };
  setTimeout(() => done("nothing was shown"), patience);
  video.src = source;
})"""
"""Returns width, height, seconds, and red, green and blue of a pixel at 0.25 s; words if it is not played.

A busy browser tells of the seek before it has the frame to draw: until then nothing lands on the canvas,
whose pixels stay transparent.
"""


def test_a_browser_plays_a_video(tmp_path: Path) -> None:
    files = VideoFiles(tmp_path, "head", (36, 64), 10)
    files.add(Film("head", (picture("head", RED, (36, 64)),), (0,) * 5))
    files.close()
    (path,) = tmp_path.rglob("*.mp4")
    source = f"data:video/mp4;base64,{base64.b64encode(path.read_bytes()).decode()}"
    with launched() as browser:
        width, height, seconds, *colour = browser.new_page().evaluate(SEEN, [source, PATIENCE])
    assert (width, height, seconds) == (64, 36, 0.5)
    assert colour == pytest.approx(RED, abs=5)
