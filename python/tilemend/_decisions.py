"""A reviewer's decisions on holes, for `tilemend run --decisions FILE` and jobs."""
from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Literal, Mapping, Optional, Tuple, Union

from ._errors import AlreadyExists, InvalidInput, NotFound
from ._reading import is_number, json_of, of_file
from ._types import Path

# With a level in metres; None takes an earlier decision back.
Decision = Union[Literal['accept', 'water', 'ground', 'open'], Tuple[Literal['water'], float], None]

_KINDS = ('accept', 'water', 'ground', 'open')
_MOST_HEIGHT = 1e5  # metres above or below 0, as --decisions takes it (common/gis/feature_properties.cc)
_KEPT = ('hole', 'cluster')  # what --decisions reads beside the decision


def write_decisions(report_path: str, report: Dict[str, Any], outlines: str, path: Path,
                    decisions: Mapping[int, Decision], overwrite: bool) -> None:
    """Writes the decisions, and those that the report's output has already. `outlines`: path of its holes.geojson."""
    collection = _read(outlines)
    marks: Dict[int, Optional[Dict[str, Any]]] = {}
    for hole, decision in dict(decisions).items():
        mark = _properties(hole, decision)
        with of_file(report_path):
            group = _group(report, hole)
        if not all(map(is_number, group)):
            raise InvalidInput(f'{report_path}: is not as tilemend writes it: a number of a hole is no number')
        for other in group:
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
    _write(os.fsdecode(path), json.dumps(dict(collection, features=features)), overwrite, outlines)


def _write(path: str, text: str, overwrite: bool, outlines: str) -> None:
    """Whole or not at all, and never over a file of the output."""
    for own in (outlines, os.path.join(os.path.dirname(outlines), 'report.json')):
        if os.path.exists(path) and os.path.exists(own) and os.path.samefile(path, own):
            raise InvalidInput(f'{path}: is a file of the output; choose another path')
    if os.path.lexists(path) and not overwrite:
        raise AlreadyExists(f'{path}: exists already; choose another path, or give overwrite=True')
    part = f'{path}.part-{os.getpid()}'
    try:
        with open(part, 'w', encoding='utf-8') as file:
            file.write(text)
        os.replace(part, path)
    except OSError as error:
        if os.path.exists(part):
            os.remove(part)
        raise InvalidInput(f'{path}: cannot be written: {error.strerror}') from None


def _read(path: str) -> Dict[str, Any]:
    """A collection of features that have `properties` with a number `hole`, and a `geometry`, which may be None."""
    try:
        collection = json_of(path)
    except FileNotFoundError:
        raise NotFound(f'{path}: no such file; only `tilemend run` and jobs write it') from None
    features = collection.get('features') if isinstance(collection, dict) else None
    if not isinstance(features, list):
        raise InvalidInput(f'{path}: is no file of holes of tilemend: expected an object with a list "features"')
    if not isinstance(collection.get('tilemend_scene'), (dict, type(None))):
        raise InvalidInput(f'{path}: is no file of holes of tilemend: expected "tilemend_scene" to be an object')
    for number, feature in enumerate(features):
        if not _is_hole(feature):
            raise InvalidInput(f'{path}: is no file of holes of tilemend: features[{number}] is no feature with a '
                               'number "hole" among its properties')
    return dict(collection)


def _is_hole(feature: Any) -> bool:
    if not isinstance(feature, dict) or not isinstance(feature.get('properties'), dict):
        return False
    return is_number(feature['properties'].get('hole')) and isinstance(feature.get('geometry', 0), (dict, type(None)))


def _properties(hole: int, decision: Decision) -> Optional[Dict[str, Any]]:
    if decision is None:
        return None
    kind, level = decision if isinstance(decision, tuple) and len(decision) == 2 else (decision, None)
    is_level = level is None or kind == 'water' and is_number(level) and -_MOST_HEIGHT <= level <= _MOST_HEIGHT
    if kind not in _KINDS or not is_level:
        raise InvalidInput(f'decisions[{hole}] is {decision!r}: expected {", ".join(_KINDS)}, None, or ("water", LEVEL) '
                           f'with a height in metres from -{_MOST_HEIGHT:.0f} to {_MOST_HEIGHT:.0f}')
    return {'decision': kind, 'level_m': None if level is None else float(level)}


def _earlier(properties: Dict[str, Any]) -> Optional[Dict[str, Any]]:
    """A level without a sigma was given; one with a sigma was found on the shore, and is to be found there again."""
    kind = properties.get('decision')
    is_given = kind == 'water' and properties.get('sigma_m') is None
    return kind and {'decision': kind, 'level_m': properties.get('level_m') if is_given else None}


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
