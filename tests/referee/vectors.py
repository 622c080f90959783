"""Random control packets and status messages with their fields, one a line: kind, bytes in hexadecimal, fields.

The encoding is that of `struct`, from the description of the formats, without any code of this repository.
Run: python3 vectors.py COUNT SEED
"""

import random
import struct
import sys


def team(version, random):
    head = [random.randrange(256) for _ in range(6)] + [random.randrange(65536) for _ in range(2)]
    fields, data = list(head), struct.pack("<6B2H", *head)
    for _ in range(20):
        # Numbers beyond the defined penalties occur, too.
        penalty, seconds, warnings, cautions = random.randrange(16), *(random.randrange(256) for _ in range(3))
        if version == 19:
            fields += [penalty, seconds, warnings, cautions]
            data += struct.pack("<4B", penalty, seconds, warnings, cautions)
        else:
            fields += [penalty, seconds, 0, cautions]
            data += struct.pack("<3B", penalty, seconds, cautions)
    return fields, data


def control(random):
    version = random.choice([19, 20])
    number, players, competition = (random.randrange(256) for _ in range(3))
    stopped, first_half = random.randrange(2), random.randrange(2)
    phase, state, set_play = random.randrange(4), random.randrange(5), random.randrange(7)
    kicking = random.randrange(256)
    times = [random.randrange(-32768, 32768) for _ in range(2)]
    fields = [version, number, players, competition, stopped, phase, state, set_play, first_half, kicking, *times]
    data = struct.pack("<4s10B2h", b"RGme", *fields)
    for _ in range(2):
        more, encoded = team(version, random)
        fields, data = fields + more, data + encoded
    assert len(data) == {19: 198, 20: 158}[version]
    return "control", data, fields


def single(value):
    """The nearest number of single precision."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


def status(random):
    player, team, fallen, seen = random.randint(1, 20), random.randrange(256), random.randrange(2), random.randrange(2)
    x, y, heading, age, forward, left = (single(random.uniform(-9, 9)) for _ in range(6))
    age = abs(age)
    ball = [age, forward * 1000, left * 1000] if seen else [-1, 0, 0]
    data = struct.pack("<4s4B6f", b"RGrt", 4, player, team, fallen, x * 1000, y * 1000, heading, *ball)
    assert len(data) == 32
    return "status", data, [player, team, fallen, seen, x, y, heading, age, forward, left]


def main():
    count, seed = int(sys.argv[1]), int(sys.argv[2])
    generator = random.Random(seed)
    for make in (control, status):
        for _ in range(count):
            kind, data, fields = make(generator)
            print(kind, data.hex(), *(repr(field) for field in fields))


main()
