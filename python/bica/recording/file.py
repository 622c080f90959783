"""The MCAP file of a recording: its header, ending and messages."""

from __future__ import annotations

import json
import os
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mcap.exceptions import McapError
from mcap.reader import make_reader
from mcap.records import Channel, Message, Schema
from mcap.stream_reader import CRCValidationError

from bica.errors import BicaError

#: What the reader raises for damaged files: its own errors, and those of the decompressor.
READ_ERRORS = (McapError, CRCValidationError, RuntimeError)
#: Format of recordings that this package reads.
FORMAT = 6
#: Version of the format of a monitor's recordings.
MONITOR_FORMAT = 7


class RecordingError(BicaError):
    """A file is no recording, or is damaged."""


class RecordingFile:
    """An MCAP file with the profile `bica`."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Read the header; raises RecordingError if the file is no complete recording."""
        self.path = Path(path)
        try:
            with self.path.open("rb") as file:
                reader = make_reader(file, validate_crcs=True)
                summary = reader.get_summary()
                records = {record.name: record.metadata for record in reader.iter_metadata()}
        except READ_ERRORS as error:
            raise self._damaged(error) from None
        if summary is None or "bica" not in records:
            raise RecordingError(f"`{self.path}` is no recording of a robot's program")
        self.header: dict[str, Any] = self._json(records["bica"])
        self.ending: dict[str, Any] = self._json(records["bica.ending"]) if "bica.ending" in records else {}
        readable = MONITOR_FORMAT if "monitor" in self.header else FORMAT
        if self.header["format"] != readable:
            raise RecordingError(f"`{self.path}` has format {self.header['format']}, this package reads {readable}")
        self.schemas = summary.schemas
        self._decoders: Any = None
        self.topics = {channel.topic: channel for channel in summary.channels.values()}

    def _json(self, record: dict[str, str]) -> Any:
        text = record["json"]
        if zlib.crc32(text.encode()) != int(record["crc32"], 16):
            raise self._damaged("the checksum of the header is wrong")
        return json.loads(text)

    def _damaged(self, why: object) -> RecordingError:
        what = f"`{self.path}` is cut, damaged or no MCAP file: {why}"
        return RecordingError(f"{what}\n  help: `player record recover {self.path} whole.mcap` may mend it")

    def messages(self, topic: str) -> Iterator[tuple[Schema | None, Channel, Message]]:
        """Return the messages of a topic in the order of their times."""
        with self.path.open("rb") as file:
            try:
                yield from make_reader(file, validate_crcs=True).iter_messages(topics=[topic])
            except READ_ERRORS as error:
                raise self._damaged(error) from None

    def standard(self, topic: str) -> Iterator[tuple[float, Any]]:
        """Return times and contents of a standard topic: JSON, or Protocol Buffers by the descriptors in the file."""
        for schema, channel, message in self.messages(topic):
            is_json = channel.message_encoding == "json"
            yield message.log_time * 1e-9, json.loads(message.data) if is_json else self._protobuf(schema, channel, message)

    def _protobuf(self, schema: Schema | None, channel: Channel, message: Message) -> Any:
        from google.protobuf.json_format import MessageToDict
        from mcap_protobuf.decoder import DecoderFactory

        self._decoders = self._decoders or DecoderFactory()
        decode = self._decoders.decoder_for(channel.message_encoding, schema)
        if decode is None:
            raise RecordingError(f"`{channel.topic}` is encoded as {channel.message_encoding}")
        return MessageToDict(decode(message.data), preserving_proto_field_name=True, always_print_fields_with_no_presence=True)
