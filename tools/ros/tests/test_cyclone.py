"""The wall follower, seen by a second implementation of DDS; and its recording, seen by `rosbags`."""

import os
import subprocess
import time
from pathlib import Path

os.environ.setdefault("ROS_DOMAIN_ID", "77")
# No multicast: the first participants of this computer are asked.
os.environ["CYCLONEDDS_URI"] = (
    "<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast>"
    "<Interfaces><NetworkInterface name='lo' multicast='false'/></Interfaces></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>30</MaxAutoParticipantIndex>"
    "<Peers><Peer address='127.0.0.1'/></Peers></Discovery></Domain></CycloneDDS>"
)

from cyclonedds.core import Policy, Qos  # noqa: E402
from cyclonedds.domain import DomainParticipant  # noqa: E402
from cyclonedds.sub import DataReader  # noqa: E402
from cyclonedds.topic import Topic  # noqa: E402
from cyclonedds.util import duration  # noqa: E402
from ros2_pyterfaces.cyclone import all_msgs as messages  # noqa: E402
from rosbags.rosbag2 import Reader  # noqa: E402
from rosbags.typesys import Stores, get_types_from_msg, get_typestore  # noqa: E402

WALLS = os.environ["BICA_WALL_FOLLOWER"]
FOLDER = Path(os.environ.get("BICA_FOLDER", "/tmp"))


def test_cyclone_reads_the_topics() -> None:
    robot = subprocess.Popen([WALLS, "run", "--ros"], stdout=subprocess.DEVNULL)
    try:
        participant = DomainParticipant(int(os.environ["ROS_DOMAIN_ID"]))
        reliable = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(100))
        effort = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(100))
        topics = {
            "rt/odom": (messages.Odometry, reliable),
            "rt/scan": (messages.LaserScan, effort),
            "rt/wall_follower/wall_detector/wall": (messages.MarkerArray, reliable),
        }
        readers = {}
        for name, (kind, qos) in topics.items():
            # The name of the type in DDS; the package has that of ROS.
            package, _, plain = kind.__idl_typename__.split("/")
            kind.__idl__.idl_transformed_typename = f"{package}::msg::dds_::{plain}_"
            readers[name] = DataReader(participant, Topic(participant, name, kind), qos=qos)
        got: dict[str, list] = {name: [] for name in topics}
        end = time.monotonic() + 30.0
        while time.monotonic() < end and not all(len(values) >= 20 for values in got.values()):
            for name, reader in readers.items():
                got[name].extend(reader.take(100))
            time.sleep(0.05)
        assert {name: len(values) >= 20 for name, values in got.items()} == dict.fromkeys(topics, True)
        last = got["rt/odom"][-1]
        assert (last.header.frame_id, last.child_frame_id) == ("odom", "base_link")
        assert len(got["rt/scan"][-1].ranges) == 72
    finally:
        robot.terminate()
        robot.wait(60)


def test_a_recording_is_a_bag() -> None:
    bag = FOLDER / "walls.mcap"
    subprocess.run([WALLS, "run", "--seconds", "60", "--force", "--record", bag], capture_output=True)
    known = get_typestore(Stores.ROS2_JAZZY)
    counts: dict[str, int] = {}
    with Reader(bag) as reader:
        for connection, stamp, raw in reader.messages():
            # What the bag says of a type is what ROS says of it.
            own = get_types_from_msg(connection.msgdef.data, connection.msgtype)
            for name, (_, fields) in own.items():
                if name in known.fielddefs:
                    assert fields == known.fielddefs[name][1], name
            if connection.msgtype in known.fielddefs:
                message = known.deserialize_cdr(raw, connection.msgtype)
                if connection.topic == "/odom":
                    assert message.header.stamp.sec * 10**9 + message.header.stamp.nanosec == stamp
            counts[connection.topic] = counts.get(connection.topic, 0) + 1
        assert 50 <= reader.duration * 1e-9 <= 61
        quality = {one.topic: one.ext.offered_qos_profiles[0] for one in reader.connections}
        latched = {topic for topic, profile in quality.items() if profile.durability.name == "TRANSIENT_LOCAL"}
        points = {topic for topic in latched if topic.endswith("/points")}
        assert points and latched - points == {"/rosout", *(f"/wall_follower/{name}" for name in ("scenery", "states", "explorer/state"))}
        assert quality["/scan"].reliability.name == "BEST_EFFORT" and quality["/odom"].reliability.name == "RELIABLE"
    assert {"/odom", "/scan", "/tf", "/wall_follower/states", "/wall_follower/scenery"} <= counts.keys(), counts
    # A run stores outputs a few times a second.
    assert counts["/odom"] > 150
