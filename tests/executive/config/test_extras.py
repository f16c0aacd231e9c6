"""The extras: the table is what pyproject.toml declares, and what is missing is named with its command."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from tandem.executive.config import extras
from tandem.executive.config.extras import (
    EXTRAS,
    SIM,
    SKILLS,
    Extra,
    absent,
    is_begun,
    words_on,
    words_on_module,
)

PROJECT = tomllib.loads((Path(__file__).parents[3] / "pyproject.toml").read_text("utf-8"))["project"]
NO_MODULE = {"example-robot-data"}
"""Files only; the description of the robot names them."""
ABSENT = Extra("absent", "nothing", (("no-such-thing", "no_such_thing", "nothing"),))


def _names(requirements: list[str]) -> set[str]:
    found = {re.split(r"[>=<;\[]", each)[0].strip() for each in requirements}
    return {"pybullet" if each == "pybullet-arm64" else each for each in found}


@pytest.mark.parametrize("extra", EXTRAS, ids=lambda each: each.name)
def test_the_table_names_what_an_extra_installs(extra: Extra) -> None:
    table = {distribution for distribution, _, _ in extra.packages}
    declared = _names(PROJECT["optional-dependencies"][extra.name]) - NO_MODULE
    named = {"pybullet" if each == extras.PYBULLET else each for each in table}
    assert named <= declared if extra is extras.DEV else named == declared


def test_all_is_every_extra_that_a_user_may_need() -> None:
    (everything,) = PROJECT["optional-dependencies"][extras.ALL]
    assert set(everything.partition("[")[2].rstrip("]").split(",")) == {e.name for e in EXTRAS} - {"dev"}


def test_the_bare_package_brings_none_of_an_extras_packages() -> None:
    of_extras = {distribution for extra in EXTRAS for distribution, _, _ in extra.packages} | NO_MODULE
    assert not _names(PROJECT["dependencies"]) & of_extras


def test_what_is_installed_is_not_complained_about() -> None:
    assert (absent(SKILLS), words_on(SKILLS, "it"), is_begun(SIM)) == ((), "", True)


def test_what_is_missing_is_named_with_the_command() -> None:
    assert absent(ABSENT) == ("no-such-thing",)
    assert not is_begun(ABSENT)
    assert words_on(ABSENT, "the role x") == (
        "the role x: no-such-thing missing; install with pip install 'tandem-executive[absent]'"
    )


@pytest.mark.parametrize(
    ("module", "expected"),
    [
        (
            "numpy",
            (
                "it: numpy missing, of the extra skills or sim or ros or lerobot; "
                "install with pip install 'tandem-executive[all]'"
            ),
        ),
        ("somebody_elses", ""),
    ],
)
def test_a_module_that_is_missing_leads_to_its_extra(module: str, expected: str) -> None:
    assert words_on_module(ModuleNotFoundError(name=f"{module}.part"), "it") == expected
