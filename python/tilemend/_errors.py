"""Exceptions. Each has the text for people and a reason for programs."""
from __future__ import annotations

import re
from typing import TYPE_CHECKING, Dict, Optional, Type

from . import _tilemend
from ._job_options import ROWS
from ._options import SWITCH

if TYPE_CHECKING:
    from ._jobs import Job


class Error(Exception):
    """What tilemend could not do.

    Attributes:
        reason: a word that never changes, as "INVALID_SPEC" or "OUTPUT_EXISTS"; that of the class where there is no
            closer one.
        metadata: facts for programs, by name ("field", "job").
    """

    _REASON = 'OTHER'  # of errors without a closer one

    def __init__(self, message: str, reason: str = '', metadata: Optional[Dict[str, str]] = None) -> None:
        super().__init__(message)
        self.reason = reason or self._REASON
        self.metadata = dict(metadata or {})


class InvalidInput(Error, ValueError):
    """An array, an option or a file is not what it should be; the text says where and what was expected."""

    _REASON = 'INVALID_INPUT'


class NotFound(Error, LookupError):
    """There is no such file, scene or job."""

    _REASON = 'NOT_FOUND'


class NotAllowed(Error, PermissionError):
    """Who calls may not do that, or is not known; or a file may not be read."""

    _REASON = 'NOT_ALLOWED'


class Conflict(Error):
    """Not now, or not as it is: the job is over, the output exists, another job writes there."""

    _REASON = 'CONFLICT'


class AlreadyExists(Conflict, FileExistsError):
    """The output or the file is there already, and may not be replaced."""

    _REASON = 'ALREADY_EXISTS'


class TooMuch(Error):
    """More than there is room for: jobs, calls, memory. Try again later."""

    _REASON = 'TOO_MUCH'


class Unavailable(Error, ConnectionError):
    """The coordinator cannot be reached."""

    _REASON = 'UNAVAILABLE'


class TimedOut(Error, TimeoutError):
    """The job is not over after the time that `wait` had. It goes on."""

    _REASON = 'TIMED_OUT'


class Cancelled(Error):
    """The work was cancelled."""

    _REASON = 'CANCELLED'


class JobFailed(Error):
    """A job ended without an output.

    Attributes:
        job: the job as it ended (tilemend.Job).
    """

    _REASON = 'JOB_FAILED'

    job: 'Job'


# By google.rpc.Code, which absl::StatusCode and grpc.StatusCode share.
_BY_CODE: Dict[int, Type[Error]] = {
    1: Cancelled, 3: InvalidInput, 5: NotFound, 6: AlreadyExists, 7: NotAllowed, 8: TooMuch, 9: Conflict, 10: Conflict,
    11: InvalidInput, 14: Unavailable, 16: NotAllowed}
# Names of options. Of a job, then of one mesh.
_ALL = [*ROWS, *_tilemend.options()]
_SWITCHES = {row['name'] for row in _ALL if row['expected'] == SWITCH}
_OTHERS = {row['name'] for row in _ALL} - _SWITCHES
# Flags in texts of the programs. What is within a command stays.
_CALLS = {'tilemend list': 'Client.jobs()', 'tilemend workers': 'Client.workers()', 'tilemend resume': 'Client.resume()'}
_FLAG = re.compile(r'(?P<command>tilemend [a-z]+(?: --?[a-z-]+(?: [A-Z]+\b)?)*)|(?<![^\s(`])--(?P<name>[a-z][a-z-]*)'
                   r'(?: (?P<value>[A-Z]+)\b)?')


def from_status(code: int, message: str, reason: str, metadata: Optional[Dict[str, str]] = None) -> Error:
    """The exception for a status of the program."""
    return _BY_CODE.get(code, Error)(with_keywords(message), reason, metadata)


def with_keywords(text: str) -> str:
    """A text of the programs with options as keywords, in place of flags."""
    return _FLAG.sub(_keyword, text)


def _keyword(flag: 're.Match[str]') -> str:
    """overwrite=True of --overwrite, decisions=FILE of --decisions FILE, out of --out; other flags stay."""
    name = (flag['name'] or '').replace('-', '_')
    if flag['command'] or name not in {'out', *_SWITCHES, *_OTHERS}:
        return _CALLS.get(flag[0], flag[0])
    if name in _SWITCHES:
        return f'{name}=True' + (f' {flag["value"]}' if flag['value'] else '')
    return f'{name}={flag["value"]}' if flag['value'] else name
