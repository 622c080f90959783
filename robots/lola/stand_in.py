"""A NAO V6 behind LoLA's socket, without dynamics: joints go where they are sent. It checks each answer and prints violations.

    python3 robots/lola/stand_in.py SOCKET [--seconds 30] [--real-time] [--fault KIND@SECOND ...] [--frames SOCKET]

Faults: short, long, malformed, missing, nan (one map), restart (closed, the robot sits), stall (2 s), press (0.3 s), chest (held 4 s),
battery (3 %), hot (a critical knee). In step, the robot waits for each answer. Exit code 1 after a violation.
"""

import argparse
import math
import os
import random
import socket
import struct
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


class Robot:
    def __init__(self, path):
        self.listener = listen(path)
        self.q, self.last, self.violations, self.maps, self.answers = list(SIT), None, 0, 0, 0
        self.chest, self.charge, self.status = 0.0, 0.8, [0] * 25
        self.accept()

    def accept(self):
        self.link, _ = self.listener.accept()
        self.link.settimeout(2.0)
        self.last = None

    def map(self):
        noise = random.Random(self.maps).gauss
        text = lambda value: bytes([0xA0 + len(value)]) + value.encode()
        entries = [array("RobotConfig", ["P0000000A00S00I00000", "6.0.0"] * 2, text)]
        values = {
            "Accelerometer": [noise(0, 0.02), noise(0, 0.02), -9.81 + noise(0, 0.02)], "Angles": [noise(0, 1e-3), noise(0, 1e-3)],
            "Battery": [self.charge, 0, -0.5, 30], "Current": [0.1] * 25, "FSR": [0.67 + noise(0, 0.01) for _ in range(8)],
            "Gyroscope": [noise(0, 2e-3) for _ in range(3)], "Position": self.q, "Sonar": [1, 1],
            "Stiffness": self.last[1] if self.last else [0] * 25, "Temperature": [38] * 25, "Touch": [self.chest] + [0] * 13}
        entries += [array(key, value, lambda number: b"\xca" + struct.pack(">f", number)) for key, value in values.items()]
        return b"\x8d" + b"".join(entries) + array("Status", self.status, lambda value: bytes([value]))

    def send(self, data):
        self.link.sendall(data)
        self.maps += 1

    def wrong(self, text):
        self.violations += 1
        print(f"violation in map {self.maps}: {text}")

    def read(self, count):
        data = b""
        while len(data) < count:
            more = self.link.recv(count - len(data))
            if not more:
                raise Closed
            data += more
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
        self.check(found.get("Position", self.q), found.get("Stiffness", self.last[1] if self.last else [0] * 25))

    def check(self, q, stiff):
        for j in range(25):
            if not math.radians(LOW[j]) - 0.02 <= q[j] <= math.radians(HIGH[j]) + 0.02:
                self.wrong(f"joint {j} at {q[j]}")
            if not (0 <= stiff[j] <= 1 or stiff[j] == -1):
                self.wrong(f"stiffness {stiff[j]} of joint {j}")
            if self.last and abs(q[j] - self.last[0][j]) > 1.5 * TOP[j] * 0.012 + 0.02:
                self.wrong(f"joint {j} jumps from {self.last[0][j]} to {q[j]}")
            if stiff[j] > 0 and not (self.last and self.last[1][j] > 0) and abs(q[j] - self.q[j]) > 0.2:
                self.wrong(f"joint {j} becomes stiff at {q[j]}, measured {self.q[j]}")
        yaw = min(abs(math.degrees(q[0])), 119.51)
        (a, low, high), (b, low2, high2) = next(pair for pair in zip(SHELL, SHELL[1:]) if pair[0][0] <= yaw < pair[1][0])
        share = (yaw - a) / (b - a)
        if not low + share * (low2 - low) - 1.7 <= math.degrees(q[1]) <= high + share * (high2 - high) + 1.7:
            self.wrong(f"the head hits its shell: {q[:2]}")
        if self.last and any(self.last[1][j] > 0 >= stiff[j] for j in LEGS) and hip_height(self.q) > 0.175:
            self.wrong(f"limp with the hips at {hip_height(self.q):.3f} m")
        self.q = [q[j] if stiff[j] > 0 else self.q[j] for j in range(25)]
        self.last = (q, stiff)


def broken(kind, data):
    return {"short": data[:500], "long": data + bytes(40), "malformed": data[:300] + b"\xc1" * 9 + data[309:],
            "missing": data.replace(b"Gyroscope", b"Gyroskope"),
            "nan": data[:(at := data.index(b"Gyroscope") + 11)] + b"\x7f\xc0\0\0" + data[at + 4:]}[kind]


def frame(link, number):
    pixels = bytearray(b"\x80") * 153600
    pixels[::2] = random.Random(number).randbytes(76800)  # grey noise: a camera without noise is broken
    for camera in (0, 1):
        link.sendall(struct.pack("<4sBBHHHIQII", b"FRM1", camera, 0, 0, 320, 240, number, 12000 * number, 153600, 0) + pixels)


def run(robot, args, frames):
    faults = sorted((int(float(at) / 0.012), kind) for kind, at in (fault.split("@") for fault in args.fault))
    released, begin = None, time.monotonic()
    while robot.maps * 0.012 < args.seconds:
        robot.chest = 0.0 if robot.maps == released else robot.chest
        if args.real_time:
            time.sleep(max(0.0, begin + robot.maps * 0.012 - time.monotonic()))
        if faults and faults[0][0] <= robot.maps:
            _, kind = faults.pop(0)
            print(f"map {robot.maps}: {kind}")
            if kind in ("chest", "press"):
                robot.chest, released = 1.0, robot.maps + (330 if kind == "chest" else 25)
            elif kind == "restart":
                robot.link.close()
                robot.q = list(SIT)
                robot.accept()
            elif kind == "stall":
                time.sleep(2.0)
                begin += 2.0
            elif kind in ("battery", "hot"):
                robot.charge, robot.status[10] = (0.03, 0) if kind == "battery" else (0.8, 3)
            else:
                robot.send(broken(kind, robot.map()))
                continue
        if frames and robot.maps % 3 == 0:
            frame(frames, robot.maps)
        robot.send(robot.map())
        robot.answer()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("socket")
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--real-time", action="store_true")
    parser.add_argument("--fault", action="append", default=[], metavar="KIND@SECOND")
    parser.add_argument("--frames", metavar="SOCKET")
    args = parser.parse_args()
    frames = listen(args.frames).accept()[0] if args.frames else None
    robot = Robot(args.socket)
    try:
        run(robot, args, frames)
    except TimeoutError:
        robot.wrong("no answer within 2 s")
    except (Closed, ConnectionError):
        print("the product has closed the socket")
    stiff = "stiff" if robot.last and any(robot.last[1][j] > 0 for j in LEGS) else "limp"
    print(f"{robot.maps} maps, {robot.answers} answers, hips at {hip_height(robot.q):.3f} m, {stiff}, "
          f"{robot.violations} violations")
    sys.exit(robot.violations > 0)


if __name__ == "__main__":
    main()
