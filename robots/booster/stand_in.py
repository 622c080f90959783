"""A Booster T1 or K1 behind its topics, without dynamics: joints go where they are sent. It checks each message and prints violations.

    python3 robots/booster/stand_in.py t1|k1 [--domain 0] [--seconds 30] [--fault KIND@SECOND ...] [--frames SOCKET] [--kill]
                                       [--player COMMAND ...]

Faults, with times since the program has the robot: nan, count (20 states), gap (0.2 s), silence (1 s), deaf (no answers, 0.8 s), leave
(to damping), fall (maker's gait), push (with --mujoco, to the ground); `refuse@S` refuses all modes until S seconds after the first
request. With --player, the last option, the command is started, ended by SIGTERM after --seconds, and must end with exit code 0 within
6 s; with --kill it is ended by SIGKILL, and the robot must be damped or prepared by its guard within 6 s. --frames serves images of a ball
straight ahead, to which the maker's gait must be sent. With --mujoco, the robot has dynamics, and its pose is printed each second. Needs `cyclonedds` and, for --mujoco, `mujoco`. Exit code
1 after a violation.
"""

import argparse
import json
import math
import os
import random
import signal
import socket
import struct
import subprocess
import sys
import threading
import time

LOOPBACK = "<General><Interfaces><NetworkInterface address='127.0.0.1' multicast='true'/></Interfaces></General>"
# A loopback interface takes no multicast of the program, which answers an announcement of the robot.
LOOPBACK += "<Discovery><SPDPInterval>1s</SPDPInterval></Discovery>"
os.environ.setdefault("CYCLONEDDS_URI", f"<CycloneDDS><Domain>{LOOPBACK}</Domain></CycloneDDS>")

from cyclonedds.core import Policy, Qos  # noqa: E402
from cyclonedds.domain import DomainParticipant  # noqa: E402
from cyclonedds.pub import DataWriter  # noqa: E402
from cyclonedds.sub import DataReader  # noqa: E402
from cyclonedds.topic import Topic  # noqa: E402
from cyclonedds.util import duration  # noqa: E402
from messages import (FallDownState, ImuState, LowCmd, LowState, MotorState, Odometer, RpcReqMsg,  # noqa: E402
                      RpcRespMsg)

ARM = [(-3.316, 1.22), (-1.74, 1.57), (-2.27, 2.27), (-2.44, 0.0)]
LEGS = {"t1": [(-1.8, 1.57), (-0.2, 1.57), (-1, 1), (0, 2.34), (-0.87, 0.35), (-0.44, 0.44)],
        "k1": [(-3, 2.21), (-0.4, 1.57), (-1, 1), (0, 2.23), (-0.87, 0.345), (-0.345, 0.345)]}
HEAD = {"t1": [(-1.57, 1.57), (-0.35, 1.22)], "k1": [(-1, 1), (-0.349, 0.855)]}
TORQUE = {"t1": 60, "k1": 40}
DAMPING, PREPARE, WALKING, CUSTOM, SOCCER = range(5)
SIZE, BALL = (320, 240), (170, 6)  # pixels: of an image; row and radius of a ball
GREEN, ORANGE = bytes([75, 113, 75, 92]), bytes([128, 63, 128, 209])  # Y U Y V
LATENCY = 0.1  # s, of messages that were on their way when the mode changed or a fault began


def ranges(robot):
    waist = [(-1.57, 1.57)] if robot == "t1" else []
    arm, leg = ([(-high, -low) if index % 2 else (low, high) for index, (low, high) in enumerate(limb)] for limb in (ARM, LEGS[robot]))
    return HEAD[robot] + ARM + arm + waist + LEGS[robot] + leg[:2] + LEGS[robot][2:]


def qos(reliable, local=False, depth=1):
    return Qos(Policy.Reliability.Reliable(duration(milliseconds=100)) if reliable else Policy.Reliability.BestEffort,
               Policy.Durability.TransientLocal if local else Policy.Durability.Volatile, Policy.History.KeepLast(depth),
               Policy.DataRepresentation(use_cdrv0_representation=True))


class Robot:
    def __init__(self, robot, domain, faults, has_dynamics=False):
        participant = DomainParticipant(domain)
        topic = lambda name, kind: Topic(participant, name, kind)
        self.states = DataWriter(participant, topic("rt/low_state", LowState), qos=qos(False))
        self.odometry = DataWriter(participant, topic("rt/odometer_state", Odometer), qos=qos(False))
        self.falls = DataWriter(participant, topic("rt/fall_down", FallDownState), qos=qos(False))
        self.answers = DataWriter(participant, topic("rt/LocoApiTopicResp", RpcRespMsg), qos=qos(True, depth=16))
        self.commands = DataReader(participant, topic("rt/joint_ctrl", LowCmd), qos=qos(True, True, 64))
        self.requests = DataReader(participant, topic("rt/LocoApiTopicReq", RpcReqMsg), qos=qos(True, True, 16))
        self.participant, self.ranges, self.torque = participant, ranges(robot), TORQUE[robot]
        self.q = [0.0] * len(self.ranges)
        for index, value in ((3, -1.4), (7, 1.4)):
            self.q[index] = value
        self.dynamics, self.dq, self.stepped, self.track = None, [0.0] * len(self.q), 0, []
        if has_dynamics:
            from dynamics import Dynamics
            self.dynamics = Dynamics(robot)
            self.q, self.dq = self.dynamics.angles()
        self.mode, self.mode_since, self.left = DAMPING, 0.0, None
        self.start, self.entered, self.now = time.monotonic(), None, 0.0
        self.last, self.last_at, self.gains, self.had_gains = None, 0.0, False, False
        self.refuses = max((at for kind, at in faults if kind == "refuse"), default=0.0)
        faults = [fault for fault in faults if fault[0] != "refuse"]
        self.faults, self.active, self.fall, self.fell = sorted(faults, key=lambda fault: fault[1]), {}, 0, None
        self.asked, self.refused, self.violations, self.counts, self.speed = None, {}, [], {}, 0.0
        self.silent_since, self.rested, self.velocity, self.turn = None, None, 0.0, 0.0

    def violation(self, text):
        self.violations.append(text)
        if len(self.violations) <= 20:
            print(f"VIOLATION at {self.now:.3f} s: {text}", file=sys.stderr)

    def count(self, name):
        self.counts[name] = self.counts.get(name, 0) + 1

    def is_active(self, fault):
        return self.now < self.active.get(fault, -1.0)

    def begin_faults(self):
        lasting = {"nan": 0.04, "count": 0.04, "gap": 0.2, "silence": 1.0, "deaf": 0.8}
        while self.entered is not None and self.faults and self.now - self.entered >= self.faults[0][1]:
            kind, _ = self.faults.pop(0)
            self.count("fault " + kind)
            self.active[kind] = self.now + lasting.get(kind, 0.0)
            if kind == "leave":
                self.set_mode(DAMPING)
                self.left = self.now
            if kind == "push" and self.dynamics:
                self.dynamics.push()
            if kind == "fall":
                self.fall, self.fell = 2, self.now

    def set_mode(self, mode):
        if self.mode != mode:
            self.mode, self.mode_since = mode, self.now

    def publish(self, number):
        if self.is_active("gap") or self.is_active("silence"):
            self.silent_since = self.silent_since or self.now
            return
        self.silent_since = self.rested = None
        noise = random.Random(number).gauss
        motors = [MotorState(0, value + noise(0, 1e-4), speed, 0.0, 0.0, 40, 0, [0, 0]) for value, speed in zip(self.q, self.dq)]
        if self.is_active("nan"):
            motors[number % len(motors)].q = math.nan
        serial = motors[:-1] if self.is_active("count") else motors
        measured = self.dynamics.inertial() if self.dynamics else ([0.0] * 3, [0.0, 0.0, self.turn], [0.0, 0.0, 9.81])
        imu = ImuState(*([value + noise(0, sigma) for value in values] for values, sigma in zip(measured, (1e-3, 1e-3, 0.02))))
        self.states.write(LowState(imu, motors, serial))
        self.count("states")
        if number % 10 == 0:
            self.odometry.write(Odometer(0.0, 0.0, 0.0))
            self.falls.write(FallDownState(self.fall, self.fall == 2))

    def check(self, command):
        self.count("commands")
        motors = command.motor_cmd
        if command.cmd_type != 1:
            self.violation(f"type {command.cmd_type:#x}: SERIAL with zero padding is 1")
        if len(motors) != len(self.ranges):
            return self.violation(f"{len(motors)} motors")
        for index, (motor, (low, high)) in enumerate(zip(motors, self.ranges)):
            if not all(map(math.isfinite, (motor.q, motor.dq, motor.tau, motor.kp, motor.kd, motor.weight))):
                self.violation(f"motor {index}: not finite")
            elif not (0 <= motor.weight <= 1 and 0 <= motor.kp <= 1000 and 0 <= motor.kd <= 50 and abs(motor.tau) <= self.torque):
                self.violation(f"motor {index}: {motor}")
            if motor.kp > 0 and motor.kd <= 0:
                self.violation(f"motor {index}: kp without kd")
            if not low - 0.02 <= motor.q <= high + 0.02:
                self.violation(f"motor {index}: q {motor.q} is not within {low} and {high}")
        had_gains, self.gains = self.gains, any(motor.kp > 0 or motor.kd > 0 for motor in motors)
        if self.gains:
            self.check_gains(motors, had_gains)
        self.last, self.last_at = motors, self.now

    def check_gains(self, motors, had_gains):
        if self.mode != CUSTOM:
            # A robot that has left by itself is noticed within two seconds.
            allowed = 2.0 if self.left is not None else LATENCY
            if self.now - self.mode_since > allowed:
                self.violation(f"gains in mode {self.mode}")
            return
        if self.entered is None:
            self.entered = self.now
        self.had_gains = True
        if not had_gains:
            far = max(abs(motor.q - value) for motor, value in zip(motors, self.q))
            if far > 0.3:
                self.violation(f"the first target is {far:.3f} rad from the measured angle")
        elif self.last_at < self.now:
            step = max(abs(motor.q - last.q) for motor, last in zip(motors, self.last))
            # Messages wait for each other on their way; the driver sends every 10 ms.
            speed = step / max(self.now - self.last_at, 0.008)
            self.speed = max(self.speed, speed)
            if speed > 20:
                self.violation(f"a target moves at {speed:.1f} rad/s")
        if self.silent_since is not None and self.now - self.silent_since > 0.05 + LATENCY:
            if self.rested is None:
                self.rested = [motor.q for motor in motors]
            elif max(abs(motor.q - value) for motor, value in zip(motors, self.rested)) > 1e-4:
                self.violation("targets move without states")
        for index, motor in enumerate(motors):
            if motor.kp > 0 and not self.dynamics:
                self.q[index] = motor.q

    def answer(self, request):
        if self.is_active("deaf"):
            self.asked = self.now
            return
        try:
            service, body = json.loads(request.header)["api_id"], json.loads(request.body or "{}")
        except (ValueError, KeyError) as error:
            return self.violation(f"request {request}: {error}")
        self.count(f"request {service}")
        if self.asked is None and self.refuses:
            self.active["refuse"] = self.now + self.refuses
        status, result = 0, ""
        if service == 2000:
            status = self.change(body.get("mode"))
        elif service == 2001:
            is_early = self.mode not in (WALKING, SOCCER) and self.now - self.mode_since > 0.6
            self.velocity, self.turn = max(self.velocity, body.get("vx", 0.0)), body.get("vyaw", 0.0)
            if is_early or set(body) != {"vx", "vy", "vyaw"}:
                self.violation(f"velocity {body} in mode {self.mode}")
        elif service == 2004:
            self.q[0], self.q[1] = body["yaw"], body["pitch"]
        elif service == 2008:
            if self.fall != 2:
                self.violation("getting up without a fall")
            self.fall, self.fell = 3, self.now
        elif service == 2017:
            self.asked, result = self.now, json.dumps({"mode": self.mode})
        self.answers.write(RpcRespMsg(request.uuid, json.dumps({"status": status}), result))

    def change(self, mode):
        if mode == CUSTOM and self.left is not None:
            self.violation("custom is asked for again without an operator")
        if mode in self.refused and self.now - self.refused[mode] < 0.95:
            self.violation(f"mode {mode} is asked for again after {self.now - self.refused[mode]:.2f} s")
        if self.is_active("refuse"):
            self.refused[mode] = self.now
            return 501
        if mode in (CUSTOM, WALKING) and self.mode not in (PREPARE, mode) and self.fell is None:
            self.violation(f"mode {mode} is asked for in mode {self.mode}")
        if mode == WALKING and self.entered is None:
            self.entered = self.now
        self.set_mode(mode)
        return 0

    def step(self, number):
        self.now = time.monotonic() - self.start
        self.begin_faults()
        # What a writer leaves behind at its end is no message.
        for request in filter(lambda taken: isinstance(taken, RpcReqMsg), self.requests.take(16)):
            self.answer(request)
        for command in filter(lambda taken: isinstance(taken, LowCmd), self.commands.take(64)):
            self.check(command)
        self.now = time.monotonic() - self.start
        if self.gains and self.now - self.last_at > 0.2:
            self.violation(f"no command for {self.now - self.last_at:.3f} s while gains are on")
            self.last_at = self.now
        if self.asked is not None and self.now - self.asked > 1.0 + LATENCY and not self.is_active("deaf"):
            self.violation("the mode is not asked for each second")
            self.asked = self.now
        if self.fall == 3 and self.now - self.fell > 2.0:
            self.fall = 0
        if self.silent_since is not None and self.now - self.silent_since > 0.5 + 3 * LATENCY and self.mode == CUSTOM and self.gains:
            self.violation("no damping without states")
        if self.dynamics:
            self.move(number)
        self.publish(number)

    def move(self, number):
        is_commanded = self.mode == CUSTOM and self.last is not None
        # The robot hangs on a crane until a program has it: the firmware's own balance is not modelled.
        is_held = self.mode in (PREPARE, WALKING, SOCCER) or self.entered is None
        self.counts["steps lost"] = self.counts.get("steps lost", 0) + max(0, number - self.stepped - 10)
        self.dynamics.advance(min(number - self.stepped, 10), self.last if is_commanded else None, is_held)
        self.stepped = number
        self.q, self.dq = self.dynamics.angles()
        if not self.track or self.now - self.track[-1][0] >= 1.0:
            self.track.append((self.now, *self.dynamics.pose()))
            print("pose at {:.1f} s: x {:.3f} m, y {:.3f} m, height {:.3f} m, yaw {:.3f} rad".format(*self.track[-1]), flush=True)


def run(robot, seconds, player, script=None, ending=signal.SIGTERM):
    """Publishes 500 states a second until the time is up or the script is over; returns whether the program ended in order."""
    number, end, process, stopped = 0, None, None, None
    if player:
        process = subprocess.Popen(player)
    while True:
        robot.step(number)
        number += 1
        is_over = script is not None and next(script, robot) is robot
        if end is None and (is_over or robot.now >= seconds):
            if process is None:
                return True
            process.send_signal(ending)
            end, stopped = robot.now + 6.0, robot.now
        if process is not None and process.poll() is not None and stopped is not None and ending == signal.SIGKILL:
            # The guard has the robot; a mode that is left at once is seen by the last gains.
            if robot.mode in (DAMPING, PREPARE) and not robot.gains and robot.now > stopped + 1.0:
                return True
        elif process is not None and process.poll() is not None:
            robot.counts["exit"] = process.returncode
            if stopped is None:
                robot.violation("the program has ended by itself")
            return process.returncode == 0
        if end is not None and robot.now > end:
            robot.violation("the program does not end within 6 s")
            process.kill()
            return False
        time.sleep(max(0.0, robot.start + 0.002 * number - time.monotonic()))
        # A busy machine: the states that are late are left out.
        number = max(number, int((time.monotonic() - robot.start) / 0.002) - 5)


class Camera:
    """Serves images of a ball on a field, 30 a second, on a thread of its own."""

    def __init__(self, path):
        self.listener, self.images = socket.socket(socket.AF_UNIX), 0
        if os.path.exists(path):
            os.unlink(path)
        self.listener.bind(path)
        self.listener.listen(1)
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        link, _ = self.listener.accept()
        pixels, noise = bytearray(scene()), random.Random(0)
        while True:
            # An image without noise is that of a broken camera.
            pixels[2 * noise.randrange(len(pixels) // 2)] ^= 1
            try:
                link.sendall(struct.pack("<4sBBHHHIQII", b"FRM1", 0, 0, 0, *SIZE, 0, 0, len(pixels), 0) + pixels)
            except OSError:
                return
            self.images += 1
            time.sleep(1 / 30)


def scene():
    """A ball in the middle of a green image, in YUYV."""
    (width, height), (middle, radius) = SIZE, BALL
    half = lambda row: int(math.sqrt(max(0, radius ** 2 - (row - middle) ** 2)) / 2)
    return b"".join(GREEN * (width // 4 - half(row)) + ORANGE * (2 * half(row)) + GREEN * (width // 4 - half(row)) for row in range(height))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robot", choices=["t1", "k1"])
    parser.add_argument("--domain", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--fault", action="append", default=[])
    parser.add_argument("--frames", metavar="SOCKET")
    parser.add_argument("--kill", action="store_true")
    parser.add_argument("--mujoco", action="store_true")
    parser.add_argument("--player", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    faults = [(kind, float(at)) for kind, at in (fault.split("@") for fault in options.fault)]
    robot = Robot(options.robot, options.domain, faults, options.mujoco)
    camera = Camera(options.frames) if options.frames else None
    is_ended = run(robot, options.seconds, options.player, ending=signal.SIGKILL if options.kill else signal.SIGTERM)
    if camera and camera.images < 10 * options.seconds / 2:
        robot.violation(f"only {camera.images} images were read")
    if camera and robot.counts.get("request 2001") and robot.velocity < 0.05:
        robot.violation(f"the robot does not go to the ball: {robot.velocity} m/s at most")
    if robot.entered is None or robot.faults:
        robot.violation(f"nobody has taken the robot, or there was no time for the faults {robot.faults}")
    if options.player:
        if not is_ended:
            robot.violation("exit code")
        if robot.gains or (robot.left is None and robot.mode not in (DAMPING, PREPARE)):
            robot.violation(f"the robot is left in mode {robot.mode}, with gains: {robot.gains}")
    entered = "never" if robot.entered is None else f"{robot.entered:.2f} s"
    print(f"{len(robot.violations)} violations; taken at {entered}; mode {robot.mode}; fastest target {robot.speed:.1f} rad/s; "
          + ", ".join(f"{name}: {count}" for name, count in sorted(robot.counts.items())))
    return 1 if robot.violations else 0


if __name__ == "__main__":
    sys.exit(main())
