"""Making, listing and revoking keys, as the command does it."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest

from tandem.executive.cli.main import main


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "keys"
    assert main(["keys", "init", "--folder", str(made)]) == 0
    return made


def new(folder: Path, *words: str) -> int:
    return main(["keys", "new", "--folder", str(folder), *words])


def test_only_their_owner_reads_private_keys(folder: Path) -> None:
    assert new(folder, "ann", "--role", "operator") == 0
    assert new(folder, "tiago", "--role", "robot") == 0
    keys = sorted(folder.glob("*.key"))
    assert len(keys) == 1 + 1 + 5  # the authority's, ann's, and one for each part of the robot
    assert {stat.S_IMODE(key.stat().st_mode) for key in keys} == {0o600}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("ann", "--role", "viewer"), "'ann' has a key already, as operator"),
        (("gone", "--role", "viewer"), "'gone' was revoked"),
        (("V x", "--role", "viewer"), "up to 32 of a-z 0-9 _ -"),
        (("a/b", "--role", "viewer"), "up to 32 of a-z 0-9 _ -"),
        (("ca", "--role", "viewer"), "the authority's own name"),
        (("bob", "--role", "viewer", "--host", "x"), "only a robot's router"),
    ],
)
def test_a_name_that_can_not_be_is_refused(
    folder: Path, capfd: pytest.CaptureFixture[str], words: tuple[str, ...], said: str
) -> None:
    new(folder, "ann", "--role", "operator")
    new(folder, "gone", "--role", "operator")
    assert main(["keys", "revoke", "gone", "--folder", str(folder)]) == 0
    assert new(folder, *words) == 2
    assert said in capfd.readouterr().err


def test_files_that_are_there_are_not_overwritten(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (folder / "ann.pem").write_text("somebody's")
    assert new(folder, "ann", "--role", "viewer") == 2
    assert "exists already" in capfd.readouterr().err
    assert main(["keys", "init", "--folder", str(folder)]) == 2
    assert (folder / "ann.pem").read_text() == "somebody's"


def test_the_list_tells_who_holds_what(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    new(folder, "ann", "--role", "operator")
    new(folder, "bob", "--role", "requester")
    main(["keys", "revoke", "bob", "--folder", str(folder)])
    capfd.readouterr()
    assert main(["keys", "list", "--folder", str(folder)]) == 0
    lines = capfd.readouterr().out.splitlines()
    assert lines[0].startswith("tandem.operator.ann")
    assert "until" in lines[0]
    assert lines[1].split() == ["tandem.requester.bob", "revoked"]
    assert main(["keys", "revoke", "eve", "--folder", str(folder)]) == 2
    assert "there are ann, bob" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--listen", "tcp/0.0.0.0:7447"), "pass --insecure"),
        (("--listen", "tls/0.0.0.0:7447"), "TLS needs keys"),
        (("--connect", "tcp/0.0.0.0:7447"), "pass --insecure"),
        (("--listen", "nowhere"), "expected an endpoint tls/HOST:PORT"),
        (("--only", "router,moon"), "found 'moon'"),
        (("--as", "tiago"), "--as needs --keys"),
    ],
)
def test_up_does_not_open_what_it_can_not_close(
    capfd: pytest.CaptureFixture[str], words: tuple[str, ...], said: str
) -> None:
    assert main(["up", *words]) == 2
    assert said in capfd.readouterr().err


def test_up_needs_a_robots_keys_and_a_certificate_for_the_host(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    up = ["up", "--keys", str(folder)]
    assert main(up) == 2
    assert "keys of one robot" in capfd.readouterr().err
    new(folder, "tiago", "--role", "robot", "--host", "router.example")
    assert main([*up, "--listen", "tls/elsewhere.example:7447"]) == 2
    assert "not for 'elsewhere.example', only for" in capfd.readouterr().err


def test_a_key_that_others_may_read_is_not_shown(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    new(folder, "ann", "--role", "operator")
    (folder / "ann.key").chmod(0o644)
    assert main(["tasks", "--keys", str(folder), "--as", "ann"]) == 2
    assert "others may read it" in capfd.readouterr().err
