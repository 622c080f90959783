"""A NAO V6 behind LoLA's socket. It checks each answer by the rules of the interface, and prints violations.

    python3 robots/lola/stand_in.py SOCKET [--seconds 30] [--realtime] [--fault KIND@SECOND ...] [--frames SOCKET] [--mode mujoco]

Kinematic, the default, has no dynamics: joints go where they are sent. In MuJoCo it plays until there is a goal, or the time is up; then
the chest button is held. It needs the packages `mujoco` and `numpy`; --seed, --size and --model belong to it.

Faults: short, long, malformed, missing, nan (one map), restart (closed, the robot sits), stall (2 s), press (0.3 s), chest (held 4 s),
battery (3 %), hot (a critical knee), push (0.4 m/s, in MuJoCo). In step, the robot waits for each answer; with --realtime it sends a map
each 12 ms. With --player, the last option, the command is started, and must end with exit code 0. Exit code 1 after a violation.
"""

import argparse
import math
import os
import random
import socket
import struct
import subprocess
import sys
import time

TOP = [7.46, 6.47, 7.94, 6.47, 7.46, 6.47, 17.38, 4.162, 4.162, 6.402, 6.402, 6.402, 4.162, 4.162, 6.402, 6.402, 6.402, 4.162, 7.94,
       6.47, 7.46, 6.47, 17.38, 8.33, 8.33]  # rad/s
LOW = [-119.5, -38.5, -119.5, -18, -119.5, -88.5, -104.5, -65.62, -21.74, -88, -5.29, -68.15, -22.79, -45.29, -88, -5.9, -67.97,
       -44.06, -119.5, -76, -119.5, 2, -104.5, 0, 0]  # degrees; hands: 0 to 1
HIGH = [119.5, 29.5, 119.5, 76, 119.5, -2, 104.5, 42.44, 45.29, 27.73, 121.04, 52.86, 44.06, 21.74, 27.73, 121.47, 53.4, 22.8, 119.5,
        18, 119.5, 88.5, 104.5, math.degrees(1), math.degrees(1)]
SHELL = [(0, -38.5, 29.51), (27.85, -38.5, 24.18), (43.32, -31.4, 21.2), (51.74, -27.5, 18.91), (62.45, -24.64, 17.19),
         (87.49, -18.91, 11.46), (119.52, -25.73, 18.91)]
LENGTHS = {"Position": 25, "Stiffness": 25, "LEar": 10, "REar": 10, "LEye": 24, "REye": 24, "Chest": 3, "LFoot": 3, "RFoot": 3,
           "Skull": 12, "Sonar": 2}
LEGS = range(7, 18)
SIT = [math.radians(a) for a in (0, 0, 80, 12, 0, -30, 0, 0, 0, -52, 119.5, -67.5, 0, 0, -52, 119.5, -67.5, 0, 80, -12, 0, 30, 0, 0, 0)]


Closed = type("Closed", (Exception,), {"__doc__": "The product has closed the socket."})


def array(key, values, pack):
    head = bytes([0x90 + len(values)]) if len(values) < 16 else b"\xdc" + struct.pack(">H", len(values))
    return bytes([0xA0 + len(key)]) + key.encode() + head + b"".join(map(pack, values))


def listen(path):
    if os.path.exists(path):
        os.unlink(path)
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(path)
    listener.listen(1)
    return listener


def hip_height(q):
    """Height of the hips over a sole, m, if the sole is level: the lengths of thigh, tibia and foot."""
    return max(0.1 * math.cos(q[hip]) + 0.1029 * math.cos(q[hip] + q[hip + 1]) + 0.04519 for hip in (9, 14))


class Kinematic:
    """A body whose joints go where they are sent. It never scores."""

    end = None

    def __init__(self):
        self.width, self.height = 320, 240
        self.reset()

    def reset(self):
        self.q = list(SIT)

    def step(self, targets, stiffness):
        self.q = [target if stiff > 0 else at for target, stiff, at in zip(targets, stiffness, self.q)]

    def values(self):
        return {}

    def image(self, _, number):
        pixels = bytearray(b"\x80") * (2 * self.width * self.height)
        pixels[::2] = random.Random(number).randbytes(self.width * self.height)  # grey noise: a camera without noise is broken
        return bytes(pixels)

    def report(self):
        return "no dynamics"


class Robot:
    def __init__(self, path, body):
        self.listener, self.body = listen(path), body
        self.last, self.violations, self.maps, self.answers, self.times = None, 0, 0, 0, []
        self.chest, self.released, self.charge, self.status = 0.0, None, 0.8, [0] * 25
        self.accept()

    def accept(self):
        self.link, _ = self.listener.accept()
        self.link.settimeout(20.0)  # of a busy computer
        self.file = self.link.makefile("rb")
        self.last = None

    def map(self):
        noise = random.Random(self.maps).gauss
        text = lambda value: bytes([0xA0 + len(value)]) + value.encode()
        entries = [array("RobotConfig", ["P0000000A00S00I00000", "6.0.0"] * 2, text)]
        values = {
            "Accelerometer": [noise(0, 0.02), noise(0, 0.02), -9.81 + noise(0, 0.02)], "Angles": [noise(0, 1e-3), noise(0, 1e-3)],
            "Battery": [self.charge, 0, -0.5, 30], "Current": [0.1] * 25, "FSR": [0.67 + noise(0, 0.01) for _ in range(8)],
            "Gyroscope": [noise(0, 2e-3) for _ in range(3)], "Position": self.body.q, "Sonar": [1, 1],
            "Stiffness": self.last[1] if self.last else [0] * 25, "Temperature": [38] * 25, "Touch": [self.chest] + [0] * 13,
            **self.body.values()}
        entries += [array(key, value, lambda number: b"\xca" + struct.pack(">f", number)) for key, value in values.items()]
        return b"\x8d" + b"".join(entries) + array("Status", self.status, lambda value: bytes([value]))

    def send(self, data):
        self.link.sendall(data)
        self.maps += 1

    def wrong(self, text):
        self.violations += 1
        print(f"violation in map {self.maps}: {text}")

    def read(self, count):
        data = self.file.read(count)
        if len(data) < count:
            raise Closed
        return data

    def answer(self):
        found = {}
        for _ in range(self.read(1)[0] & 0x0F):
            key = self.read(self.read(1)[0] & 0x1F).decode()
            head = self.read(1)[0]
            count = struct.unpack(">H", self.read(2))[0] if head == 0xDC else head & 0x0F
            if key not in LENGTHS or count != LENGTHS[key]:
                self.wrong(f"key {key} with {count} elements")
            kinds = [(kind := self.read(1)[0], self.read(4) if kind == 0xCA else b"") for _ in range(count)]
            if key != "Sonar" and any(kind != 0xCA for kind, _ in kinds):
                self.wrong(f"{key} has a value that is no float32")
                continue
            found[key] = [struct.unpack(">f", data)[0] for _, data in kinds if data]
            if key not in ("Position", "Stiffness") and not all(0 <= value <= 1 for value in found[key]):
                self.wrong(f"{key} is not within 0 and 1")
        self.answers += 1
        self.check(found.get("Position", self.body.q), found.get("Stiffness", self.last[1] if self.last else [0] * 25))

    def check(self, q, stiff):
        measured = self.body.q
        for j in range(25):
            if not math.radians(LOW[j]) - 0.02 <= q[j] <= math.radians(HIGH[j]) + 0.02:
                self.wrong(f"joint {j} at {q[j]}")
            if not (0 <= stiff[j] <= 1 or stiff[j] == -1):
                self.wrong(f"stiffness {stiff[j]} of joint {j}")
            if self.last and abs(q[j] - self.last[0][j]) > 1.5 * TOP[j] * 0.012 + 0.02:
                self.wrong(f"joint {j} jumps from {self.last[0][j]} to {q[j]}")
            if stiff[j] > 0 and not (self.last and self.last[1][j] > 0) and abs(q[j] - measured[j]) > 0.2:
                self.wrong(f"joint {j} becomes stiff at {q[j]}, measured {measured[j]}")
        yaw = min(abs(math.degrees(q[0])), 119.51)
        (a, low, high), (b, low2, high2) = next(pair for pair in zip(SHELL, SHELL[1:]) if pair[0][0] <= yaw < pair[1][0])
        share = (yaw - a) / (b - a)
        if not low + share * (low2 - low) - 1.7 <= math.degrees(q[1]) <= high + share * (high2 - high) + 1.7:
            self.wrong(f"the head hits its shell: {q[:2]}")
        if self.last and any(self.last[1][j] > 0 >= stiff[j] for j in LEGS) and hip_height(measured) > 0.175:
            self.wrong(f"limp with the hips at {hip_height(measured):.3f} m")
        self.body.step(q, stiff)
        self.last = (q, stiff)


def broken(kind, data):
    return {"short": data[:500], "long": data + bytes(40), "malformed": data[:300] + b"\xc1" * 9 + data[309:],
            "missing": data.replace(b"Gyroscope", b"Gyroskope"),
            "nan": data[:(at := data.index(b"Gyroscope") + 11)] + b"\x7f\xc0\0\0" + data[at + 4:]}[kind]


def frames(link, robot):
    """Sends the images that belong to the next map."""
    body, number = robot.body, robot.maps
    for camera in (0, 1):
        pixels = body.image(camera, number)
        header = struct.pack("<4sBBHHHIQII", b"FRM1", camera, 0, 0, body.width, body.height, number, 12000 * number, len(pixels), 0)
        link.sendall(header + pixels)


def strike(robot, kind):
    """Lets a fault happen; returns whether it takes the place of a map."""
    print(f"map {robot.maps}: {kind}", flush=True)
    if kind in ("chest", "press"):
        robot.chest, robot.released = 1.0, robot.maps + (330 if kind == "chest" else 25)
    elif kind == "restart":
        robot.link.shutdown(socket.SHUT_RDWR)
        robot.body.reset()
        robot.accept()
    elif kind == "stall":
        time.sleep(2.0)
    elif kind in ("battery", "hot"):
        robot.charge, robot.status[10] = (0.03, 0) if kind == "battery" else (0.8, 3)
    elif kind == "push":
        robot.body.push()
    else:
        robot.send(broken(kind, robot.map()))
        return True
    return False


def run(robot, args, link):
    faults = sorted((int(float(at) / 0.012), kind) for kind, at in (fault.split("@") for fault in args.fault))
    begin, is_over = time.monotonic(), False
    while robot.maps * 0.012 < args.seconds or args.mode == "mujoco":
        robot.chest = 0.0 if robot.maps == robot.released else robot.chest
        if not is_over and (robot.body.end or robot.maps * 0.012 >= args.seconds):
            is_over = True
            strike(robot, "chest")
        if faults and faults[0][0] <= robot.maps:
            before = time.monotonic()
            takes_place = strike(robot, faults.pop(0)[1])
            begin += time.monotonic() - before
            if takes_place:
                continue
        if link and robot.maps * 36 // 100 != (robot.maps - 1) * 36 // 100:  # 30 images a second
            frames(link, robot)
        if args.realtime:
            time.sleep(max(0.0, begin + robot.maps * 0.012 - time.monotonic()))
        sent = time.monotonic()
        robot.send(robot.map())
        robot.answer()
        robot.times.append(time.monotonic() - sent)


def body(args):
    if args.mode == "kinematic":
        return Kinematic()
    from mujoco_body import Body  # it needs packages
    return Body(args.model, args.seed, [int(number) for number in args.size.split("x")])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("socket")
    parser.add_argument("--mode", choices=["kinematic", "mujoco"], default="kinematic")
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--realtime", action="store_true")
    parser.add_argument("--fault", action="append", default=[], metavar="KIND@SECOND")
    parser.add_argument("--frames", metavar="SOCKET")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--size", choices=["320x240", "640x480"], default="320x240")
    parser.add_argument("--model", metavar="PATH", help="MJCF of robot and field; default: the project's robot on a field of 2009")
    parser.add_argument("--player", nargs=argparse.REMAINDER, metavar="COMMAND")
    args = parser.parse_args()
    player = args.player and subprocess.Popen(args.player)
    listener = listen(args.frames) if args.frames else None
    robot = Robot(args.socket, body(args))
    try:
        run(robot, args, listener and listener.accept()[0])
    except TimeoutError:
        robot.wrong("no answer within 20 s")
    except (Closed, ConnectionError):
        print("the product has closed the socket")
    stiff = "stiff" if robot.last and any(robot.last[1][j] > 0 for j in LEGS) else "limp"
    times = sorted(robot.times) or [0.0]
    print(f"{robot.maps} maps, {robot.answers} answers after {1e3 * times[-1]:.1f} ms at most, 99 % within "
          f"{1e3 * times[len(times) * 99 // 100]:.1f} ms; hips at {hip_height(robot.body.q):.3f} m, {stiff}; {robot.body.report()}; "
          f"{robot.violations} violations")
    sys.exit(robot.violations > 0 or bool(player) and ends_wrong(player))


def ends_wrong(player):
    try:
        code = player.wait(timeout=30)
    except subprocess.TimeoutExpired:
        player.kill()
        code = "none after 30 s"
    print(f"exit code of the player: {code}")
    return code != 0


if __name__ == "__main__":
    main()
