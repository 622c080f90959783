"""Reads MCAP files with the library of MCAP's authors and checks all checksums.

Arguments: FILE TOPIC... Fails if a file is not valid, or has no messages of a topic.
"""

import sys

from mcap.reader import make_reader


def read(path, topics):
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        counts = {}
        for _, channel, _ in reader.iter_messages():
            counts[channel.topic] = counts.get(channel.topic, 0) + 1
    declared = summary.statistics.channel_message_counts
    for number, channel in summary.channels.items():
        if declared.get(number, 0) != counts.get(channel.topic, 0):
            sys.exit(f"{path}: {channel.topic}: {declared.get(number, 0)} messages declared, {counts} found")
    missing = [topic for topic in topics if topic not in counts]
    if missing:
        sys.exit(f"{path}: no messages of {missing}, but of {sorted(counts)}")
    print(f"{path}: {sum(counts.values())} messages, {len(counts)} topics, all checksums are right")


read(sys.argv[1], sys.argv[2:])
