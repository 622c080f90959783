"""Messages of standard topics: JSON, and Protocol Buffers by the descriptors in the file."""

from __future__ import annotations

import json
from functools import lru_cache
from typing import Any

from mcap.records import Channel, Message, Schema

from bica.recording.postcard import DecodeError


def decoded(schema: Schema | None, channel: Channel, message: Message) -> Any:
    """Return the content of a message."""
    if channel.message_encoding == "json":
        return json.loads(message.data)
    if channel.message_encoding == "protobuf" and schema is not None:
        from google.protobuf.json_format import MessageToDict

        content = _class(schema.name, schema.data).FromString(message.data)
        return MessageToDict(content, preserving_proto_field_name=True, always_print_fields_with_no_presence=True)
    raise DecodeError(f"`{channel.topic}` is encoded as {channel.message_encoding}")


@lru_cache(maxsize=64)
def _class(name: str, descriptors: bytes) -> Any:
    from google.protobuf.descriptor_pb2 import FileDescriptorSet
    from google.protobuf.descriptor_pool import DescriptorPool
    from google.protobuf.message_factory import GetMessageClass

    pool = DescriptorPool()
    for file in FileDescriptorSet.FromString(descriptors).file:
        pool.Add(file)
    return GetMessageClass(pool.FindMessageTypeByName(name))
