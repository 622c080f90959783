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
from mcap.records import Message
from mcap.stream_reader import CRCValidationError

from bica.errors import BicaError

#: What the reader raises for damaged files: its own errors, and those of the decompressor.
READ_ERRORS = (McapError, CRCValidationError, RuntimeError)
#: Format of recordings that this package reads.
FORMAT = 7
#: Version of the format of a monitor's recordings.
MONITOR_FORMAT = 8


class RecordingError(BicaError):
    """A file is no recording, or is damaged."""


class RecordingFile:
    """An MCAP file with the metadata record `bica`; it is a bag of ROS 2."""

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
            what = f"`{self.path}` has format {self.header['format']}, this package reads {readable}"
            if self.header["format"] == readable - 1:
                what += f"\n  help: `player record upgrade {self.path} new.mcap` writes it in the present format"
            raise RecordingError(what)
        self._decoders: Any = None
        self.topics = {channel.topic: channel for channel in summary.channels.values()}

    def _json(self, record: dict[str, str]) -> Any:
        text = record["json"]
        if zlib.crc32(text.encode()) != int(record["crc32"], 16):
            raise self._damaged("the checksum of the header is wrong")
        return json.loads(text)

    def _damaged(self, why: object) -> RecordingError:
        what = f"`{self.path}` is cut, damaged or no MCAP file: {str(why) or 'it ends too early'}"
        return RecordingError(f"{what}\n  help: `player record recover {self.path} whole.mcap` may mend it")

    def schema(self, channel: str) -> Any:
        """Return the schema of an own channel, such as `tick`; None without the channel."""
        found = self.topics.get(f"/bica/{channel}")
        return found and json.loads(found.metadata["postcard_schema"])

    def contents(self, channel: str) -> Iterator[tuple[int, bytes]]:
        """Return times, ns, and contents of the messages of an own channel, in the order of their times."""
        for message in self._messages(f"/bica/{channel}"):
            length = int.from_bytes(message.data[4:8], "little")
            if message.data[:4] != b"\x00\x01\x00\x00" or length != len(message.data) - 8:
                raise self._damaged(f"a message of `/bica/{channel}` is no `bica_msgs/msg/Event`")
            yield message.log_time, message.data[8:]

    def standard(self, topic: str) -> Iterator[tuple[float, Any]]:
        """Return times and messages of a topic of ROS 2, by the definitions in the file."""
        from mcap_ros2.decoder import DecoderFactory

        self._decoders = self._decoders or DecoderFactory()
        with self.path.open("rb") as file:
            reader = make_reader(file, validate_crcs=True, decoder_factories=[self._decoders])
            try:
                for _, _, message, decoded in reader.iter_decoded_messages(topics=[topic]):
                    yield message.log_time * 1e-9, plain(decoded)
            except READ_ERRORS as error:
                raise self._damaged(error) from None

    def _messages(self, topic: str) -> Iterator[Message]:
        with self.path.open("rb") as file:
            try:
                for _, _, message in make_reader(file, validate_crcs=True).iter_messages(topics=[topic]):
                    yield message
            except READ_ERRORS as error:
                raise self._damaged(error) from None


def plain(message: Any) -> Any:
    """Return a decoded message of ROS 2 as a dictionary."""
    if hasattr(message, "__slots__"):
        return {name: plain(getattr(message, name)) for name in message.__slots__}
    return [plain(one) for one in message] if isinstance(message, list) else message
