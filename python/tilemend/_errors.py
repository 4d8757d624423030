"""Exceptions. Each has the text for people and, where there is one, a reason for programs."""
from __future__ import annotations

from typing import TYPE_CHECKING, Dict, Optional, Type

if TYPE_CHECKING:
    from ._jobs import Job


class Error(Exception):
    """What tilemend could not do.

    Attributes:
        reason: a word that never changes, as "INVALID_SPEC" or "OUTPUT_EXISTS"; "" if there is none.
        metadata: facts for programs, by name ("field", "job").
    """

    def __init__(self, message: str, reason: str = '', metadata: Optional[Dict[str, str]] = None) -> None:
        super().__init__(message)
        self.reason = reason
        self.metadata = dict(metadata or {})


class InvalidInput(Error, ValueError):
    """An array, an option or a file is not what it should be; the text says where and what was expected."""


class NotFound(Error, LookupError):
    """There is no such file, scene or job."""


class NotAllowed(Error, PermissionError):
    """Who calls may not do that, or is not known; or a file may not be read."""


class Conflict(Error):
    """Not now, or not as it is: the job is over, the output exists, another job writes there."""


class TooMuch(Error):
    """More than there is room for: jobs, calls, memory. Try again later."""


class Unavailable(Error, ConnectionError):
    """The coordinator cannot be reached."""


class Cancelled(Error):
    """The work was cancelled."""


class JobFailed(Error):
    """A job ended without an output.

    Attributes:
        job: the job as it ended (tilemend.Job).
    """

    job: 'Job'


# By google.rpc.Code, which absl::StatusCode and grpc.StatusCode share.
_BY_CODE: Dict[int, Type[Error]] = {
    1: Cancelled, 3: InvalidInput, 5: NotFound, 6: Conflict, 7: NotAllowed, 8: TooMuch, 9: Conflict, 10: Conflict,
    11: InvalidInput, 14: Unavailable, 16: NotAllowed}


def from_status(code: int, message: str, reason: str, metadata: Optional[Dict[str, str]] = None) -> Error:
    """The exception for a status of the program."""
    return _BY_CODE.get(code, Error)(message, reason, metadata)
