#!/usr/bin/python3
"""Fills real city tiles, which overlap and have trees and houses at every rim, and holds the fill to the ground.

    TILEMEND_SHARED_TOOLS=DIR street_bench.py [--bin DIR] [--seeds 91,92,93,94,95,96]

Each row is a cut through the tiles of one level of detail: the ground of a strip and of ellipses over five cells of 100 m, so
that houses and trees stand around the hole. What is measured is check_city.py's, and what `tilemend check` finds: new open
edges, and new triangles that cross others. Where points are not covered, or both fills do not cover the strip of two tiles,
the tile may have surface of its own: a cut takes triangles away by their middles, and a long one reaches into the hole. *No
surface* counts the points over which the tile of their cell has neither. Needs numpy and scipy.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

import measure
import scene_tools
import surfaces

LEVELS = (17, 18)
HEADS = ['level', 'seed', 'points', 'covered', 'no surface', 'overlap', 'step 99 %, m', 'two fills', 'error mean, m', 'error 95 %, m',
         'open edges', 'crossings', 'new triangles']


def bare(scene, out):
    """How many points of the ground have neither original nor new surface of the tile of their cell over or under them."""
    layout = scene_tools.read_json(os.path.join(scene, 'scene.json'))
    points = np.load(os.path.join(scene, 'ground.npz'))['points'].astype(float)
    cells = np.floor(points[:, :2] / np.broadcast_to(layout['cell_size'], 2)).astype(int)
    without = 0
    for tile in layout['tiles']:
        here = points[(cells == (tile['col'], tile['row'])).all(1)]
        if len(here):
            corners, _ = surfaces.render.read_folder(os.path.join(out, tile['path']))
            without += int((surfaces.over(corners, here)[0] < 0).sum())
    return without


def row(bin_folder, folder, level, seed):
    scene, out, found = os.path.join(folder, f'city{level}'), os.path.join(folder, 'out'), os.path.join(folder, 'found.json')
    scene_tools.run('real_scenes.py', folder, '--cut', 'ground', '--only', f'city{level}', '--seed', seed)
    scene_tools.fill(bin_folder, scene, out)
    # Exit code 1 tells of a missed bar; it is in the result as well.
    measure.Run([sys.executable, os.path.join(scene_tools.folder(), 'check_city.py'), scene, out, '--json', found],
                accept=(0, 1))
    r = scene_tools.read_json(found)
    check = subprocess.run([os.path.join(bin_folder, 'tilemend'), 'check', scene, out, '-o', 'json'], check=False,
                           capture_output=True, text=True)
    if check.returncode not in (0, 100):  # 100 tells of a fault
        sys.exit(f'check: exit code {check.returncode}\n{check.stderr}')
    checked = json.loads(check.stdout)
    count = {name: finding['count'] for name, finding in checked['findings'].items()}
    points = len(np.load(os.path.join(scene, 'ground.npz'))['points'])
    return [level, seed, f'{points:,}', measure.down(r['covered'], 4), bare(scene, out), measure.down(r['overlap'], 4),
            measure.up(r['step 99 %, m'], 3) if 'step 99 %, m' in r else '-', measure.up(r['double'], 4), measure.up(r['error mean, m'], 2),
            measure.up(r['error 95 %, m'], 2), count['open_edges'], count['crossed_fills'] + count['crossed_surface'],
            checked['new_triangles']]


def tables(bin_folder, seeds):
    rows = []
    for level in LEVELS:
        for seed in seeds:
            with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
                rows.append(row(bin_folder, folder, level, seed))
            print(' | '.join(map(str, rows[-1])), file=sys.stderr, flush=True)
    return measure.table(HEADS, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--seeds', type=lambda t: [int(n) for n in t.split(',')], default=[91, 92, 93, 94, 95, 96])
    a = parser.parse_args()
    scene_tools.needed('street_bench.py')
    print(tables(a.bin, a.seeds))


if __name__ == '__main__':
    main()
