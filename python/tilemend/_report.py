"""report.json of a filled scene or mesh."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional

from ._decisions import Decision, write_decisions
from ._errors import InvalidInput, NotFound
from ._reading import json_of, of_file
from ._types import Path

_LISTS = ('per_hole', 'left', 'warnings', 'water', 'look_at')
_NEWER_LISTS = ('review', 'water_areas', 'not_holes', 'tension', 'levels')  # not in reports of every release
_NUMBERS = ('hole', 'cluster', 'layer', 'body', 'clear_height', 'share_on_objects')  # of holes.geojson, as what follows
_UNITS = ('_m', '_m2')
_COLUMNS = ('column', 'row', 'x', 'y', 'z', 'area_m2', 'outcome', 'taken_for')  # of a table without rows


@dataclass(frozen=True, eq=False, repr=False)
class Report:
    """What was filled, what was left, and why (user guide, "Report").

    Attributes:
        path: of the file.
        data: the whole report. `report['water']` is `report.data['water']`.
    """

    path: str
    data: Dict[str, Any]

    def __repr__(self) -> str:
        filled = sum(hole.get('outcome') == 'filled' for hole in self.holes)
        warnings = f', {counted(len(self.warnings), "warning")}' if self.warnings else ''
        return (f'Report({self.path!r}: {counted(filled, "hole")} filled, {len(self.left)} left, '
                f'{len(self.review)} to review{warnings})')

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
        """The tensions that `auto` chose: `cluster` or `hole`, `tension` (1/m²), `steepness` (of ground with walls), ..."""
        return self._rows('tension')

    @property
    def warnings(self) -> List[str]:
        return list(self.data['warnings'])

    def _rows(self, name: str) -> List[Dict[str, Any]]:
        return list(self.data.get(name) or [])

    def holes_table(self) -> Any:
        """The holes as a pandas.DataFrame indexed by `id`. Their cells are the columns `column` and `row`, their centres
        `x` and `y` and, if holes have a height, `z`, in metres. Needs pandas."""
        with of_file(self.path):
            return table_of(self.holes)

    def review_table(self) -> Any:
        """The fills in doubt as a pandas.DataFrame indexed by `hole`, the most doubtful first. Needs pandas."""
        with of_file(self.path):
            return table_of(self.review, 'hole')

    def write_decisions(self, path: Path, decisions: Mapping[int, Decision], *, overwrite: bool = False) -> None:
        """Writes a file for `decisions` of a job, or `tilemend run --decisions`, onto this output.

        The file has the decisions of earlier rounds as well: what is not in it is undone.

        Args:
            path: the file, GeoJSON.
            decisions: by number of hole 'accept', 'water', 'ground' or 'open'; ('water', level) with a height in the
                scene's CRS, as `level_m` of holes.geojson; None takes an earlier decision back. Each also decides on
                the holes that belong together with it (`holes` in `review`).
            overwrite: replaces a file that is there.

        Raises:
            InvalidInput (a ValueError): there is no such hole or decision, the hole has no polygon, a level is not
            finite, or the report or holes.geojson is damaged.
            AlreadyExists (a FileExistsError): there is such a file.
            NotFound: there is no holes.geojson beside the report.
        """
        write_decisions(self.path, self.data, self._holes_path(), path, decisions, overwrite)

    def holes_map(self) -> Any:
        """The polygons of the holes as a geopandas.GeoDataFrame in the scene's CRS, from holes.geojson beside the
        report. What is not there is NaN in columns of numbers and None in all others. InvalidInput if that file is
        damaged. Needs GeoPandas."""
        try:
            import geopandas
        except ImportError:
            raise ImportError('holes_map needs GeoPandas (Debian: python3-geopandas)') from None
        path = self._holes_path()
        if not os.path.exists(path):
            raise NotFound(f'{path}: no such file; only `tilemend run` and jobs write it')
        try:
            return _with_none(geopandas.read_file(path))
        except (ImportError, MemoryError):
            raise
        except Exception as error:  # of several libraries, without a class in common
            raise InvalidInput(f'{path}: cannot be read as holes of tilemend: {error!r}') from error

    def _holes_path(self) -> str:
        return os.path.join(os.path.dirname(self.path), 'holes.geojson')


def read_report(path: Path) -> Report:
    """Reads a report.

    Args:
        path: an output folder, or a report.json.

    Raises:
        NotFound: there is no such folder or file: the output is not there, or not complete.
        NotAllowed: the file may not be read.
        InvalidInput: it is no report.
    """
    name = os.fsdecode(path)
    if '\0' in name:
        raise InvalidInput(f'{name!r}: is no path')
    if os.path.isdir(name):
        name = os.path.join(name, 'report.json')
    try:
        data = json_of(name)
    except FileNotFoundError:
        raise NotFound(_what_is_missing(name, os.fsdecode(path))) from None
    missing = _missing(data)
    if missing:
        raise InvalidInput(f'{name}: is no report of tilemend: {missing}')
    return Report(name, data)


def _what_is_missing(name: str, given: str) -> str:
    """`name`: the report.json of `given`, if that is a folder."""
    if name != given:
        return f'{name}: no such file; an output without it is not complete'
    is_file = name.endswith('.json')
    folder = os.path.dirname(name) if is_file else name
    return f'{name}: no such file' if is_file and os.path.isdir(folder or '.') else f'{folder}: no such folder'


def _missing(data: Any) -> Optional[str]:
    if not isinstance(data, dict):
        return f'expected an object, found {type(data).__name__}'
    for key in _LISTS + _NEWER_LISTS:
        if not isinstance(data.get(key, None if key in _LISTS else []), list):
            return f'it has no list "{key}"'
        kind, name = (str, 'text') if key == 'warnings' else (dict, 'object')
        if not all(isinstance(row, kind) for row in data.get(key, [])):
            return f'a row of "{key}" is no {name}'
    return None


def _with_none(holes: Any) -> Any:
    """The same with one kind of empty value for each column. A column without any value has no type of its own."""
    for name in holes.columns.drop('geometry'):
        is_number = name in _NUMBERS or name.endswith(_UNITS)
        if is_number and holes[name].isna().all():
            holes[name] = holes[name].astype(float)
        elif not is_number:
            holes[name] = _without_nan(holes[name].astype(object))
    return holes


def _without_nan(column: Any) -> Any:
    return column.where(column.notna(), None)


def table_of(holes: List[Dict[str, Any]], index: str = 'id') -> Any:
    """Rows of holes as a pandas.DataFrame."""
    try:
        import pandas
    except ImportError:
        raise ImportError('a table needs pandas (Debian: python3-pandas)') from None
    rows = []
    for hole in holes:
        row: Dict[str, Any] = {index: hole[index]}
        row['column'], row['row'] = (list(hole.get('cell') or []) + [None, None])[:2]
        row['x'], row['y'], row['z'] = (list(hole.get('centre') or []) + [None] * 3)[:3]
        row.update((key, value) for key, value in hole.items() if key not in ('centre', 'cell', 'water'))
        if isinstance(row.get('level_m'), list):  # of a river: its upper and lower end
            row['level_m'], row['lower_level_m'] = row['level_m']
        row.setdefault('taken_for', (hole.get('water') or {}).get('taken_for'))
        rows.append(row)
    table = pandas.DataFrame(rows, columns=None if rows else [index, *_COLUMNS]).set_index(index)
    for name in table.columns[table.dtypes == object]:
        table[name] = _without_nan(table[name])
    has_no_height = bool(rows) and all(row['z'] is None for row in rows)  # over a horizontal plane
    return table.drop(columns='z') if has_no_height else table


def counted(count: int, one: str, many: str = '') -> str:
    """"1 hole", "2 holes"."""
    return f'{count} {one if count == 1 else many or one + "s"}'
