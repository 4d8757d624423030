"""Filling of one mesh in this process."""
from __future__ import annotations

import ctypes
import json
import mmap
import os
from typing import Any, Dict, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _tilemend
from ._errors import InvalidInput
from ._filled import Filled
from ._options import SWITCH, documented
from ._types import FillProgress, Rows

_MOST_ROWS = 2**31 - 1
_SHAPES = {'vertices': '(n, 3)', 'faces': '(m, 3)'}


def options() -> List[Dict[str, str]]:
    """The options of `fill`: `name`, `expected`, `default`, `unit`, `help`."""
    return [dict(row) for row in _tilemend.options()]


@documented(options())
def fill(vertices: Rows, faces: Rows, *, progress: Optional[FillProgress] = None, **options: Any) -> Filled:
    """Fills the holes of a triangle mesh. The result is that of `tilemend fill`, bit for bit.

    Args:
        vertices: (n, 3) float32 or float64, finite, at most 1e9 in size. Metres for terrain, else any unit. Integers
            and other sequences become float64. Arrays in C order are read where they lie, and are read-only meanwhile.
            Mapped files are copied.
        faces: (m, 3) integers, indices of vertices, counter-clockwise seen from outside. As `vertices`: those of 32 and
            64 bits are not copied.
        progress: called as progress(step, holes_done, holes) in this thread, at most 20 times a second. An exception
            that it raises ends the work.
        **options: as the flags of `tilemend fill`, with _ for -. True turns a switch on; None and False leave an
            option out.

            OPTIONS

    Returns:
        A new mesh; the arrays that came in are not changed. Holes that cannot be filled are in `Filled.left`.

    Raises:
        TypeError: an array has another dtype, or an option another type.
        InvalidInput (a ValueError): a shape, a coordinate, an index or an option is wrong; the text says where.
        NotFound: a file of `water` or `clear` is missing.
        KeyboardInterrupt: Ctrl-C, soon after it was pressed. Other threads of Python run meanwhile.
        SystemExit: the interpreter ends while another thread is here. It ends that thread without a message.
    """
    if progress is not None and not callable(progress):
        raise TypeError(f'progress: has type {type(progress).__name__}; expected a function')
    points, triangles = _vertices(vertices), _faces(faces)
    new_vertices, new_faces, originals, report = _tilemend.fill(points, triangles, _texts(options), progress)
    is_new = np.zeros(len(new_faces), bool)
    is_new[originals:] = True
    return Filled(new_vertices, new_faces, is_new, json.loads(report))


def _vertices(given: ArrayLike) -> NDArray[Any]:
    if not isinstance(given, np.ndarray):
        given = _array('vertices', given, np.float64)
    _check_rows('vertices', given)
    if given.dtype.kind in 'iu':
        return _packed(given, np.dtype(np.float64))
    if given.dtype.kind != 'f' or given.dtype.itemsize not in (4, 8):
        raise TypeError(f'vertices: has dtype {given.dtype}; expected float32, float64 or integers')
    return _packed(given, given.dtype.newbyteorder('='))


def _faces(given: ArrayLike) -> NDArray[Any]:
    if not isinstance(given, np.ndarray):
        given = _array('faces', given, None)
        if given.size == 0:
            given = np.zeros((0, 3), np.int64)
    _check_rows('faces', given)
    if given.dtype.kind not in 'iu':
        raise TypeError(f'faces: has dtype {given.dtype}; expected integers, as int32 or int64')
    return _packed(given, np.dtype(np.int64) if given.dtype.itemsize < 4 else given.dtype.newbyteorder('='))


def _packed(given: NDArray[Any], dtype: np.dtype[Any]) -> NDArray[Any]:
    """The array itself, if it can be read where it lies."""
    if given.dtype == dtype and given.flags.c_contiguous and given.flags.aligned:
        return np.array(given) if _is_mapped(given) else given
    return np.require(given, dtype, ('C', 'ALIGNED'))


def _is_mapped(array: NDArray[Any]) -> bool:
    """Whether the memory is that of a mapped file, or is shared with other processes, which could write to it."""
    base: Any = array
    while isinstance(base, (np.ndarray, memoryview)):
        base = base.base if isinstance(base, np.ndarray) else base.obj
    return isinstance(base, (mmap.mmap, ctypes.Array))


def _array(name: str, given: ArrayLike, dtype: Any) -> NDArray[Any]:
    try:
        array = np.asarray(given, dtype)
    except (TypeError, ValueError, OverflowError) as error:
        raise TypeError(f'{name}: cannot be made an array of shape {_SHAPES[name]}: {error}') from None
    if array.ndim == 0:
        raise TypeError(f'{name}: has type {type(given).__name__}; expected an array of shape {_SHAPES[name]}')
    return array


def _check_rows(name: str, array: NDArray[Any]) -> None:
    """Before anything is converted."""
    if array.ndim != 2 or array.shape[1] != 3:
        raise InvalidInput(f'{name}: has shape {array.shape}; expected {_SHAPES[name]}')
    if len(array) > _MOST_ROWS:
        raise InvalidInput(f'{name}: {len(array)} rows; expected at most {_MOST_ROWS}')
    if np.ma.is_masked(array):
        raise InvalidInput(f'{name}: has masked values; leave these rows out')


def _texts(given: Dict[str, Any]) -> Dict[str, str]:
    """The options as on the command line."""
    expected = {row['name']: row['expected'] for row in _tilemend.options()}
    texts = {}
    for name, value in given.items():
        value = value.item() if isinstance(value, np.generic) else value
        is_switch = expected.get(name) == SWITCH
        if value is None or value is False:
            continue
        if isinstance(value, bool) != is_switch and name in expected and not isinstance(value, str):
            wanted = 'True or False' if is_switch else expected[name]
            raise TypeError(f'{name}: has type {type(value).__name__}; expected {wanted}')
        if value is True:
            texts[name] = 'true'
        elif isinstance(value, int):
            texts[name] = repr(int(value))
        elif isinstance(value, float):
            texts[name] = repr(float(value))
        elif isinstance(value, (str, os.PathLike)):
            texts[name] = os.fsdecode(value)
        else:
            raise TypeError(f'{name}: has type {type(value).__name__}; expected a number, text, a path, True or False')
        if not texts[name].isascii() and texts[name] != texts[name].encode(errors='replace').decode():
            raise InvalidInput(f'{name}: {texts[name]!r} is no valid Unicode')
    return texts
