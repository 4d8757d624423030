"""report.json of a filled scene or mesh."""
from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Dict, List, Mapping, Optional, Union

from ._decisions import Decision, write_decisions
from ._errors import InvalidInput, NotAllowed, NotFound

_LISTS = ('per_hole', 'left', 'warnings', 'water', 'look_at')
_NEWER_LISTS = ('review', 'water_areas', 'not_holes', 'tension', 'levels')  # not in reports of every release
_COLUMNS = ('area_m2', 'outcome', 'taken_for', 'x', 'y', 'z', 'column', 'row')  # of a table without rows


@dataclass(frozen=True, eq=False)
class Report:
    """What was filled, what was left, and why (user guide, "Report").

    Attributes:
        path: of the file.
        data: the whole report. `report['water']` is `report.data['water']`.
    """

    path: str
    data: Dict[str, Any] = field(repr=False)

    def __getitem__(self, key: str) -> Any:
        return self.data[key]

    @property
    def holes(self) -> List[Dict[str, Any]]:
        """A row for each hole and cell: `id`, `cell`, `kind`, `area_m2` (m²), `outcome`, `reason`, ..."""
        return list(self.data['per_hole'])

    @property
    def water(self) -> List[Dict[str, Any]]:
        """What was filled flat: `kind`, `level_m` (metres above the scene's origin), `sigma_m`, `area_m2`, ..."""
        return self._rows('water')

    @property
    def water_areas(self) -> List[Dict[str, Any]]:
        """What became of each polygon of `water`: `feature`, `taken`, `holes`, `level_m` or `reason`, `doubt`."""
        return self._rows('water_areas')

    @property
    def review(self) -> List[Dict[str, Any]]:
        """Fills in doubt, the most doubtful first: `hole`, `holes`, `taken_for`, `doubt_m`, `doubt_m3`, ..."""
        return self._rows('review')

    @property
    def look_at(self) -> List[Dict[str, Any]]:
        """Fills that a person should look at, the largest first: `centre`, `area_m2`, `why`."""
        return self._rows('look_at')

    @property
    def left(self) -> List[Dict[str, Any]]:
        """Holes that stay open: `cell`, `reason`, `open_edges`."""
        return self._rows('left')

    @property
    def not_holes(self) -> List[Dict[str, Any]]:
        """What stays open but is no hole: `what`, `count`, `open_edges`."""
        return self._rows('not_holes')

    @property
    def cleared(self) -> Dict[str, Any]:
        """Surface that was taken out: `triangles`, of each of `tiles` and of `areas`."""
        return dict(self.data.get('cleared') or {})

    @property
    def levels(self) -> List[Dict[str, Any]]:
        """Levels of detail of a tileset: `level`, `nodes`, `filled`, `added`, `removed`; [] without any."""
        return self._rows('levels')

    @property
    def tension(self) -> List[Dict[str, Any]]:
        """The tensions that `auto` chose: `cluster` or `hole`, `tension` (1/m²), `hold_out_error_m`, ..."""
        return self._rows('tension')

    @property
    def warnings(self) -> List[str]:
        return list(self.data['warnings'])

    def _rows(self, name: str) -> List[Dict[str, Any]]:
        return list(self.data.get(name) or [])

    def holes_table(self) -> Any:
        """The holes as a pandas.DataFrame indexed by `id`; centres as columns `x`, `y` and, of holes over no
        horizontal plane, `z` in metres. Needs pandas."""
        return table_of(self.holes)

    def review_table(self) -> Any:
        """The fills in doubt as a pandas.DataFrame indexed by `hole`, the most doubtful first. Needs pandas."""
        return table_of(self.review, 'hole')

    def write_decisions(self, path: Union[str, 'os.PathLike[str]'], decisions: Mapping[int, Decision]) -> None:
        """Writes a file for `decisions` of a job, or `tilemend run --decisions`, onto this output.

        The file has the decisions of earlier rounds as well: what is not in it is undone.

        Args:
            path: the file, GeoJSON. One that is there is replaced.
            decisions: by number of hole 'accept', 'water', 'ground' or 'open'; ('water', level) with a height in the
                scene's CRS, as `level_m` of holes.geojson; None takes an earlier decision back. Each also decides on
                the holes that belong together with it (`holes` in `review`).

        Raises:
            InvalidInput: there is no such hole or decision, or the hole has no polygon.
            NotFound: there is no holes.geojson beside the report.
        """
        write_decisions(self.data, self._holes_path(), path, decisions)

    def holes_map(self) -> Any:
        """The polygons of the holes as a geopandas.GeoDataFrame in the scene's CRS, from holes.geojson beside the
        report. Needs GeoPandas."""
        try:
            import geopandas
        except ImportError:
            raise ImportError('holes_map needs GeoPandas (Debian: python3-geopandas)') from None
        path = self._holes_path()
        if not os.path.exists(path):
            raise NotFound(f'{path}: no such file; only `tilemend run` and jobs write it')
        return geopandas.read_file(path)

    def _holes_path(self) -> str:
        return os.path.join(os.path.dirname(self.path), 'holes.geojson')


def read_report(path: Union[str, 'os.PathLike[str]']) -> Report:
    """Reads a report.

    Args:
        path: an output folder, or a report.json.

    Raises:
        NotFound: there is no such file: the output is not complete, or not there.
        NotAllowed: the file may not be read.
        InvalidInput: it is no report.
    """
    name = os.fsdecode(path)
    if '\0' in name:
        raise InvalidInput(f'{name!r}: is no path')
    if os.path.isdir(name):
        name = os.path.join(name, 'report.json')
    try:
        with open(name, encoding='utf-8') as file:
            data = json.load(file)
    except FileNotFoundError:
        raise NotFound(f'{name}: no such file; an output without it is not complete') from None
    except PermissionError:
        raise NotAllowed(f'{name}: may not be read by this user') from None
    except OSError as error:
        raise InvalidInput(f'{name}: cannot be read: {error.strerror}') from None
    except (UnicodeDecodeError, json.JSONDecodeError, RecursionError) as error:
        raise InvalidInput(f'{name}: is not JSON: {error}') from None
    missing = _missing(data)
    if missing:
        raise InvalidInput(f'{name}: is no report of tilemend: {missing}')
    return Report(name, data)


def _missing(data: Any) -> Optional[str]:
    if not isinstance(data, dict):
        return f'expected an object, found {type(data).__name__}'
    for key in _LISTS + _NEWER_LISTS:
        if not isinstance(data.get(key, None if key in _LISTS else []), list):
            return f'it has no list "{key}"'
    return None


def table_of(holes: List[Dict[str, Any]], index: str = 'id') -> Any:
    """Rows of holes as a pandas.DataFrame."""
    try:
        import pandas
    except ImportError:
        raise ImportError('a table needs pandas (Debian: python3-pandas)') from None
    rows = []
    for hole in holes:
        row = {key: value for key, value in hole.items() if key not in ('centre', 'cell', 'water')}
        row['x'], row['y'], row['z'] = (list(hole.get('centre') or []) + [None] * 3)[:3]
        row['column'], row['row'] = (list(hole.get('cell') or []) + [None, None])[:2]
        if isinstance(row.get('level_m'), list):  # of a river: its upper and lower end
            row['level_m'], row['lower_level_m'] = row['level_m']
        row.setdefault('taken_for', (hole.get('water') or {}).get('taken_for'))
        rows.append(row)
    return pandas.DataFrame(rows, columns=None if rows else [index, *_COLUMNS]).set_index(index)
