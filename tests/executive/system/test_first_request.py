"""What ``tandem up`` tells to type in another terminal. Cheaper to see from inside."""

from __future__ import annotations

import datetime as dt
from pathlib import Path

from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.security.authority import Wanted, begin, issue
from tandem.executive.system.first_request import hint
from tandem.sim.scenario import load_scenario
from tandem.skills.site import load

LAB = load("lab")
DEMO = load_scenario("Demo")


def test_an_item_of_the_scenario_with_nothing_but_defaults() -> None:
    first = DEMO.items[0].item
    assert hint(RunOptions(), DEMO, LAB) == f"tandem request fetch --item {first} --wait"


def test_the_way_to_a_robot_elsewhere() -> None:
    bus = BusOptions(endpoint="tcp/127.0.0.1:7448", site="hall 2", robot="anna")
    said = hint(RunOptions(bus=bus), DEMO, LAB)
    assert said.endswith("--connect tcp/127.0.0.1:7448 --site-key 'hall 2' --robot anna --wait")


def test_no_item_no_request() -> None:
    empty = DEMO.model_copy(update={"items": ()})
    assert hint(RunOptions(), empty, LAB) == "tandem tasks"
    assert hint(RunOptions(only=("router",)), DEMO, LAB) == "tandem tasks"


def test_an_item_for_two_hands_is_not_fetched_with_one() -> None:
    said = hint(RunOptions(), load_scenario("TwoArmsBox"), load("bimanual"))
    assert said == "tandem request pick_both_hands --item 0 --wait"


def test_the_name_of_somebody_who_may_ask(tmp_path: Path) -> None:
    now = dt.datetime.now(dt.UTC)
    begin(tmp_path, now)
    issue(tmp_path, Wanted("viewer", "vera"), now)
    bus = BusOptions(endpoint="tls/127.0.0.1:7447", keys=tmp_path, holder="tiago")
    assert f"--keys {tmp_path} --as NAME --wait" in hint(RunOptions(bus=bus), DEMO, LAB)
    issue(tmp_path, Wanted("requester", "rita"), now)
    assert f"--keys {tmp_path} --as rita --wait" in hint(RunOptions(bus=bus), DEMO, LAB)
