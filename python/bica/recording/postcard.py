"""Postcard's encoding, by the schema of a message.

An enumeration becomes the name of its variant, or a dictionary from that name to its content; a structure becomes a dictionary.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from typing import Any

from bica.errors import BicaError

#: Length from which on texts and bytes are not in a message of sensor values, but large data of its own.
MIN_BLOB = 128

#: Returns a value that begins at a position of the bytes, and the position after it.
Decoder = Callable[[bytes, int], tuple[Any, int]]


class DecodeError(BicaError):
    """Bytes or a schema are not as expected."""


def decoder(schema: Mapping[str, Any], large_apart: bool = False) -> Callable[[bytes], Any]:
    """Return a function that decodes a whole message; with `large_apart` large data is its number of bytes."""
    decode = _compile(schema["ty"], large_apart)

    def whole(data: bytes) -> Any:
        try:
            value, end = decode(data, 0)
        except (IndexError, struct.error, UnicodeDecodeError) as error:
            raise DecodeError(f"a message is no `{schema['name']}`: {error}") from None
        if end != len(data):
            raise DecodeError(f"a message is no `{schema['name']}`: {len(data) - end} bytes remain")
        return value

    return whole


def _varint(data: bytes, at: int) -> tuple[int, int]:
    value, shift = data[at] & 0x7F, 7
    while data[at] >= 0x80:
        at += 1
        value |= (data[at] & 0x7F) << shift
        shift += 7
    return value, at + 1


def _signed(data: bytes, at: int) -> tuple[int, int]:
    value, at = _varint(data, at)
    return (value >> 1) ^ -(value & 1), at


def _bytes(data: bytes, at: int) -> tuple[bytes, int]:
    length, at = _varint(data, at)
    if at + length > len(data):
        raise IndexError("too few bytes")
    return data[at : at + length], at + length


def _text(data: bytes, at: int) -> tuple[str, int]:
    taken, at = _bytes(data, at)
    return taken.decode(), at


def _packed(form: str) -> Decoder:
    unpack, size = struct.Struct(f"<{form}").unpack_from, struct.calcsize(f"<{form}")
    return lambda data, at: (unpack(data, at)[0], at + size)


_PLAIN: dict[str, Decoder] = {
    **{name: _packed(form) for name, form in (("Bool", "?"), ("U8", "B"), ("I8", "b"), ("F32", "f"), ("F64", "d"))},
    **dict.fromkeys(("U16", "U32", "U64", "U128", "Usize"), _varint),
    **dict.fromkeys(("I16", "I32", "I64", "I128", "Isize"), _signed),
    **dict.fromkeys(("Unit", "UnitStruct", "UnitVariant"), lambda data, at: (None, at)),
    **dict.fromkeys(("Char", "String"), _text),
    "ByteArray": _bytes,
}


def _compile(ty: Any, apart: bool) -> Decoder:
    if isinstance(ty, str):
        if ty not in _PLAIN:
            raise DecodeError(f"the type `{ty}` is unknown")
        return _apart(_PLAIN[ty]) if apart and ty in ("String", "ByteArray") else _PLAIN[ty]
    ((kind, inner),) = ty.items()
    match kind:
        case "Struct" | "StructVariant":
            return _struct([field["name"] for field in inner], [_compile(field["ty"]["ty"], apart) for field in inner])
        case "Tuple" | "TupleStruct" | "TupleVariant":
            return _tuple([_compile(part["ty"], apart) for part in inner])
        case "NewtypeStruct" | "NewtypeVariant":
            return _compile(inner["ty"], apart)
        case "Option":
            part = _compile(inner["ty"], apart)
            return lambda data, at: part(data, at + 1) if data[at] else (None, at + 1)
        case "Seq":
            return _bytes if inner["ty"] == "U8" else _sequence(_compile(inner["ty"], apart))
        case "Map":
            return _sequence(_tuple([_compile(inner[part]["ty"], apart) for part in ("key", "val")]), dict)
        case "Enum":
            return _enum([(variant["name"], _compile(variant["ty"], apart), variant["ty"] == "UnitVariant") for variant in inner])
    raise DecodeError(f"the type `{kind}` is unknown")


def _apart(plain: Decoder) -> Decoder:
    def decode(data: bytes, at: int) -> tuple[Any, int]:
        length, after = _varint(data, at)
        return (length, after) if length >= MIN_BLOB else plain(data, at)

    return decode


def _struct(names: list[str], parts: list[Decoder]) -> Decoder:
    if parts and all(part is _PLAIN["F32"] for part in parts):
        floats = struct.Struct(f"<{len(parts)}f")
        return lambda data, at: (dict(zip(names, floats.unpack_from(data, at), strict=True)), at + floats.size)
    pairs = list(zip(names, parts, strict=True))

    def decode(data: bytes, at: int) -> tuple[Any, int]:
        value = {}
        for name, part in pairs:
            value[name], at = part(data, at)
        return value, at

    return decode


def _tuple(parts: list[Decoder]) -> Decoder:
    def decode(data: bytes, at: int) -> tuple[Any, int]:
        values = []
        for part in parts:
            value, at = part(data, at)
            values.append(value)
        return tuple(values), at

    return decode


def _sequence(part: Decoder, whole: Callable[[list[Any]], Any] = list) -> Decoder:
    def decode(data: bytes, at: int) -> tuple[Any, int]:
        count, at = _varint(data, at)
        values = []
        for _ in range(count):
            value, at = part(data, at)
            values.append(value)
        return whole(values), at

    return decode


def _enum(variants: list[tuple[str, Decoder, bool]]) -> Decoder:
    def decode(data: bytes, at: int) -> tuple[Any, int]:
        number, at = _varint(data, at)
        name, part, is_unit = variants[number]
        value, at = part(data, at)
        return name if is_unit else {name: value}, at

    return decode
