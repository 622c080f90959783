"""The messages of a Booster's topics as types of cyclonedds, with random messages for tests.

    python3 robots/booster/messages.py random COUNT SEED    prints lines: type, JSON, encoding
    python3 robots/booster/messages.py check                reads such lines, and compares
"""

import json
import random
import struct
import sys
from dataclasses import dataclass, fields

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, float32, sequence, uint8, uint32

FLOATS3 = array[float32, 3]


@dataclass
class ImuState(IdlStruct, typename="booster_interface::msg::dds_::ImuState_"):
    rpy: FLOATS3
    gyro: FLOATS3
    acc: FLOATS3


@dataclass
class MotorState(IdlStruct, typename="booster_interface::msg::dds_::MotorState_"):
    mode: uint8
    q: float32
    dq: float32
    ddq: float32
    tau_est: float32
    temperature: uint8
    lost: uint32
    reserve: array[uint32, 2]


@dataclass
class LowState(IdlStruct, typename="booster_interface::msg::dds_::LowState_"):
    imu_state: ImuState
    motor_state_parallel: sequence[MotorState]
    motor_state_serial: sequence[MotorState]


@dataclass
class MotorCmd(IdlStruct, typename="booster_interface::msg::dds_::MotorCmd_"):
    mode: uint8
    q: float32
    dq: float32
    tau: float32
    kp: float32
    kd: float32
    weight: float32


@dataclass
class LowCmd(IdlStruct, typename="booster_interface::msg::dds_::LowCmd_"):
    cmd_type: uint32  # an enumeration of 8 bits with padding, which must be zero
    motor_cmd: sequence[MotorCmd]


@dataclass
class Odometer(IdlStruct, typename="booster_interface::msg::dds_::Odometer_"):
    x: float32
    y: float32
    theta: float32


@dataclass
class FallDownState(IdlStruct, typename="booster_interface::msg::dds_::FallDownState_"):
    fall_down_state: uint32
    is_recovery_available: bool


@dataclass
class RpcReqMsg(IdlStruct, typename="booster_msgs::msg::dds_::RpcReqMsg_"):
    uuid: str
    header: str
    body: str


@dataclass
class RpcRespMsg(IdlStruct, typename="booster_msgs::msg::dds_::RpcRespMsg_"):
    uuid: str
    header: str
    body: str


TYPES = {kind.__name__: kind for kind in (LowState, LowCmd, Odometer, FallDownState, RpcReqMsg, RpcRespMsg)}
LISTS = {"motor_state_parallel": MotorState, "motor_state_serial": MotorState, "motor_cmd": MotorCmd, "imu_state": ImuState}


def single(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def random_message(kind, numbers):
    values = {}
    for field in fields(kind):
        name = field.name
        if name == "imu_state":
            values[name] = random_message(ImuState, numbers)
        elif name in LISTS:
            values[name] = [random_message(LISTS[name], numbers) for _ in range(numbers.choice([0, 1, 22, 23, 23, 24]))]
        elif name in ("rpy", "gyro", "acc"):
            values[name] = [single(numbers.gauss(0, 5)) for _ in range(3)]
        elif name == "reserve":
            values[name] = [numbers.getrandbits(32) for _ in range(2)]
        elif name in ("mode", "temperature", "lost", "cmd_type", "fall_down_state"):
            values[name] = numbers.getrandbits(8 if name in ("mode", "temperature") else 32)
        elif name == "is_recovery_available":
            values[name] = bool(numbers.getrandbits(1))
        elif kind in (RpcReqMsg, RpcRespMsg):
            values[name] = "".join(numbers.choice('abc{}":ü0 \\') for _ in range(numbers.randrange(40)))
        else:
            values[name] = single(numbers.gauss(0, 10) * 10 ** numbers.randrange(-9, 9))
    return kind(**values)


def plain(message):
    if isinstance(message, IdlStruct):
        return {field.name: plain(getattr(message, field.name)) for field in fields(message)}
    return [plain(item) for item in message] if isinstance(message, (list, tuple)) else message


def rounded(value):
    if isinstance(value, dict):
        return {name: rounded(item) for name, item in value.items()}
    if isinstance(value, list):
        return [rounded(item) for item in value]
    return single(value) if isinstance(value, float) else value


def encode(message):
    """The first version of the encoding, little-endian, without the header of four bytes."""
    data = message.serialize(endianness=None, use_version_2=False)
    assert data[:2] == b"\x00\x01", data[:4]
    return data[4:]


def decode(kind, data):
    return kind.deserialize(b"\x00\x01\x00\x00" + data)


def main():
    if sys.argv[1] == "random":
        numbers = random.Random(int(sys.argv[3]))
        for _ in range(int(sys.argv[2])):
            message = random_message(TYPES[numbers.choice(list(TYPES))], numbers)
            print(type(message).__name__, encode(message).hex(), json.dumps(plain(message)), sep="\t")
        return 0
    lines = list(sys.stdin)
    for line in lines:
        name, data, text = line.rstrip("\n").split("\t")
        message, expected = decode(TYPES[name], bytes.fromhex(data)), rounded(json.loads(text))
        if plain(message) != expected or encode(message).hex() != data:
            print(f"{name} differs: {plain(message)}\n{expected}", file=sys.stderr)
            return 1
    print(len(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
