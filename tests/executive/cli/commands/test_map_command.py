"""What ``tandem map`` prints."""

from tandem.executive.cli.commands.map_command import about, plan
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import Occupancy, pack


def told(shape: tuple[int, int, int], *numbers: int, problem: str = "") -> Occupancy:
    stamp = RobotTime(boot="b", seconds=1.0)
    return Occupancy(
        stamp=stamp,
        version=1,
        origin=(-1.0, 2.0, 0.0),
        shape=shape,
        resolution=0.05,
        cells=pack(numbers),
        problem=problem,
    )


def test_the_plan_has_north_up_and_two_rows_of_cells_in_a_line() -> None:
    assert plan(told((4, 4, 2), 0, 11, 4 * 4 + 12)) == ["#..#", "#..."]


def test_a_wide_room_fits_into_the_terminal() -> None:
    lines = plan(told((200, 80, 1), 199))
    assert {len(each) for each in lines} == {67}
    assert lines[-1].endswith("#")


def test_how_much_is_occupied_is_said_with_what_is_wrong() -> None:
    assert about(told((4, 4, 2), 5)) == "1 cell of 5 cm occupied"
    assert about(told((4, 4, 2), problem="found zeros")) == "0 cells of 5 cm occupied; found zeros"
