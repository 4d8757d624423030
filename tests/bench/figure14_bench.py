#!/usr/bin/python3
"""Repeats the experiment of Wang et al. 2021, figure 14, on made terrain and prints the errors of the fill.

    TILEMEND_SHARED_TOOLS=DIR figure14_bench.py [--bin DIR] [--seeds 1,2,3,4,5] [--peer-source cgal_fill.cpp]

Four cells, a closed and an unclosed hole that the grid divides into four open holes of type I and two of type II, about
76,000 m2 together, 2 m of relief. The closed one is filled by the peer as well, on all tiles welded into one mesh; the unclosed
one, which opens to the mesh's outline, it cannot fill. DIR holds the scene tools and --peer-source names the peer's driver; neither
is part of this project. They need numpy and scipy, the driver CGAL (Debian: libcgal-dev).
"""
import argparse
import json
import os
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import peer
import scene_tools
import surfaces

# In cells of 250 m: [centre x, centre y, radius x, radius y]. The second disc reaches over the rim of the area.
CELL = 250
LAYOUT = {'cols': 2, 'rows': 2, 'closed': 0, 'relief': 2.45,
          'holes': [{'kind': 'disc', 'at': [0.98, 0.8, 0.5, 0.52]}, {'kind': 'disc', 'at': [1.0, 2.0, 0.62, 0.42]}]}
BETWEEN = 1.45 * CELL  # a line of constant y between the two
HEADS = ['seed', '', 'relief, m', 'points', 'mean, m', 'max, m', 'std, m', 'closed: mean, m', 'max, m',
         'unclosed: mean, m', 'max, m', 'promises']


def figures(errors):
    """Mean |error| and largest |error|, where there is a fill."""
    errors = errors[~np.isnan(errors)]
    return [measure.up(errors.mean(), 3), measure.up(errors.max(), 2)] if len(errors) else ['–', 'not filled']


def parts(corners, truth):
    e, closed = surfaces.errors(corners, truth), truth[:, 1] < BETWEEN
    return [*figures(e[closed]), *figures(e[~closed])]


def our_row(bin_folder, seed, scene, surface, truth):
    out = f'{scene}-{surface}'
    scene_tools.fill(bin_folder, scene, out, '--surface', surface)
    checked = scene_tools.check(scene, out)
    return [seed, f'`{surface}`', measure.down(checked['relief of the removed surface, m'], 2), f"{checked['truth points']:,}",
            *(measure.up(checked[f'error {k}, m'], 3) for k in ('mean', 'max', 'std')), *parts(surfaces.filled(out), truth),
            scene_tools.promises(checked)]


def peer_row(driver, seed, scene, truth):
    mesh, out = f'{scene}.off', f'{scene}-peer.off'
    points, originals = surfaces.close_rim(*surfaces.merged(scene))
    surfaces.write_off(mesh, points, originals)
    peer.fill(driver, 'cdt', mesh, out)
    points, triangles = surfaces.read_off(out)
    return [seed, 'CGAL, one mesh', '', '', '', '', '', *parts(points[triangles[len(originals):]], truth), '']


def tables(bin_folder, seeds, peer_source=None):
    rows = [['Wang 2021', '', '2.02', '34', '', '', '', '0.10', '0.23', '', '', '']]
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        layout = os.path.join(folder, 'layout.json')
        with open(layout, 'w', encoding='utf-8') as file:
            json.dump(LAYOUT, file)
        driver = peer.build(peer_source, folder) if peer_source else None
        for seed in seeds:
            scene = os.path.join(folder, f'scene{seed}')
            scene_tools.run('make_table_scene.py', scene, layout, '--spacing', 1, '--seed', seed)
            truth = surfaces.truth_of(scene)
            rows += [our_row(bin_folder, seed, scene, surface, truth) for surface in ('wang', 'thin-plate')]
            if driver:
                rows.append(peer_row(driver, seed, scene, truth))
            print('\n'.join(' | '.join(map(str, r)) for r in rows[-3:]), file=sys.stderr, flush=True)
    return measure.table(HEADS, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--seeds', type=lambda t: [int(n) for n in t.split(',')], default=[1, 2, 3, 4, 5])
    parser.add_argument('--peer-source')
    a = parser.parse_args()
    scene_tools.needed('figure14_bench.py')
    print(tables(a.bin, a.seeds, a.peer_source))


if __name__ == '__main__':
    main()
