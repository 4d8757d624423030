#!/usr/bin/python3
"""Applies a reviewer's decisions to a finished output and looks at what was written again.

    decisions_test.py TILEMEND TOOLS

TOOLS has make_city.py. The city has two bodies of water, and holes between houses. Exits 77 (skipped) without the tool or
without numpy.
"""
import hashlib
import json
import os
import subprocess
import sys
import tempfile

from city_test import skip, tool

CITY = ['--cols', '4', '--rows', '3', '--cell', '80', '--seed', '3', '--no-objects']
RAISED = 0.5  # metres
LEFT = 'left open by decision'
OVER_NO_HOLE = [[[[500000 + x, 4100000 + y] for x, y in ((1, 1), (2, 1), (2, 2), (1, 1))]]]  # metres, in the CRS of the city


def fail(why):
    sys.exit(f'FAILED: {why}')


def expect(holds, what):
    if not holds:
        fail(what)


def run(tilemend, *words, codes=(0, 100)):
    done = subprocess.run([tilemend, *words], capture_output=True, text=True, timeout=280)
    expect(done.returncode in codes, f'{" ".join(words)}: exit code {done.returncode}\n{done.stdout}{done.stderr}')
    return done.stdout + done.stderr


def report_of(out):
    with open(os.path.join(out, 'report.json')) as file:
        return json.load(file)


def tiles_of(out):
    """{path: (digest, inode, time)} of all tiles."""
    found = {}
    for base, _, names in os.walk(os.path.join(out, 'tiles')):
        for name in names:
            path = os.path.join(base, name)
            status = os.stat(path)
            with open(path, 'rb') as file:
                digest = hashlib.sha256(file.read()).hexdigest()
            found[os.path.relpath(path, out)] = (digest, status.st_ino, status.st_mtime_ns)
    return found


def digests(tiles):
    return {path: digest for path, (digest, _, _) in tiles.items()}


def two_bodies(report):
    """The two fills of the queue with the largest area: both are water."""
    items = sorted(report['review'], key=lambda item: -item['area_m2'])[:2]
    expect(len(items) == 2 and all(item['taken_for'] in ('lake', 'river') for item in items), f"no two in {report['review']}")
    return items


class Marks:
    """Decisions, with the polygons of holes.geojson and the scene that they are of, as report.html writes them."""

    def __init__(self, out):
        with open(os.path.join(out, 'holes.geojson')) as file:
            self.holes = json.load(file)
        self.features = []

    def add(self, item, decision, level=None):
        polygons = []
        for feature in self.holes['features']:
            geometry = feature['geometry']
            if feature['properties']['hole'] not in item['holes']:
                continue
            polygons += geometry['coordinates'] if geometry['type'] == 'MultiPolygon' else [geometry['coordinates']]
        self.add_polygons(item['hole'], decision, level, polygons)

    def add_polygons(self, hole, decision, level, polygons):
        self.features.append({'type': 'Feature', 'properties': {'hole': hole, 'decision': decision, 'level_m': level},
                              'geometry': {'type': 'MultiPolygon', 'coordinates': polygons}})

    def write(self, path):
        with open(path, 'w') as file:
            json.dump(dict(self.holes, features=self.features), file)
        return path


def tiles_of_holes(report, holes):
    return {f"tiles/Tile_{row['cell'][0]:+04d}_{row['cell'][1]:+04d}.ply" for row in report['per_hole'] if row['id'] in holes}


def check_queue(report):
    volumes = [item['doubt_m3'] for item in report['review']]
    expect(volumes and volumes == sorted(volumes, reverse=True), f'the queue is not by doubt x area: {volumes}')


def check_result(report, lake, level, open_item):
    ids = {row['id'] for row in report['per_hole']}
    expect(ids >= set(lake['holes']) | set(open_item['holes']), f'holes are missing: {sorted(ids)}')
    for row in report['per_hole']:
        if row['id'] in lake['holes']:
            expect(row['decision'] == 'water' and abs(row['level_m'] - level) < 0.001, f'the lake: {row}')
        if row['id'] in open_item['holes']:
            expect(row['outcome'] == 'left' and row['reason'] == LEFT and row['decision'] == 'open', f'the open one: {row}')
    expect(any('hole 999' in w and 'no hole lies under it' in w for w in report['warnings']),
           f"no warning names the decision without a hole: {report['warnings']}")
    queued = {item['hole'] for item in report['review']}
    expect(not queued & {lake['hole'], open_item['hole']}, 'what is decided is still in the queue')


def check_refusals(tilemend, scene, out, marks, folder):
    text = run(tilemend, 'run', scene, '--out', out, codes=(4,))
    expect('--decisions' in text, f'onto a finished output: {text}')
    text = run(tilemend, 'run', scene, '--out', out, '--decisions', marks, '--gradation', '1.5', codes=(4,))
    expect('another scene or other options' in text, f'with other options: {text}')
    bad = os.path.join(folder, 'bad.geojson')
    with open(bad, 'w') as file:
        file.write('{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"decision": "maybe"}, '
                   '"geometry": {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]}}]}')
    text = run(tilemend, 'run', scene, '--out', out, '--decisions', bad, codes=(4,))
    expect(f'{bad}: feature 0: property decision' in text, f'a bad file: {text}')
    # A wrong file, or a level that no shore has, undoes nothing.
    tiles, holes = tiles_of(out), Marks(out)
    for properties, words in (({}, 'none of its features (1) is a decision'),
                              ({'decision': 'water', 'level_m': 99999}, 'm above all surface of the scene')):
        wrong = os.path.join(folder, 'wrong.geojson')
        feature = next(dict(f, properties=properties) for f in holes.holes['features'] if 'Polygon' in f['geometry']['type'])
        with open(wrong, 'w') as file:
            json.dump({'type': 'FeatureCollection', 'crs': holes.holes['crs'], 'features': [feature]}, file)
        text = run(tilemend, 'run', scene, '--out', out, '--decisions', wrong, codes=(4,))
        expect(words in text and tiles_of(out) == tiles, f'a wrong file: {text}')
    elsewhere = Marks(out)
    elsewhere.add_polygons(3, 'accept', None, OVER_NO_HOLE)
    file = elsewhere.write(os.path.join(folder, 'elsewhere.geojson'))
    for command in (('run', scene, '--out', out), ('inspect', scene)):
        text = run(tilemend, *command, '--decisions', file, codes=(4,))
        expect('is the file of another scene?' in text and tiles_of(out) == tiles, f'decisions on another scene: {text}')


def check_another_scene(tilemend, scene, out, file, folder):
    """Decisions on a scene of another grid are refused, though they lie over holes here; another name is warned of."""
    with open(file) as read:
        marks = json.load(read)
    tiles = tiles_of(out)
    member = marks['tilemend_scene']
    expect(member['name'] == 'scene', f'holes.geojson is of {member}')
    renamed = {**member, 'name': 'harbour'}
    other = os.path.join(folder, 'harbour.geojson')
    for given, codes, words in (({**renamed, 'cell_size': [9, 9]}, (4,), "its decisions are on scene 'harbour'"),
                                (renamed, (0, 100), "its decisions are on a scene in folder 'harbour'"),
                                (None, (0, 100), '')):
        with open(other, 'w') as written:
            json.dump({**marks, 'tilemend_scene': given}, written)
        text = run(tilemend, 'run', scene, '--out', out, '--decisions', other, codes=codes)
        expect(words in text and ("'harbour'" in text) == bool(given), f'decisions on another scene: {text}')
        expect(tiles_of(out) == tiles, 'the decisions of a copy without its scene write other tiles')


def check_part(tilemend, scene, out, folder, before):
    """A decision on a part of holes that are decided on together is named, with what to do."""
    item = next(i for i in before['review'] if len(i['holes']) > 1)
    part = min(item['holes'], key=lambda hole: next(row['area_m2'] for row in before['per_hole'] if row['id'] == hole))
    marks = Marks(out)
    marks.add({'hole': part, 'holes': [part]}, 'open')
    file = os.path.join(folder, 'part.geojson')
    text = run(tilemend, 'run', scene, '--out', out, '--decisions', marks.write(file), codes=(4,))
    expect('none of the 1 decisions has an effect' in text and f'decision on hole {part}' in text, f'alone: {text}')
    marks.add(next(i for i in before['review'] if part not in i['holes']), 'accept')
    run(tilemend, 'run', scene, '--out', out, '--decisions', marks.write(file))
    report = report_of(out)
    expect(not any(part == row['id'] and 'decision' in row for row in report['per_hole']), 'a part has an effect')
    expect(any(f'decision on hole {part} is not taken' in w and 'which are decided on together; to decide on them' in w
               for w in report['warnings']), f"no warning of a decision on a part: {report['warnings']}")


def check_accepting(tilemend, scene, out, file, before, tiles):
    """Accepting changes nothing; ground is not level."""
    lake, other = two_bodies(before)
    marks = Marks(out)
    marks.add(lake, 'ground')
    marks.add(other, 'accept')
    run(tilemend, 'run', scene, '--out', out, '--decisions', marks.write(file))
    report = report_of(out)
    expect(all('level_m' not in row for row in report['per_hole'] if row['id'] in lake['holes']), 'the lake is level ground')
    for path in tiles_of_holes(before, other['holes']) - tiles_of_holes(before, lake['holes']):
        expect(tiles_of(out)[path][0] == tiles[path][0], f'{path}: accepted, and not as it was')


def check_reruns(tilemend, folder):
    scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
    before, tiles = report_of(out), tiles_of(out)
    check_queue(before)
    expect(f"\n{len(before['review'])} fills to decide on\n" in run(tilemend, 'report', out), 'the end has another count than the report')
    lake, other = two_bodies(before)
    level = lake['level_m'] + RAISED
    marks = Marks(out)
    marks.add(lake, 'water', level)
    marks.add_polygons(999, 'accept', None, OVER_NO_HOLE)
    file = marks.write(os.path.join(folder, 'marks.geojson'))

    # Nothing but the lake's tiles is written again.
    text = run(tilemend, 'run', scene, '--out', out, '--decisions', file)
    after, now = report_of(out), tiles_of(out)
    touched = tiles_of_holes(before, lake['holes'])
    written = {path for path in now if now[path] != tiles.get(path)}
    expect(now.keys() == tiles.keys(), 'tiles came or went')
    expect(written == touched, f'written again: {sorted(written)}, of the lake: {sorted(touched)}')
    kept = len(tiles) - len(touched)
    counts = after['tasks']
    expect((counts['tiles'], counts['tiles_kept']) == (len(tiles), kept), f'the report counts {counts}')
    expect(f'{kept} of {len(tiles)} tiles kept' in text, f'the end does not say what was kept: {text}')

    # More decisions, on an output that has some; all is as from nothing.
    marks.add(other, 'open')
    file = marks.write(os.path.join(folder, 'marks.geojson'))
    run(tilemend, 'run', scene, '--out', out, '--decisions', file)
    check_result(report_of(out), lake, level, other)
    fresh = os.path.join(folder, 'fresh')
    run(tilemend, 'run', scene, '--out', fresh, '--decisions', file)
    expect(digests(tiles_of(fresh)) == digests(tiles_of(out)), 'a run from nothing gives other tiles')
    again = tiles_of(out)
    run(tilemend, 'run', scene, '--out', out, '--decisions', file)
    expect(tiles_of(out) == again, 'the same decisions write a tile again')
    check_another_scene(tilemend, scene, out, file, folder)
    check_part(tilemend, scene, out, folder, before)
    check_accepting(tilemend, scene, out, file, before, tiles)
    check_refusals(tilemend, scene, out, file, folder)


def main():
    tilemend, tools = sys.argv[1:]
    if not os.path.exists(os.path.join(tools, 'make_city.py')):
        skip(f'{tools}/make_city.py is not there; set TILEMEND_SHARED_TOOLS')
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        skip(f'{error}; install python3-numpy')
    with tempfile.TemporaryDirectory() as folder:
        scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
        made = tool(tools, 'make_city.py', scene, *CITY)
        expect(made.returncode == 0, made.stderr)
        run(tilemend, 'run', scene, '--out', out)
        check_reruns(tilemend, folder)
        print('decisions are applied, and nothing else is written')


if __name__ == '__main__':
    main()
