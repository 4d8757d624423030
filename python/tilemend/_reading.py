"""Files of an output, as they are read."""
from __future__ import annotations

import contextlib
import json
import numbers
import os
import stat
from typing import Any, Iterator

from ._errors import InvalidInput, NotAllowed


def json_of(path: str) -> Any:
    """What a JSON file holds.

    Raises:
        FileNotFoundError, which the caller explains; NotAllowed; InvalidInput.
    """
    try:
        return json.loads(_text_of(path))
    except (FileNotFoundError, InvalidInput):
        raise
    except PermissionError:
        raise NotAllowed(f'{path}: may not be read by this user') from None
    except OSError as error:
        raise InvalidInput(f'{path}: cannot be read: {error.strerror}') from None
    except (UnicodeDecodeError, json.JSONDecodeError, RecursionError) as error:
        raise InvalidInput(f'{path}: is not JSON: {error}') from None
    except ValueError as error:  # a number of very many digits
        raise InvalidInput(f'{path}: cannot be read: {error}') from None


@contextlib.contextmanager
def of_file(path: str) -> Iterator[None]:
    """Around work with what `path` holds: that it has another form than tilemend writes is InvalidInput."""
    try:
        yield
    except InvalidInput:
        raise
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise InvalidInput(f'{path}: is not as tilemend writes it: {error!r}') from error


def is_number(value: Any) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


def _text_of(path: str) -> str:
    """Of a regular file. A pipe would have the reader wait, and a device may have no end."""
    descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    with open(descriptor, encoding='utf-8') as file:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise InvalidInput(f'{path}: is no regular file')
        return file.read()
