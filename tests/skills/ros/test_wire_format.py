"""What goes over rmw_zenoh, byte by byte: payloads, hashes, keys, tokens, attachments."""

from __future__ import annotations

import struct
from collections.abc import Callable

import numpy as np
import pytest
import zenoh.ext
from zenoh_ros2_sdk import keyexpr as sdk_keys
from zenoh_ros2_sdk.attachment import Attachment
from zenoh_ros2_sdk.entity import EndpointEntity, EntityKind, NodeEntity
from zenoh_ros2_sdk.qos import QosProfile, QosReliability

from tandem.skills.ros import types
from tandem.skills.ros.cdr import CdrError, Codec
from tandem.skills.ros.naming import (
    QOS_BEST_EFFORT,
    QOS_RELIABLE,
    EndName,
    NodeName,
    RosEnd,
    attachment,
    data_key,
    gid_of,
    read_end,
)
from tandem.skills.ros.types import HASHES, UNHASHED, Distro, dds_name, hash_of

JAZZY = Codec("jazzy")
make = JAZZY.message
CDR = "00010000"  # little-endian, no options
STAMP = "07000000 05000000"  # 7.000000005 s
ODOM = "05000000 6f646f6d00"  # "odom" with its end


def header(frame: str = "odom") -> object:
    stamp = make("builtin_interfaces/msg/Time", sec=7, nanosec=5)
    return make("std_msgs/msg/Header", stamp=stamp, frame_id=frame)


def vector(x: float, y: float, z: float) -> object:
    return make("geometry_msgs/msg/Vector3", x=x, y=y, z=z)


def twist() -> object:
    return make(types.TWIST, linear=vector(1.0, 0.0, 0.0), angular=vector(0.0, 0.0, -2.0))


def ranged(codec: Codec) -> object:
    return codec.message(
        types.RANGE,
        header=header(),
        radiation_type=0,
        field_of_view=0.5,
        min_range=0.25,
        max_range=4.0,
        range=1.5,
        variance=0.0,
    )


def scan() -> object:
    return make(
        types.LASER_SCAN,
        header=header(),
        angle_min=-1.0,
        angle_max=1.0,
        angle_increment=2.0,
        time_increment=0.0,
        scan_time=0.5,
        range_min=0.25,
        range_max=8.0,
        ranges=np.array([1.0, 2.0], np.float32),
        intensities=np.array([], np.float32),
    )


def joints() -> object:
    return make(
        types.JOINT_STATE,
        header=header(),
        name=["a", "bc"],
        position=np.array([1.0, -1.0]),
        velocity=np.array([]),
        effort=np.array([2.0]),
    )


ONE, TWO, MINUS_ONE, MINUS_TWO, ZERO = (
    "000000000000f03f",
    "0000000000000040",
    "000000000000f0bf",
    "00000000000000c0",
    "0000000000000000",
)
F32 = {-1.0: "000080bf", 0.0: "00000000", 0.25: "0000803e", 0.5: "0000003f", 1.0: "0000803f", 1.5: "0000c03f"}
F32 |= {2.0: "00000040", 4.0: "00008040", 8.0: "00000041"}
SCANNED = "".join(F32[each] for each in (-1.0, 1.0, 2.0, 0.0, 0.5, 0.25, 8.0))
NAMES = "02000000 02000000 6100 0000 03000000 626300 00"
GOLDEN: dict[str, tuple[Callable[[], object], str, str]] = {
    # What is sent, its type, and its bytes by hand: CDR aligns each value to its own size, after the header.
    "String": (
        lambda: make("std_msgs/msg/String", data="hi"),
        "std_msgs/msg/String",
        f"{CDR} 03000000 686900",
    ),
    "Bool": (lambda: make(types.BOOL, data=True), types.BOOL, f"{CDR} 01"),
    "Twist": (twist, types.TWIST, f"{CDR} {ONE}{ZERO}{ZERO} {ZERO}{ZERO}{MINUS_TWO}"),
    "TwistStamped": (
        lambda: make(types.TWIST_STAMPED, header=header("b"), twist=twist()),
        types.TWIST_STAMPED,
        f"{CDR} {STAMP} 02000000 6200 0000 {ONE}{ZERO}{ZERO} {ZERO}{ZERO}{MINUS_TWO}",
    ),
    "Range": (
        lambda: ranged(JAZZY),
        types.RANGE,
        f"{CDR} {STAMP} {ODOM} 00 0000 {F32[0.5]}{F32[0.25]}{F32[4.0]}{F32[1.5]}{F32[0.0]}",
    ),
    "LaserScan": (
        scan,
        types.LASER_SCAN,
        f"{CDR} {STAMP} {ODOM} 000000 {SCANNED} 02000000 {F32[1.0]}{F32[2.0]} 00000000",
    ),
    "JointState": (
        joints,
        types.JOINT_STATE,
        # names: two strings, each aligned to 4; doubles aligned to 8; an empty sequence is its length alone
        f"{CDR} {STAMP} {ODOM} 000000 {NAMES} 02000000 00000000 {ONE}{MINUS_ONE} 00000000 01000000 {TWO}",
    ),
}


@pytest.mark.parametrize("name", GOLDEN)
def test_a_message_has_these_bytes_and_is_read_from_them(name: str) -> None:
    sent, type_name, text = GOLDEN[name]
    payload = bytes.fromhex(text.replace(" ", ""))
    assert JAZZY.encode(type_name, sent()).hex() == payload.hex()
    assert JAZZY.encode(type_name, JAZZY.decode(type_name, payload)).hex() == payload.hex()


def test_a_range_of_humble_has_no_variance() -> None:
    humble = Codec("humble")
    assert humble.encode(types.RANGE, ranged(humble)) == JAZZY.encode(types.RANGE, ranged(JAZZY))[:-4]


@pytest.mark.parametrize("payload", [b"", b"\x00\x01\x00\x00", b"\x00\x01\x00\x00\x01", b"\xff" * 40])
def test_bytes_that_are_no_message_are_named_as_such(payload: bytes) -> None:
    with pytest.raises(CdrError, match="expected a nav_msgs/msg/Odometry"):
        JAZZY.decode(types.ODOMETRY, payload)


@pytest.mark.parametrize("name", HASHES)
@pytest.mark.parametrize("distro", ["jazzy", "kilted", "lyrical"])
def test_the_hashes_are_those_of_the_definitions(name: str, distro: Distro) -> None:
    assert Codec(distro).hash_of(name) == hash_of(name, distro)
    assert hash_of(name, "humble") == UNHASHED


def test_the_hash_of_string_is_the_published_one() -> None:
    """Of rmw_zenoh's docs/design.md: the reckoning of rosbags is that of ROS."""
    published = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
    assert JAZZY.hash_of("std_msgs/msg/String") == published


NODE = NodeName(2, "aac3178e146ba6f1fc6e6a4085e77f21", 0, "tandem")
SDK_NODE = NodeEntity(2, NODE.session, 0, "tandem")
GID = bytes(range(16))


def test_a_topic_has_this_key() -> None:
    key = data_key(0, "/joint_states", types.JOINT_STATE, HASHES[types.JOINT_STATE])
    assert key == (
        "0/joint_states/sensor_msgs::msg::dds_::JointState_/"
        "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"
    )


@pytest.mark.parametrize("topic", ["/cmd_vel", "/robot/base/cmd_vel"])
def test_keys_are_those_of_an_independent_client(topic: str) -> None:
    theirs = sdk_keys.topic_keyexpr(2, topic, dds_name(types.TWIST), HASHES[types.TWIST])
    assert data_key(2, topic, types.TWIST, HASHES[types.TWIST]) == theirs


def test_a_nodes_token_is_that_of_an_independent_client() -> None:
    assert NODE.token.split("/") == ["@ros2_lv", "2", NODE.session, "0", "0", "NN", "%", "%", "tandem"]
    assert NODE.token == sdk_keys.node_liveliness_keyexpr(SDK_NODE)


@pytest.mark.parametrize(
    ("kind", "theirs", "qos", "profile"),
    [
        ("MP", EntityKind.PUBLISHER, QOS_RELIABLE, QosProfile()),
        (
            "MS",
            EntityKind.SUBSCRIPTION,
            QOS_BEST_EFFORT,
            QosProfile(reliability=QosReliability.BEST_EFFORT),
        ),
    ],
)
def test_a_publishers_token_is_that_of_an_independent_client(
    kind: str, theirs: EntityKind, qos: str, profile: QosProfile
) -> None:
    ours = EndName(
        NODE, 11, "MP" if kind == "MP" else "MS", "/base/cmd_vel", types.TWIST, HASHES[types.TWIST], qos
    )
    entity = EndpointEntity(
        node=SDK_NODE,
        entity_id=11,
        kind=theirs,
        name="/base/cmd_vel",
        dds_type_name=dds_name(types.TWIST),
        type_hash=HASHES[types.TWIST],
        qos=profile.encode(),
    )
    assert ours.token == sdk_keys.endpoint_liveliness_keyexpr(entity)


def test_the_attachment_is_that_of_zenoh_and_of_an_independent_client() -> None:
    ours = attachment(3, 1_700_000_000_000_000_001, GID)
    assert ours == struct.pack("<qqB", 3, 1_700_000_000_000_000_001, 16) + GID
    assert len(ours) == 33
    serialized = zenoh.ext.z_serialize((zenoh.ext.Int64(3), zenoh.ext.Int64(1_700_000_000_000_000_001), GID))
    assert ours == serialized.to_bytes()
    assert Attachment.from_bytes(ours) == Attachment(3, 1_700_000_000_000_000_001, GID)


ODOM_END = (
    "@ros2_lv/0/aac3/0/8/MP/%/%robots%r2/driver/%robots%r2%odom/nav_msgs::msg::dds_::Odometry_/"
    "TypeHashNotSupported/::,10:,:,:,,"
)


@pytest.mark.parametrize("more", ["", "/backends", "/backends/and/others"])
def test_a_token_is_read_from_the_left(more: str) -> None:
    assert read_end(ODOM_END + more) == RosEnd(
        "MP", "/robots/r2/driver", "/robots/r2/odom", "nav_msgs::msg::dds_::Odometry_", UNHASHED
    )


@pytest.mark.parametrize("token", ["", "@ros2_lv/0", NODE.token, f"other/{ODOM_END.partition('/')[2]}"])
def test_what_is_no_endpoints_token_is_none(token: str) -> None:
    assert read_end(token) is None


def test_a_global_id_is_the_same_for_the_same_token() -> None:
    assert (len(gid_of(ODOM_END)), gid_of(ODOM_END)) == (16, gid_of(ODOM_END))
    assert gid_of(ODOM_END) != gid_of(NODE.token)
