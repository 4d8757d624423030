"""What `fill` returns."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List

import numpy as np
from numpy.typing import NDArray

from ._report import counted, table_of

_LONGER = 'longer than --largest-hole'  # as the report has it


@dataclass(frozen=True, eq=False, repr=False)
class Filled:
    """A mesh with its holes filled. The original vertices and faces come first, unchanged and in their order.

    With `weld` or `clear` faces change or are missing; vertices never do.

    Attributes:
        vertices: (n, 3) coordinates in the unit of the input, float32 if the input was, else float64.
        faces: (m, 3) int32, indices of vertices, counter-clockwise seen from outside.
        filled: (m,) bool, True for new faces.
        report: what `tilemend fill -o json` prints: every hole and what became of it.
    """

    vertices: NDArray[Any]
    faces: NDArray[np.int32]
    filled: NDArray[np.bool_]
    report: Dict[str, Any]

    def __repr__(self) -> str:
        filled = sum(hole['outcome'] == 'filled' for hole in self.holes)
        left = sum(row.get('count', 1) for row in self.left)
        warnings = f', {counted(len(self.warnings), "warning")}' if self.warnings else ''
        return (f'Filled({counted(len(self.vertices), "vertex", "vertices")}, {counted(len(self.faces), "face")}, '
                f'{np.count_nonzero(self.filled)} new, {counted(filled, "hole")} filled, {left} left{warnings})')

    @property
    def new_faces(self) -> NDArray[np.int32]:
        """(k, 3) int32, the new faces alone."""
        return self.faces[self.filled]

    @property
    def holes(self) -> List[Dict[str, Any]]:
        """A row for each hole: `id`, `centre`, `area_m2`, `outcome`, `reason`, `method`, ... (user guide, "Report")."""
        return list(self.report['per_hole'])

    @property
    def left(self) -> List[Dict[str, Any]]:
        """The holes that stay open: `hole`, `reason`, `open_edges`. Those that are longer than `largest_hole` are one
        row, with their number as `count` and the edges of all: the report does not tell them apart."""
        longer = [{'reason': f'longer than largest_hole={self.report["options"]["largest-hole"]:.0f}',
                   'count': row['count'], 'open_edges': row['open_edges']}
                  for row in self.report.get('not_holes', []) if row['what'] == _LONGER]
        return list(self.report['left']) + longer

    @property
    def warnings(self) -> List[str]:
        return list(self.report['warnings'])

    def holes_table(self) -> Any:
        """The holes as a pandas.DataFrame, one row a hole, indexed by `id`. Needs pandas."""
        return table_of(self.holes)
