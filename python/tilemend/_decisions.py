"""A reviewer's decisions on holes, for `tilemend run --decisions FILE` and jobs."""
from __future__ import annotations

import json
import math
import numbers
import os
from typing import Any, Dict, List, Literal, Mapping, Optional, Tuple, Union

from ._errors import AlreadyExists, InvalidInput, NotFound
from ._types import Path

# With a level in metres; None takes an earlier decision back.
Decision = Union[Literal['accept', 'water', 'ground', 'open'], Tuple[Literal['water'], float], None]

_KINDS = ('accept', 'water', 'ground', 'open')
_KEPT = ('hole', 'cluster')  # what --decisions reads beside the decision


def write_decisions(report: Dict[str, Any], outlines: str, path: Path, decisions: Mapping[int, Decision],
                    overwrite: bool) -> None:
    """Writes the decisions, and those that the report's output has already. `outlines`: path of its holes.geojson."""
    collection = _read(outlines)
    marks: Dict[int, Optional[Dict[str, Any]]] = {}
    for hole, decision in dict(decisions).items():
        mark = _properties(hole, decision)
        for other in _group(report, hole):
            if marks.setdefault(other, mark) != mark:
                raise InvalidInput(f'decisions: hole {hole} and another hole of its group have different decisions; '
                                   'they belong together, so give one')
    features, without = [], set(marks)
    for feature in collection['features']:
        properties = feature['properties']
        hole = properties['hole']
        is_polygon = (feature['geometry'] or {}).get('type') in ('Polygon', 'MultiPolygon')
        if is_polygon:
            without.discard(hole)
        mark = marks.get(hole, _earlier(properties))
        if is_polygon and mark:
            features.append(dict(feature, properties={**{name: properties.get(name) for name in _KEPT}, **mark}))
    if without:
        raise InvalidInput(f'decisions: {os.path.basename(outlines)} has no polygon of hole '
                           f'{", ".join(map(str, sorted(without)))}, so nothing can be decided on it')
    text = json.dumps(dict(collection, features=features))
    try:
        with open(path, 'w' if overwrite else 'x', encoding='utf-8') as file:
            file.write(text)
    except FileExistsError:
        raise AlreadyExists(f'{os.fsdecode(path)}: exists already; choose another path, or give overwrite=True') from None
    except OSError as error:
        raise InvalidInput(f'{os.fsdecode(path)}: cannot be written: {error.strerror}') from None


def _read(path: str) -> Dict[str, Any]:
    try:
        with open(path, encoding='utf-8') as file:
            collection = json.load(file)
        [feature['properties']['hole'] for feature in collection['features']]
    except FileNotFoundError:
        raise NotFound(f'{path}: no such file; only `tilemend run` and jobs write it') from None
    except (ValueError, LookupError, TypeError, RecursionError) as error:
        raise InvalidInput(f'{path}: is no file of holes of tilemend: {error!r}') from None
    return dict(collection)


def _properties(hole: int, decision: Decision) -> Optional[Dict[str, Any]]:
    if decision is None:
        return None
    kind, level = decision if isinstance(decision, tuple) and len(decision) == 2 else (decision, None)
    is_number = isinstance(level, numbers.Real) and not isinstance(level, bool) and math.isfinite(level)
    is_level = level is None or is_number and kind == 'water'
    if kind not in _KINDS or not is_level:
        raise InvalidInput(f'decisions[{hole}] is {decision!r}: expected {", ".join(_KINDS)}, None, or ("water", LEVEL) '
                           'with a finite number')
    try:
        return {'decision': kind, 'level_m': None if level is None else float(level)}
    except OverflowError:
        raise InvalidInput(f'decisions[{hole}]: the level is too large') from None


def _earlier(properties: Dict[str, Any]) -> Optional[Dict[str, Any]]:
    kind = properties.get('decision')
    return kind and {'decision': kind, 'level_m': properties.get('level_m') if kind == 'water' else None}


def _group(report: Dict[str, Any], hole: int) -> List[int]:
    """The holes that are decided together: those of its row in the review, else of its cluster."""
    for item in report.get('review', []):
        if hole in item['holes']:
            return list(item['holes'])
    clusters = {row['id']: row.get('cluster', -1) for row in report['per_hole']}
    if hole not in clusters:
        raise InvalidInput(f'decisions: the report has no hole {hole!r}; holes go by their numbers')
    if clusters[hole] < 0:
        return [hole]
    return [other for other, cluster in clusters.items() if cluster == clusters[hole]]
