"""Requests to the coordinator, and their checks."""
from __future__ import annotations

import difflib
import numbers
import os
import uuid
from typing import Any, Dict, Mapping, Optional, Tuple

from google.protobuf.descriptor import FieldDescriptor

from ._errors import InvalidInput
from ._job_options import ROWS
from ._options import is_path, words_of
from ._types import Path
from .v1 import job_spec_pb2, jobs_pb2

# By the type of the option's field; all others are numbers.
_KINDS_OF_OPTIONS: Dict[int, Tuple[Any, str]] = {
    FieldDescriptor.CPPTYPE_BOOL: (bool, 'True or False'),
    FieldDescriptor.CPPTYPE_STRING: ((str, os.PathLike), 'text or a path')}
_WORDS_OF_PATHS = {row['name']: words_of(row) for row in ROWS if is_path(row)}
_WORDS_OF_NUMBERS = {row['name']: words_of(row) for row in ROWS if 'number' in row['expected']}


def create_request(scene: Path, out: Optional[Path], priority: int, request_id: Optional[str],
                   options: Mapping[str, Any]) -> Any:
    """A v1.CreateJobRequest."""
    spec = request_of(job_spec_pb2.JobSpec, scene=_absolute(scene), out='' if out is None else _absolute(out))
    for name, value in options.items():
        _set(spec, name, value)
    request = request_of(jobs_pb2.CreateJobRequest, priority=priority, request_id=request_id or str(uuid.uuid4()))
    request.spec.CopyFrom(spec)
    return request


def request_of(kind: Any, **fields: Any) -> Any:
    message = kind()
    for name, value in fields.items():
        _assign(message, name, value)
    return message


def _assign(message: Any, name: str, value: Any) -> None:
    """Sets a field. The error names it."""
    try:
        setattr(message, name, value)
    except TypeError as error:
        raise TypeError(f'{name}: {error}') from None
    except ValueError as error:  # and UnicodeEncodeError
        raise InvalidInput(f'{name}: {error}') from None


def _set(spec: Any, name: str, value: Any) -> None:
    """Sets an option. None leaves it out."""
    value = value.item() if type(value).__module__ == 'numpy' and hasattr(value, 'item') else value
    field = spec.DESCRIPTOR.fields_by_name.get(name)
    if field is None or name in ('scene', 'out'):
        near = difflib.get_close_matches(name, set(spec.DESCRIPTOR.fields_by_name) - {'scene', 'out'}, 1)
        hint = f'; did you mean {near[0]}?' if near else ''
        raise InvalidInput(f'{name}: there is no such option{hint}', 'INVALID_SPEC', {'field': name})
    if value is None or isinstance(value, str) and value in _WORDS_OF_NUMBERS.get(name, ()):
        return  # "auto" of a number: the program chooses it
    kind, expected = _KINDS_OF_OPTIONS.get(field.cpp_type, (numbers.Real, 'a number'))
    if not isinstance(value, kind) or isinstance(value, bool) != (kind is bool):
        raise TypeError(f'{name}: has type {type(value).__name__}; expected {expected}')
    _assign(spec, name, _absolute(value) if _is_file(name, value) else value)


def _is_file(name: str, value: Any) -> bool:
    """Whether an option's value is a path, and no word as "auto"."""
    if name not in _WORDS_OF_PATHS or not isinstance(value, str):
        return isinstance(value, os.PathLike)
    return value not in ('', *_WORDS_OF_PATHS[name])


def _absolute(path: Path) -> str:
    """A path of this process's folder as others see it; s3:// and the like stay."""
    text = os.fspath(path)
    if not isinstance(text, str):
        raise TypeError(f'path: has type {type(text).__name__}; expected text')
    if text.startswith('s3:/') and not text.startswith('s3://'):
        raise InvalidInput(f'{text}: a pathlib.Path has no s3://; give text')
    return text.rstrip('/') if '://' in text else os.path.abspath(text)
