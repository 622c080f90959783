"""The error that all errors of the package are."""


class BicaError(Exception):
    """Something that a user can mend; the message says how."""
