"""report.json of a filled scene or mesh."""
from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Union

from ._errors import InvalidInput, NotFound


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
        """What was filled flat: `kind`, `level_m` (metres), `sigma_m`, `area_m2`, ..."""
        return list(self.data['water'])

    @property
    def left(self) -> List[Dict[str, Any]]:
        """Holes that stay open: `cell`, `reason`, `open_edges`."""
        return list(self.data['left'])

    @property
    def look_at(self) -> List[Dict[str, Any]]:
        """Fills that a person should look at, the largest first: `centre`, `area_m2`, `why`."""
        return list(self.data['look_at'])

    @property
    def warnings(self) -> List[str]:
        return list(self.data['warnings'])

    def holes_table(self) -> Any:
        """The holes as a pandas.DataFrame indexed by `id`; centres as columns `x` and `y` in metres. Needs pandas."""
        return table_of(self.holes)

    def holes_map(self) -> Any:
        """The polygons of the holes as a geopandas.GeoDataFrame in the scene's CRS, from holes.geojson beside the
        report. Needs GeoPandas."""
        try:
            import geopandas
        except ImportError:
            raise ImportError('holes_map needs GeoPandas (Debian: python3-geopandas)') from None
        path = os.path.join(os.path.dirname(self.path), 'holes.geojson')
        if not os.path.exists(path):
            raise NotFound(f'{path}: no such file; only `tilemend run` and jobs write it')
        return geopandas.read_file(path)


def read_report(path: Union[str, 'os.PathLike[str]']) -> Report:
    """Reads a report.

    Args:
        path: an output folder, or a report.json.

    Raises:
        NotFound: there is no such file: the output is not complete, or not there.
        InvalidInput: it is no report.
    """
    name = os.fspath(path)
    if os.path.isdir(name):
        name = os.path.join(name, 'report.json')
    try:
        with open(name, encoding='utf-8') as file:
            data = json.load(file)
    except FileNotFoundError:
        raise NotFound(f'{name}: no such file; an output without it is not complete') from None
    except (UnicodeDecodeError, json.JSONDecodeError, RecursionError) as error:
        raise InvalidInput(f'{name}: is not JSON: {error}') from None
    missing = _missing(data)
    if missing:
        raise InvalidInput(f'{name}: is no report of tilemend: {missing}')
    return Report(name, data)


def _missing(data: Any) -> Optional[str]:
    if not isinstance(data, dict):
        return f'expected an object, found {type(data).__name__}'
    for key in ('per_hole', 'left', 'warnings', 'water', 'look_at'):
        if not isinstance(data.get(key), list):
            return f'it has no list "{key}"'
    return None


def table_of(holes: List[Dict[str, Any]]) -> Any:
    """Rows of holes as a pandas.DataFrame."""
    try:
        import pandas
    except ImportError:
        raise ImportError('holes_table needs pandas (Debian: python3-pandas)') from None
    rows = []
    for hole in holes:
        row = {key: value for key, value in hole.items() if key not in ('centre', 'cell', 'water')}
        row['x'], row['y'] = (list(hole.get('centre') or []) + [None, None])[:2]
        row['column'], row['row'] = (list(hole.get('cell') or []) + [None, None])[:2]
        row['taken_for'] = (hole.get('water') or {}).get('taken_for')
        rows.append(row)
    columns = ['id'] if not rows else None
    return pandas.DataFrame(rows, columns=columns).set_index('id')
