"""Images of a recording as arrays."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bica.recording.postcard import DecodeError

Bytes = NDArray[np.uint8]

#: Kinds of a coded plane, see docs/recordings.md.
STORED, CONSTANT, CODED = 0, 1, 2
#: Longest code of a byte, bits.
MAX_BITS = 12


@dataclass(frozen=True)
class Image:
    """Large data of a cycle."""

    #: Time since the start of the run's clock, s.
    time: float
    #: Number of the cycle; None in a recording of a monitor.
    cycle: int | None
    #: Name of the coordinate frame, as `top_camera`.
    frame: str
    #: Variant of the format: `Yuyv`, `Gray8`, `Rgb8`, `Jpeg`, `Points` or `Other`.
    format: str
    #: The data: of `Yuyv` height × width × 2 bytes, of `Gray8` height × width, of `Rgb8` height × width × 3; else its bytes.
    data: Bytes

    @property
    def rgb(self) -> Bytes:
        """Pixels as red, green and blue, height × width × 3 (BT.601, full range)."""
        match self.format:
            case "Rgb8":
                return self.data
            case "Gray8":
                return np.repeat(self.data[:, :, None], 3, axis=2)
            case "Yuyv":
                return _rgb_of_yuyv(self.data)
        raise DecodeError(f"data of the format `{self.format}` has no pixels")


def image_of(record: dict[str, Any], time: float) -> Image:
    """Return the large data of a message of the topic `blobs`."""
    variant = record["format"]
    name, size = (variant, {}) if isinstance(variant, str) else next(iter(variant.items()))
    stored = np.frombuffer(record["stored"], np.uint8)
    if record["coding"] == "Yuyv":
        data = decode_yuyv(record["stored"], size["width"], size["height"])
    elif "width" in size:
        depth = {"Yuyv": (2,), "Gray8": (), "Rgb8": (3,)}[name]
        data = stored.reshape(size["height"], size["width"], *depth)
    else:
        data = stored
    return Image(time, record["cycle"], record["frame"], name, data)


def decode_yuyv(coded: bytes, width: int, height: int) -> Bytes:
    """Decode an image of the coding `Yuyv` into height × width × 2 bytes."""
    image, at = np.empty((height, width * 2), np.uint8), 0
    try:
        for first, step, columns in ((0, 2, width), (1, 4, width // 2), (3, 4, width // 2)):
            differences, at = _plane(coded, at, columns * height)
            image[:, first::step] = _restored(differences.reshape(height, columns))
    except (IndexError, ValueError, struct.error) as error:
        raise DecodeError(f"an image is damaged: {error}") from None
    return image.reshape(height, width, 2)


def _plane(coded: bytes, at: int, count: int) -> tuple[Bytes, int]:
    """Return the differences of a plane, and the position after it."""
    kind, at = coded[at], at + 1
    if kind == STORED:
        return np.frombuffer(coded, np.uint8, count, at), at + count
    if kind == CONSTANT:
        return np.full(count, coded[at], np.uint8), at + 1
    if kind != CODED:
        raise ValueError(f"a plane of kind {kind}")
    table, at = np.frombuffer(coded, np.uint8, 128, at), at + 128
    lengths = np.column_stack((table & 15, table >> 4)).ravel()
    (size,) = struct.unpack_from("<I", coded, at)
    bits = np.frombuffer(coded, np.uint8, size, at + 4)
    return _huffman(bits, lengths, count), at + 4 + size


def _huffman(stored: Bytes, lengths: Bytes, count: int) -> Bytes:
    """Decode canonical codes: the symbol at each bit position first, then those positions at which a code begins."""
    symbols, widths = _table(lengths)
    padded = np.concatenate((stored, np.zeros(3, np.uint8))).astype(np.uint32)
    words = padded[:-3] << 16 | padded[1:-2] << 8 | padded[2:-1]
    shifts = np.arange(24 - MAX_BITS, 4, -1, dtype=np.uint32)
    windows = (words[:, None] >> shifts & ((1 << MAX_BITS) - 1)).ravel()
    following = (np.arange(len(windows)) + widths[windows]).tolist()
    starts, at = [], 0
    for _ in range(count):
        starts.append(at)
        at = following[at]
    decoded: Bytes = symbols[windows[starts]]
    return decoded


def _table(lengths: Bytes) -> tuple[Bytes, NDArray[np.int64]]:
    """Return the symbol of each window of MAX_BITS bits, and the length of its code."""
    symbols, widths = np.zeros(1 << MAX_BITS, np.uint8), np.ones(1 << MAX_BITS, np.int64)
    at = 0
    for length in range(1, MAX_BITS + 1):
        for symbol in np.flatnonzero(lengths == length):
            end = at + (1 << (MAX_BITS - length))
            symbols[at:end], widths[at:end] = symbol, length
            at = end
    return symbols, widths


def _restored(differences: Bytes) -> Bytes:
    """Add the predictions, one anti-diagonal after the other: its pixels depend on earlier ones only."""
    height, width = differences.shape
    plane = np.empty((height, width), np.int16)
    plane[0] = np.cumsum(differences[0], dtype=np.int64) & 255
    plane[:, 0] = np.cumsum(differences[:, 0], dtype=np.int64) & 255
    flat, rest = plane.ravel(), differences.ravel().astype(np.int16)
    for diagonal in range(2, height + width - 1):
        rows = np.arange(max(1, diagonal - width + 1), min(height, diagonal))
        at = rows * width + diagonal - rows
        left, up, corner = flat[at - 1], flat[at - width], flat[at - width - 1]
        predicted = np.clip(left + up - corner, np.minimum(left, up), np.maximum(left, up))
        flat[at] = (rest[at] + predicted) & 255
    return plane.astype(np.uint8)


def _rgb_of_yuyv(yuyv: Bytes) -> Bytes:
    luma = yuyv[:, :, 0].astype(np.float32)
    blue = np.repeat(yuyv[:, 0::2, 1], 2, axis=1).astype(np.float32) - 128
    red = np.repeat(yuyv[:, 1::2, 1], 2, axis=1).astype(np.float32) - 128
    rgb = np.stack((luma + 1.402 * red, luma - 0.344136 * blue - 0.714136 * red, luma + 1.772 * blue), axis=2)
    return np.clip(np.round(rgb), 0, 255).astype(np.uint8)
