#!/usr/bin/python3
"""Fills the same scenes whole and cut into cells and prints how far the two surfaces lie apart.

    TILEMEND_SHARED_TOOLS=DIR partition_bench.py [--bin DIR] [--seeds 1,2] [--only NAME]

Made scenes are ragged, so that their triangles do not depend on the grid: 600 m as 36 cells of 100 m and as one cell.
Real scenes are one cell when all their tiles are welded into one. Both sides go through `tilemend run`; points that both
have filled are compared. DIR holds the scene tools, which are not part of this project. Needs numpy and scipy.
"""
import argparse
import json
import os
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import scene_tools
import surfaces

WHOLE, CUT = ('--cols', 1, '--rows', 1, '--cell', 600), ('--cols', 6, '--rows', 6, '--cell', 100)
LAKES = ('--holes', 'lakes,islands', '--lake-share', 0.2)
# In metres: centre, radii.
WIDE = ('--holes', 'none', '--ellipse', '300,300,250,220')
TWO = ('--holes', 'none', '--ellipse', '160,190,110,90', '--ellipse', '400,390,140,150')
GROUNDS = {**{f'Hurst {h}': ('--hurst', h) for h in (0.7, 1.0, 1.2)}, 'DEM': ('--dem', scene_tools.FAULT, '--relief', 100)}
MADE = {**{f'lakes with islands, {name}': (*ground, *LAKES) for name, ground in GROUNDS.items()},
        **{f'lake 5 cells wide, {name}': (*ground, *WIDE) for name, ground in GROUNDS.items()},
        'two lakes, Hurst 1.0': ('--hurst', 1.0, *TWO),
        'lake among houses, Hurst 1.0': ('--hurst', 1.0, *WIDE)}
HOUSES = {'lake among houses, Hurst 1.0': 288}
REAL = {'Mars crater, real cut': 'mars', 'DEM, real cut': 'dem'}
LEAST_POINTS = 20  # of a hole that is looked at on its own: the relief of fewer is no measure
HEADS = ['scene', 'seed', 'layers', 'points', 'relief, m', 'apart, m', 'of the hole', 'of the scene', 'worst hole',
         'error whole, m', 'error cut, m', 'cut / whole', 'tension whole, 1/km²', 'tension cut, 1/km²']


def fill_cells(bin_folder, scene, out):
    """The filled triangles' corners and the report."""
    report = scene_tools.fill(bin_folder, scene, out)
    return surfaces.filled(out), report


def as_one_cell(scene, out):
    """The scene with all its tiles welded into one, in one cell."""
    os.makedirs(out)
    description = scene_tools.read_json(os.path.join(scene, 'scene.json'))
    cell = np.broadcast_to(description['cell_size'], 2) * [description['cols'], description['rows']]
    description.update(cell_size=cell.tolist(), cols=1, rows=1, tiles=[{'col': 0, 'row': 0, 'path': 'tile.ply'}])
    with open(os.path.join(out, 'scene.json'), 'w', encoding='utf-8') as file:
        json.dump(description, file)
    surfaces.write_ply(os.path.join(out, 'tile.ply'), *surfaces.merged(scene))
    return out


def made(bin_folder, name, seed, folder):
    sides = []
    for side, grid in (('whole', WHOLE), ('cut', CUT)):
        scene = os.path.join(folder, side)
        houses_per_cell = HOUSES.get(name, 0) / (grid[1] * grid[3])
        scene_tools.run('make_scene.py', scene, *grid, '--cut', 'ragged', '--spacing', 2.5, '--seed', seed,
                        '--buildings', houses_per_cell, *MADE[name])
        sides.append(fill_cells(bin_folder, scene, scene + '-filled'))
    return *sides, surfaces.truth_of(os.path.join(folder, 'whole'))


def real(bin_folder, name, seed, folder):
    scene_tools.run('real_scenes.py', folder, '--cut', '--only', name, '--seed', seed)
    scene, whole = os.path.join(folder, name), os.path.join(folder, 'whole')
    as_one_cell(scene, whole)
    return (*(fill_cells(bin_folder, side, side + '-filled') for side in (whole, scene)), surfaces.truth_of(scene))


def percent(share):
    return measure.up(100 * share, 2) + ' %'


def row(name, seed, whole, cut, truth):
    triangle, z = surfaces.over(whole[0], truth)
    z_cut = surfaces.over(cut[0], truth)[1]
    both = ~np.isnan(z) & ~np.isnan(z_cut)
    hole = surfaces.patches(whole[0])[triangle]
    apart, error, error_cut = np.abs(z - z_cut), np.abs(z - truth[:, 2]), np.abs(z_cut - truth[:, 2])
    share, of_hole = np.zeros(len(truth)), []
    for h in np.unique(hole[both]):
        mine = both & (hole == h)
        relief = np.ptp(truth[mine, 2])
        share[mine] = apart[mine] / relief if relief > 0 else 0
        if mine.sum() >= LEAST_POINTS:
            of_hole.append(share[mine].mean())
    relief = np.ptp(truth[both, 2])
    return [name, seed, cut[1]['layers'], f'{both.sum():,}', measure.down(relief, 1), measure.up(apart[both].mean(), 4),
            percent(share[both].mean()), percent(apart[both].mean() / relief), percent(max(of_hole)),
            measure.up(error[both].mean(), 3), measure.up(error_cut[both].mean(), 3),
            measure.up(error_cut[both].mean() / error[both].mean(), 3), scene_tools.tensions(whole[1]),
            scene_tools.tensions(cut[1])]


def tables(bin_folder, seeds, only=None):
    rows = []
    for name in [*MADE, *REAL]:
        if only and only not in name:
            continue
        for seed in seeds:
            with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
                sides = (made(bin_folder, name, seed, folder) if name in MADE
                         else real(bin_folder, REAL[name], seed, folder))
                rows.append(row(name, seed, *sides))
                print(' | '.join(map(str, rows[-1])), file=sys.stderr, flush=True)
    return measure.table(HEADS, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--seeds', type=lambda t: [int(n) for n in t.split(',')], default=[1, 2])
    parser.add_argument('--only', help='scenes with this in their name')
    a = parser.parse_args()
    scene_tools.needed('partition_bench.py')
    print(tables(a.bin, a.seeds, a.only))


if __name__ == '__main__':
    main()
