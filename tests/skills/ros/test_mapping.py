"""Maps: those that ship are right, and a wrong one is refused with file, path, line and reason."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from tandem.sim.robots.registry import robot_model
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ros.mapping import RosMap, described, load_map

SHIPPED = Path(__file__).parents[3] / "examples" / "ros" / "p3dx.yaml"
ODOM = "{topic: /odom, type: nav_msgs/msg/Odometry, to: odometry}"
WRONG = {
    # What stands in the file, after "robot: NAME": where it is wrong, and what is said.
    "no robot": ("", [ODOM], "(the whole document): expected either robot or description"),
    "an unknown robot": ("r2d2", [ODOM], "robot (line 1): no robot 'r2d2'"),
    "an unknown type": (
        "p3dx",
        ["{topic: /a, type: my_msgs/msg/Sonar, to: range}"],
        "inputs.0.type (line 3): expected one of geometry_msgs/msg/PoseStamped",
    ),
    "a type that does not fit": (
        "p3dx",
        ["{topic: /a, type: sensor_msgs/msg/Range, to: odometry}"],
        "inputs.0.type (line 3): expected nav_msgs/msg/Odometry or tf2_msgs/msg/TFMessage, the type of",
    ),
    "an unknown part": (
        "p3dx",
        ["{topic: /a, type: sensor_msgs/msg/Range, to: whiskers}"],
        "inputs.0.to (line 3): expected",
    ),
    "a kind of sensor that the robot lacks": (
        "p3dx",
        [ODOM, "{topic: /scan, type: sensor_msgs/msg/LaserScan, to: laser, sensor: base}"],
        "inputs.1.to (line 4): p3dx has no lasers",
    ),
    "a sensor that the robot lacks": (
        "p3dx",
        ["{topic: /b, type: std_msgs/msg/Bool, to: bumper, sensor: top}"],
        "inputs.0.sensor (line 3): expected one of p3dx's bumpers: front, left, back, right; found top",
    ),
    "no sensor where there are several": (
        "p3dx",
        ["{topic: /b, type: std_msgs/msg/Bool, to: bumper}"],
        "inputs.0.sensor (line 3): expected one of p3dx's bumpers",
    ),
    "joints that the robot lacks": (
        "p3dx",
        ["{topic: /joint_states, type: sensor_msgs/msg/JointState, to: joints}"],
        "inputs.0.to (line 3): p3dx has no joints",
    ),
    "one part twice": (
        "p3dx",
        [ODOM, ODOM.replace("/odom", "/o")],
        "inputs.1.to (line 4): odometry is mapped",
    ),
    "all sonars and one of them": (
        "p3dx",
        [
            "{topic: /a, type: sensor_msgs/msg/Range, to: range}",
            "{topic: /b, type: sensor_msgs/msg/Range, to: range, sensor: sonar_1}",
        ],
        "inputs.1.to (line 4): inputs.0 maps all range sensors already",
    ),
    "cliff sensors of a robot without any": (
        "p3dx",
        ["{topic: /a, type: sensor_msgs/msg/Range, to: cliff}"],
        "inputs.0.to (line 3): p3dx has no cliff sensors",
    ),
    "all cliff sensors and one of them": (
        "locobot",
        [
            "{topic: /a, type: sensor_msgs/msg/Range, to: cliff}",
            "{topic: /b, type: sensor_msgs/msg/Range, to: cliff, sensor: cliff_left}",
        ],
        "inputs.1.to (line 4): inputs.0 maps all cliff sensors already",
    ),
    "one topic of two types": (
        "p3dx",
        [ODOM, "{topic: /odom, type: geometry_msgs/msg/PoseStamped, to: pose, sensor: markers}"],
        "inputs.1.topic (line 4): /odom has the type nav_msgs/msg/Odometry in inputs.0",
    ),
    "tf without frames": (
        "p3dx",
        ["{topic: /tf, type: tf2_msgs/msg/TFMessage, to: odometry, parent: odom}"],
        "inputs.0.child (line 3): expected a frame",
    ),
    "frames without tf": (
        "p3dx",
        [ODOM.replace("}", ", parent: odom}")],
        "inputs.0.parent (line 3): expected none",
    ),
    "no name of a topic": ("p3dx", [ODOM.replace("/odom", "odom")], "inputs.0.topic (line 3): expected"),
    "an unknown field": (
        "p3dx",
        [ODOM.replace("}", ", rate: 5}")],
        "inputs.0.rate (line 3): expected no such",
    ),
    "nothing at all": ("p3dx", [], "inputs (line 2): expected"),
}


def known(name: str) -> RobotDescription:
    return robot_model(name).description


def written(folder: Path, robot: str, inputs: list[str], more: str = "") -> Path:
    path = folder / "map.yaml"
    lines = [f"robot: {robot}" if robot else "domain: 0", *(["inputs:"] if inputs else ["inputs: []"])]
    path.write_text("\n".join([*lines, *(f"  - {each}" for each in inputs), more]) + "\n", "utf-8")
    return path


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_map_is_refused_with_where_and_why(name: str, tmp_path: Path) -> None:
    robot, inputs, said = WRONG[name]
    with pytest.raises(DocumentError) as refused:
        load_map(written(tmp_path, robot, inputs), known)
    assert f"{tmp_path / 'map.yaml'}: {said}" in str(refused.value)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (
            "cmd_vel: {topic: /v, type: std_msgs/msg/Bool}",
            "cmd_vel.type (line 4): expected geometry_msgs/msg/Twist",
        ),
        ("domain: 233", "domain (line 4): expected"),
        ("distro: noetic", "distro (line 4): expected"),
    ],
)
def test_what_stands_beside_the_inputs_is_checked_too(line: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(DocumentError) as refused:
        load_map(written(tmp_path, "p3dx", [ODOM], line), known)
    assert said in str(refused.value)


def test_a_base_that_does_not_drive_takes_no_velocity(tmp_path: Path) -> None:
    inputs = ["{topic: /j, type: sensor_msgs/msg/JointState, to: joints}"]
    path = written(tmp_path, "panda", inputs, "cmd_vel: {topic: /v, type: geometry_msgs/msg/Twist}")
    with pytest.raises(DocumentError, match=r"cmd_vel \(line 4\): panda has no drive"):
        load_map(path, known)


def test_a_description_of_ones_own_is_read_with_its_urdf(tmp_path: Path) -> None:
    own = known("p3dx").model_dump(mode="json")
    (tmp_path / "my.urdf").write_text(own.pop("urdf"), "utf-8")
    (tmp_path / "my.yaml").write_text(yaml.safe_dump(own | {"name": "mine"}), "utf-8")
    path = written(tmp_path, "", [ODOM], "description: my.yaml\nurdf: my.urdf")
    made, robot = load_map(path, known)
    assert (robot.name, robot.urdf) == ("mine", known("p3dx").urdf)
    assert isinstance(made, RosMap)


def test_the_map_that_ships_covers_its_robot() -> None:
    made, robot = load_map(SHIPPED, known)
    lines = described(made, robot)
    assert lines[0] == "p3dx: ROS domain 0, jazzy, node /tandem"
    assert "velocity -> /cmd_vel (geometry_msgs/msg/Twist)" in lines
    assert not [each for each in lines if each.startswith("no topic for")]


def test_parts_without_a_topic_are_named(tmp_path: Path) -> None:
    made, robot = load_map(written(tmp_path, "tiago_base", [ODOM]), known)
    assert described(made, robot)[-1].startswith("no topic for: ")
    assert "laser base" in described(made, robot)[-1]
