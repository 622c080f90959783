"""A robot's program that runs as a node, and a node that talks to it, for the tests."""

import os
import signal
import subprocess
import time
from collections.abc import Callable
from typing import Any

# Before rclpy is loaded: everything stays on this computer.
os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
os.environ.setdefault("ROS_DOMAIN_ID", "77")

import rclpy  # noqa: E402
from rclpy.node import Node  # noqa: E402
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data  # noqa: E402

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, reliability=ReliabilityPolicy.RELIABLE)
SENSOR = qos_profile_sensor_data
LIMIT = 30.0


class Robot:
    """A robot's program, until the end of a `with`."""

    def __init__(self, program: str, *arguments: str) -> None:
        self.process = subprocess.Popen([program, *arguments], stdout=subprocess.PIPE, text=True)

    def __enter__(self) -> "Robot":
        return self

    def __exit__(self, *_: object) -> None:
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=60)

    def line(self, begin: str) -> str:
        """Reads its output up to a line that begins so."""
        for line in self.process.stdout or []:
            if line.startswith(begin):
                return line
        raise AssertionError(f"the program printed no line `{begin}`")


class Peer:
    """A node, in a context of its own: for the robot it is another process."""

    def __init__(self, name: str) -> None:
        self.context = rclpy.Context()
        rclpy.init(context=self.context)
        self.node = Node(name, context=self.context)
        self.executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.got: dict[str, list[Any]] = {}
        self.clients: dict[str, Any] = {}

    def close(self) -> None:
        self.executor.shutdown()
        self.node.destroy_node()
        rclpy.shutdown(context=self.context)

    def listen(self, topic: str, kind: type, qos: QoSProfile | int = 1000) -> list[Any]:
        self.got[topic] = []
        self.node.create_subscription(kind, topic, self.got[topic].append, qos)
        return self.got[topic]

    def until(self, holds: Callable[[], Any], what: str, limit: float = LIMIT) -> Any:
        """Takes messages until something holds; a condition that never holds is an error."""
        end = time.monotonic() + limit
        while time.monotonic() < end:
            if value := holds():
                return value
            self.executor.spin_once(timeout_sec=0.05)
        raise AssertionError(f"{what}: not within {limit} s")

    def call(self, service: str, kind: type, during: Callable[[], Any] = lambda: None, **fields: Any) -> Any:
        # A new client may wait 3 s for its first answer, until both sides have found each other.
        if service not in self.clients:
            self.clients[service] = self.node.create_client(kind, service)
        client = self.clients[service]
        self.until(lambda: (during(), client.service_is_ready())[1], f"the service {service}")
        future = client.call_async(kind.Request(**fields))
        return self.until(lambda: (during(), future.done() and future.result())[1], f"the answer of {service}")
