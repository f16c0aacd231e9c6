"""The description of a robot that isn't there: two arms, two grippers, a base; no geometry."""

from __future__ import annotations

from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.robot_description import (
    DifferentialDrive,
    EndEffector,
    Gripper,
    JointGroup,
    JointLimit,
    Posture,
    RobotDescription,
)
from tandem.skills.ports.sensors import (
    Bumper,
    CameraSensor,
    CliffSensor,
    LaserSensor,
    PoseSensor,
    RangeSensor,
    RobotSensor,
)


def mock_description() -> RobotDescription:
    """Return it."""
    limit = JointLimit(
        joint="joint", lower=-3.0, upper=3.0, velocity=2.0, acceleration=5.0, jerk=50.0, effort=40.0
    )
    groups = tuple(
        JointGroup(name=f"arm_{side}", limits=(limit.model_copy(update={"joint": f"arm_{side}_joint"}),))
        for side in PAIR
    )
    hands = tuple(
        EndEffector(
            side=side,
            group=f"arm_{side}",
            frame=f"gripper_{side}_grasping_frame",
            touch_links=(f"gripper_{side}_link",),
            gripper=Gripper(joints=(f"gripper_{side}_joint",), max_width=0.09, speed=0.05, force=16.0),
            work_point=(0.65, 0.15 if side == "left" else -0.15),
            safe_point=(0.4, 0.5 if side == "left" else -0.5, 1.0),
        )
        for side in PAIR
    )
    return RobotDescription(
        name="mock",
        urdf="<robot name='mock'><link name='base_footprint'/></robot>",
        base_frame="base_footprint",
        footprint_radius=0.27,
        height=1.3,
        groups=groups,
        end_effectors=hands,
        cameras=(
            CameraSensor(name="head", frame="base_footprint", width=1280, height=720, horizontal_fov=1.047),
        ),
        lasers=(
            LaserSensor(
                name="base",
                frame="base_footprint",
                angle_min=-2.36,
                angle_step=0.0087,
                beams=541,
                range_min=0.05,
                range_max=10.0,
                period=0.1,
            ),
        ),
        range_sensors=(
            RangeSensor(
                name="front",
                frame="base_footprint",
                cone=0.5,
                range_min=0.15,
                range_max=5.0,
                period=0.1,
            ),
        ),
        cliff_sensors=(
            CliffSensor(name="front", frame="base_footprint", range_max=0.15, lead=0.04, period=0.02),
        ),
        pose_sensors=(PoseSensor(name="markers", period=0.05, position_sigma=0.01, yaw_sigma=0.009),),
        robot_sensors=(
            RobotSensor(name="others", frame="base_footprint", field=2.0, range_max=5.0, period=0.1),
        ),
        bumpers=tuple(Bumper(name=name) for name in ("front", "left", "back", "right")),
        drive=DifferentialDrive(
            forward=1.0, backward=0.2, acceleration=0.5, turn=1.05, turn_acceleration=1.05, dead_man=0.2
        ),
        postures=tuple(
            Posture(name=name, group=group.name, positions=(0.0,))
            for name in ("home", "carry")
            for group in groups
        ),
        period=0.01,
    )
