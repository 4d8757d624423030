"""Types that several modules name."""
from __future__ import annotations

import os
from typing import Any, Callable, Protocol, Sequence, Union

from numpy.typing import NDArray



class HasArray(Protocol):
    """An array of numpy, or what becomes one: a table of pandas, a vector of Open3D."""

    def __array__(self) -> NDArray[Any]: ...


# Of shape (n, 3). ArrayLike of numpy would take text and single numbers as well.
Rows = Union[HasArray, Sequence[Union[Sequence[float], HasArray]]]

Path = Union[str, 'os.PathLike[str]']

# (step, holes done, holes)
FillProgress = Callable[[str, int, int], Any]
