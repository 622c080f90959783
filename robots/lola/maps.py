"""LoLA's maps by Python's `msgpack`, with random maps for tests.

    python3 robots/lola/maps.py random COUNT SEED    prints lines: kind, encoding with the keys in any order, values
    python3 robots/lola/maps.py check                reads such lines, and compares; prints their number

Values are `KEY=ELEMENT,ELEMENT` in the order of the keys' names; an element is the bits of a float32, a whole number, or a text.
"""

import random
import struct
import sys

import msgpack

SENSORS = {"Accelerometer": 3, "Angles": 2, "Battery": 4, "Current": 25, "FSR": 8, "Gyroscope": 3, "Position": 25, "Sonar": 2,
           "Stiffness": 25, "Temperature": 25, "Touch": 14}
ACTUATORS = {"Position": 25, "Stiffness": 25, "Chest": 3, "LEye": 24, "REye": 24}


def element(value):
    return struct.pack(">f", value).hex() if isinstance(value, float) else str(value)


def text(values):
    return " ".join(f"{key}={','.join(map(element, values[key]))}" for key in sorted(values))


def pack(values):
    return msgpack.packb(values, use_single_float=True)


def number(numbers):
    """A float32 of any size, and often one that has a shorter form in other encodings."""
    return numbers.choice([0.0, -0.0, 1.0, float(numbers.randrange(-300, 300)), numbers.gauss(0, 1) * 10.0 ** numbers.randrange(-30, 30)])


def random_map(kind, numbers):
    keys = list((SENSORS if kind == "sensors" else ACTUATORS).items())
    lit = lambda key: kind == "actuators" and key not in ("Position", "Stiffness")
    values = {key: [numbers.random() if lit(key) else number(numbers) for _ in range(length)] for key, length in keys}
    if kind == "sensors":
        letters = "".join(map(chr, range(48, 91)))
        values["RobotConfig"] = ["".join(numbers.choices(letters, k=numbers.randrange(1, 21))) for _ in range(4)]
        values["Status"] = [numbers.randrange(128) for _ in range(25)]
    order = list(values)
    numbers.shuffle(order)
    return {key: values[key] for key in order}


def main():
    if sys.argv[1] == "random":
        numbers = random.Random(int(sys.argv[3]))
        for _ in range(int(sys.argv[2])):
            kind = numbers.choice(["sensors", "actuators"])
            data = pack(random_map(kind, numbers))
            print(kind, data.hex(), text(msgpack.unpackb(data)), sep="\t")
        return 0
    lines = list(sys.stdin)
    for line in lines:
        kind, data, expected = line.rstrip("\n").split("\t")
        values = msgpack.unpackb(bytes.fromhex(data))
        if text(values) != expected or pack(values).hex() != data:
            print(f"{kind} differ: {text(values)}\n{expected}", file=sys.stderr)
            return 1
    print(len(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
