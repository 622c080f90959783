"""Recordings as pandas frames and numpy arrays."""
