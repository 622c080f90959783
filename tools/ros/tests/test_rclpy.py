"""The wall follower and the forward as nodes, seen by rclpy: another implementation of ROS and of DDS."""

import json
import math
import os
import random
import socket
import subprocess
from pathlib import Path

import pytest

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped, Twist, Vector3
from nav_msgs.msg import Odometry
from peer import LATCHED, SENSOR, Peer, Robot
from rcl_interfaces.msg import Log, Parameter, ParameterEvent, ParameterValue
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, CompressedImage, Imu, JointState, LaserScan
from std_msgs.msg import Empty, Float32, Float32MultiArray, String
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray

WALLS = os.environ["BICA_WALL_FOLLOWER"]
FORWARD = os.environ.get("BICA_PROGRAM")
FOLDER = Path(os.environ.get("BICA_FOLDER", "/tmp"))
COUNT = int(os.environ.get("BICA_MESSAGES", "500"))
NODE = "/wall_follower"


def number(name: str, value: float) -> Parameter:
    return Parameter(name=name, value=ParameterValue(type=3, double_value=value))


def text(name: str, value: str) -> Parameter:
    return Parameter(name=name, value=ParameterValue(type=4, string_value=value))


def seconds(stamp) -> float:
    return stamp.sec + stamp.nanosec * 1e-9


def test_topics_have_their_types_and_the_values_of_the_link() -> None:
    with Robot(WALLS, "run", "--ros", "--serve", "127.0.0.1:0") as robot:
        address = robot.line("link").split()[-1]
        peer = Peer("values")
        odometry = peer.listen("/odom", Odometry)
        scans = peer.listen("/scan", LaserScan, SENSOR)
        distances = peer.listen(f"{NODE}/wall_detector/distance", Float32)
        walls = peer.listen(f"{NODE}/wall_detector/wall", MarkerArray)
        scenery = peer.listen(f"{NODE}/scenery", MarkerArray, LATCHED)
        clock = peer.listen("/clock", Clock, SENSOR)
        states = peer.listen(f"{NODE}/states", DiagnosticStatus, LATCHED)
        state = peer.listen(f"{NODE}/explorer/state", String, LATCHED)
        diagnostics = peer.listen("/diagnostics", DiagnosticArray)
        peer.until(lambda: ("wall_follower", "/") in peer.node.get_node_names_and_namespaces(), "the node")
        everything = [odometry, scans, distances, walls, scenery, clock, states, state, diagnostics]
        peer.until(lambda: all(everything), "each topic")
        command = [WALLS, "link", address, "watch", "Odometry.pose", "--count", str(COUNT), "--json"]
        with (FOLDER / "watched").open("w+") as file:
            watching = subprocess.Popen(command, stdout=file, stderr=subprocess.DEVNULL)
            peer.until(lambda: watching.poll() is not None, "the link's values", COUNT / 20 + 60)
            file.seek(0)
            lines = [json.loads(line) for line in file]
        own = {line["cycle"]: line["value"] for line in lines if line.get("name") == "Odometry.pose"}
        # A cycle of this world is 20 ms.
        cycle = lambda message: round(50.0 * seconds(message.header.stamp))  # noqa: E731
        peer.until(lambda: cycle(odometry[-1]) > max(own), "the last value")
        got = {cycle(one): one.pose.pose for one in odometry}
        assert len(own) >= COUNT * 0.9
        missing = own.keys() - got.keys()
        assert len(missing) <= 0.02 * len(own), f"{len(missing)} of {len(own)} are missing"
        for number in own.keys() & got.keys():
            value, pose = own[number], got[number]
            assert (pose.position.x, pose.position.y) == (value["x"], value["y"])
            heading = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
            assert abs(math.remainder(heading - value["heading"], math.tau)) < 1e-9
        assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("odom", "base_link")
        assert scans[-1].header.frame_id == "base_link" and len(scans[-1].ranges) == 72
        assert state[-1].data in ("search_wall", "follow_wall", "turn_left", "round_end", "arrive")
        assert {value.key for value in states[-1].values} >= {"Explorer", "Drive"}
        peer.close()


def test_parameters_are_listed_described_set_and_refused() -> None:
    with Robot(WALLS, "run", "--ros", "--ros-operator") as robot:
        robot.line("ros")
        peer = Peer("tuner")
        events = peer.listen("/parameter_events", ParameterEvent)
        listed = peer.call(f"{NODE}/list_parameters", ListParameters).result
        assert {"Explorer.speed", "Explorer.gain", "Drive.acceleration", "use_sim_time"} <= set(listed.names)
        assert {"Explorer", "Drive"} <= set(listed.prefixes)
        [speed] = peer.call(f"{NODE}/describe_parameters", DescribeParameters, names=["Explorer.speed"]).descriptors
        [limits] = speed.floating_point_range
        assert (limits.from_value, limits.to_value, limits.step) == (0.1, 0.6, 0.05)
        assert (speed.description, speed.additional_constraints) == ("Speed ahead.", "unit: m/s")

        def get(*names: str) -> list[float]:
            return [value.double_value for value in peer.call(f"{NODE}/get_parameters", GetParameters, names=names).values]

        def set_all(*parameters: Parameter):
            return peer.call(f"{NODE}/set_parameters_atomically", SetParametersAtomically, parameters=parameters).result

        assert get("Explorer.speed") == [0.4]
        done = set_all(number("Explorer.speed", 0.3), number("Explorer.gain", 3.0))
        assert done.successful, done.reason
        assert get("Explorer.speed", "Explorer.gain") == [0.3, 3.0]
        peer.until(lambda: any(one.node == NODE and one.changed_parameters for one in events), "the event")
        refused = set_all(number("Explorer.speed", 0.5), number("Explorer.gain", 99.0))
        assert not refused.successful and "0.5 to 5.0" in refused.reason, refused.reason
        assert get("Explorer.speed", "Explorer.gain") == [0.3, 3.0]
        unknown = set_all(number("Explorer.sped", 0.5))
        assert not unknown.successful and "did you mean `speed`?" in unknown.reason
        each = [number("Explorer.speed", 0.35), number("Explorer.speed", 9.0), text("use_sim_time", "x")]
        results = peer.call(f"{NODE}/set_parameters", SetParameters, parameters=each).results
        assert [one.successful for one in results] == [True, False, False]
        peer.close()


def test_a_twist_drives_under_the_lease_only() -> None:
    with Robot(WALLS, "run", "--ros") as robot:
        robot.line("ros")
        driver, other = Peer("driver"), Peer("other")
        odometry = driver.listen("/odom", Odometry)
        state = driver.listen(f"{NODE}/explorer/state", String, LATCHED)
        driver.until(lambda: odometry and state, "odometry and state")
        commands = {peer: peer.node.create_publisher(Twist, "/cmd_vel", 10) for peer in (driver, other)}
        turn = Twist()
        turn.angular.z = 1.0

        def drives(peer: Peer) -> bool:
            commands[peer].publish(turn)
            last = odometry[-1].twist.twist if odometry else Twist()
            return last.linear.x < 0.01 and abs(last.angular.z - 1.0) < 0.01 and state[-1].data == "latent"

        # Without the lease nothing moves.
        end = len(odometry) + 100
        driver.until(lambda: drives(driver) or len(odometry) > end, "two seconds")
        assert state[-1].data != "latent"
        refused = driver.call(f"{NODE}/lease/release", Trigger)
        assert not refused.success and "lease/acquire" in refused.message
        assert driver.call(f"{NODE}/lease/acquire", Trigger).success
        driver.until(lambda: drives(driver), "driving")

        # The driver goes on driving: its silence of 3 s would end the lease, and the first answers may take as long.
        def go_on() -> bool:
            return drives(driver)

        refused = other.call(f"{NODE}/lease/acquire", Trigger, go_on)
        assert not refused.success and "another ROS process" in refused.message
        speed = [number("Explorer.speed", 0.2)]
        refused = other.call(f"{NODE}/set_parameters", SetParameters, go_on, parameters=speed)
        assert not refused.results[0].successful
        # Silence stops the robot after 0.5 s, and ends the lease after 3 s: then the tree drives again.
        driver.until(lambda: abs(odometry[-1].twist.twist.angular.z) < 0.01, "the stop")
        driver.until(lambda: state[-1].data != "latent", "the end of the lease")
        assert other.call(f"{NODE}/lease/acquire", Trigger).success
        assert driver.call(f"{NODE}/lease/take", Trigger).success
        other.close()
        driver.close()


def test_a_stop_needs_no_lease_and_a_stream_of_twists_does_not_undo_it() -> None:
    with Robot(WALLS, "run", "--ros", "--ros-operator") as robot:
        robot.line("ros")
        driver, other = Peer("driver"), Peer("other")
        odometry = driver.listen("/odom", Odometry)
        commands = driver.node.create_publisher(Twist, "/cmd_vel", 10)
        stop = other.node.create_publisher(Empty, f"{NODE}/stop", 10)
        turn = Twist()
        turn.angular.z = 1.0

        def speed(one: Odometry) -> float:
            return abs(one.twist.twist.linear.x) + abs(one.twist.twist.angular.z)

        def drives() -> bool:
            commands.publish(turn)
            return bool(odometry) and abs(odometry[-1].twist.twist.angular.z - 1.0) < 0.01

        def stands_for(count: int, push) -> None:
            driver.until(lambda: (push(), speed(odometry[-1]) < 0.01)[1], "the stop")
            end = len(odometry) + count
            driver.until(lambda: (push(), len(odometry) > end)[1], "some seconds")
            assert max(speed(one) for one in odometry[-count:]) < 0.01

        driver.until(drives, "driving")
        assert other.call(f"{NODE}/stop", Trigger, drives).success
        stands_for(150, drives)
        refused = driver.call(f"{NODE}/drive/release", Trigger, drives)
        assert not refused.success and "lease/acquire" in refused.message
        assert driver.call(f"{NODE}/lease/acquire", Trigger).success
        assert driver.call(f"{NODE}/drive/release", Trigger).success
        driver.until(drives, "driving again")
        stands_for(50, lambda: (stop.publish(Empty()), drives()))
        other.close()
        driver.close()


def test_services_and_topics_call_what_the_tree_offers() -> None:
    with Robot(WALLS, "run", "--ros", "--ros-operator") as robot:
        robot.line("ros")
        peer = Peer("caller")
        odometry = peer.listen("/odom", Odometry)
        state = peer.listen(f"{NODE}/explorer/state", String, LATCHED)
        peer.until(lambda: odometry and state, "odometry and state")

        def call(service: str, *parameters: Parameter):
            return peer.call(f"{NODE}/{service}", SetParametersAtomically, parameters=parameters).result

        # Silence of 3 s ends the lease, so the first answers, which may take as long, come before the hold.
        assert call("drive/request", number("forward", 0.1)).successful
        assert call("hold", text("Drive", "active")).successful
        held = [text("Explorer", "latent"), text("Drive", "active"), text("Odometry", "active")]
        assert call("hold", *held).successful
        peer.until(lambda: state[-1].data == "latent", "the hold")
        assert call("drive/request", number("forward", 0.2)).successful
        peer.until(lambda: abs(odometry[-1].twist.twist.linear.x - 0.2) < 0.01, "the speed")
        refused = call("drive/request", number("forward", 2.0))
        assert not refused.successful and "-0.6 to 0.6" in refused.reason
        assert "forward, turn" in call("drive/request", number("sideways", 2.0)).reason
        commands = peer.node.create_publisher(Float32MultiArray, f"{NODE}/drive/request", 1)
        twists, log = peer.node.create_publisher(Twist, "/cmd_vel", 10), peer.listen("/rosout", Log, LATCHED)

        def moves() -> bool:
            commands.publish(Float32MultiArray(data=[-0.1, 0.0]))
            return abs(odometry[-1].twist.twist.linear.x + 0.1) < 0.01

        peer.until(moves, "the topic")
        # One after the other: the topic of the log keeps one line.
        commands.publish(Float32MultiArray(data=[0.2, 0.0, 0.3]))
        peer.until(lambda: any("takes 2 arguments, found 3" in line.msg for line in log), "a refusal of three numbers")
        twists.publish(Twist(linear=Vector3(x=math.inf)))
        peer.until(lambda: any("not a finite number" in line.msg for line in log), "a refusal of an infinite speed")
        assert abs(odometry[-1].twist.twist.linear.x + 0.1) < 0.01
        assert call("world/place_box", number("x", 5.0), number("y", 3.0)).successful
        assert peer.call(f"{NODE}/pause", Trigger).success
        before = peer.until(lambda: odometry and odometry[-1].header.stamp, "a stamp")
        assert peer.call(f"{NODE}/resume", Trigger).success
        peer.until(lambda: odometry[-1].header.stamp != before, "time goes on")
        peer.close()


def hostile(port: int, number: int) -> None:
    """Sends what is no RTPS, or a damaged packet of it, to all ports that a participant of the domain may have."""
    chance = random.Random(number)
    prefix = b"RTPS\x02\x03\x01\x0f" + bytes(chance.randrange(256) for _ in range(12))
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    for index in range(200):
        body = bytes(chance.randrange(256) for _ in range(chance.randrange(1, 1400)))
        # Heartbeats, data and fragments with random flags and lengths.
        kind = bytes([chance.choice([0x06, 0x07, 0x08, 0x09, 0x0E, 0x12, 0x13, 0x15, 0x16]), chance.randrange(256)])
        packet = [body, prefix + body, prefix + kind + body, prefix + kind + len(body).to_bytes(2, "little") + body]
        for offset in (0, 1, 10, 11, 12, 13):
            peer.sendto(packet[index % 4], ("127.0.0.1", port + offset))


def test_hostile_peers_do_not_change_what_the_robot_does() -> None:
    """Its recording is, up to the end, that of a run that nobody attacks."""
    files = [str(FOLDER / f"{name}.mcap") for name in ("quiet", "attacked")]
    quiet = [WALLS, "run", "--seconds", "20", "--force", "--record", files[0]]
    subprocess.run(quiet, capture_output=True, check=False)
    with Robot(WALLS, "run", "--ros", "--seconds", "20", "--force", "--record", files[1]) as robot:
        robot.line("ros")
        port = 7400 + 250 * int(os.environ["ROS_DOMAIN_ID"])
        for peer in range(20):
            hostile(port, peer)
        # The node is still there.
        peer = Peer("witness")
        scans = peer.listen("/scan", LaserScan, SENSOR)
        peer.until(lambda: scans, "a scan after the attack")
        peer.close()
        robot.process.wait(60)
    compared = subprocess.run([WALLS, "replay", files[0], "--against", files[1]], capture_output=True, text=True)
    assert compared.returncode == 0, compared.stdout + compared.stderr


@pytest.mark.skipif(not FORWARD, reason="BICA_PROGRAM is not set")
def test_the_forward() -> None:
    with Robot(FORWARD, "play", "--ros", "--ros-operator", "--seconds", "300", "--size", "640x480") as robot:
        robot.line("ros")
        peer = Peer("forward")
        joints = peer.listen("/joint_states", JointState)
        inertial = peer.listen("/imu", Imu, SENSOR)
        odometry = peer.listen("/odom", Odometry)
        pose = peer.listen("/forward/localization/robot_pose", PoseWithCovarianceStamped)
        images = peer.listen("/camera/image_raw/compressed", CompressedImage, SENSOR)
        cameras = peer.listen("/camera/camera_info", CameraInfo, SENSOR)
        everything = {"joints": joints, "imu": inertial, "odometry": odometry, "images": images, "cameras": cameras}
        peer.until(lambda: all(everything.values()), "each topic", 90)
        peer.until(lambda: pose, "a pose", 90)
        variances = [pose[-1].pose.covariance[7 * axis] for axis in (0, 1, 5)]
        assert all(0.0 < variance < 1.0 for variance in variances), variances
        assert len(joints[-1].name) == len(joints[-1].position) == 25 and "HeadYaw" in joints[-1].name
        assert 8.0 < inertial[-1].linear_acceleration.z < 12.0 and inertial[-1].header.frame_id == "torso"
        assert bytes(images[-1].data[:2]) == b"\xff\xd8" and images[-1].header.frame_id == "camera_optical"
        peer.until(lambda: (cameras[-1].width, cameras[-1].height) == (640, 480), "the size of the camera")
        assert (pose[-1].header.frame_id, odometry[-1].header.frame_id) == ("map", "odom")
        commands = peer.node.create_publisher(Twist, "/cmd_vel", 10)
        start = odometry[-1].pose.pose.position
        twist = Twist()
        twist.linear.x = 0.15

        def walks() -> bool:
            commands.publish(twist)
            place = odometry[-1].pose.pose.position
            return math.hypot(place.x - start.x, place.y - start.y) > 0.3

        peer.until(walks, "the forward walks", 120)
        peer.close()
