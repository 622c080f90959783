"""Writes a recording again with the library of MCAP's authors, in every way that it knows.

Arguments: FILE FOLDER. Prints the names of the new files: `COMPRESSION-CHUNKS-CHECKSUMS.mcap`.
"""

import itertools
import os
import sys

from mcap.records import Channel, Message, Metadata, Schema
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, Writer


def rewrite(source, target, **options):
    writer = Writer(target, **options)
    writer.start("ros2")
    schemas, channels = {}, {}
    for record in StreamReader(source).records:
        if isinstance(record, Schema) and record.id not in schemas:
            schemas[record.id] = writer.register_schema(record.name, record.encoding, record.data)
        elif isinstance(record, Channel) and record.id not in channels:
            channels[record.id] = writer.register_channel(
                record.topic, record.message_encoding, schemas[record.schema_id], record.metadata
            )
        elif isinstance(record, Message):
            channel = channels[record.channel_id]
            writer.add_message(channel, record.log_time, record.data, record.publish_time, record.sequence)
        elif isinstance(record, Metadata):
            writer.add_metadata(record.name, record.metadata)
    writer.finish()


def main(path, folder):
    kinds = itertools.product(CompressionType, (True, False), (True, False))
    for compression, chunks, checksums in kinds:
        words = [compression.name.lower(), "chunks" if chunks else "plain", "crc" if checksums else "none"]
        name = os.path.join(folder, "-".join(words) + ".mcap")
        with open(path, "rb") as source, open(name, "wb") as target:
            rewrite(
                source,
                target,
                compression=compression,
                use_chunking=chunks,
                enable_crcs=checksums,
                enable_data_crcs=checksums,
            )
        print(name)


main(*sys.argv[1:])
