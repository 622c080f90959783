"""Recordings as pandas frames and numpy arrays."""

from bica.recording.file import RecordingError
from bica.recording.image import Image
from bica.recording.postcard import DecodeError
from bica.recording.recording import Recording

__all__ = ["DecodeError", "Image", "Recording", "RecordingError"]
