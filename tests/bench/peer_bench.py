#!/usr/bin/python3
"""Fills the same holes with tilemend and with CGAL's hole filling (refined and faired) and prints time, memory and error.

    peer_bench.py --peer-source cgal_fill.cpp [--bin DIR] [--runs 3]

The scene has 24 cells, five lakes over several cells, no islands and no holes at the rim: the peer takes every
boundary loop for a hole. It gets all tiles as one welded mesh, an OFF file whose outer rim is closed by a cone. tilemend
gets the same file (`fill`), and the tiles (`run`). Errors are taken at every vertex that the holes took from the made
surface. The peer's driver (peer.py) is compiled here and is not part of this project. Needs numpy, scipy, a compiler, and
CGAL (Debian: libcgal-dev).
"""
import argparse
import os
import shutil
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import peer
import surfaces

LAKES = ('350,300,180,120', '900,250,200,140', '1250,650,130,200', '700,700,160,150', '250,750,120,140')


def row(name, runs, corners, truth, filling='–'):
    e = surfaces.errors(corners, truth)
    missing = int(np.isnan(e).sum())
    if missing:
        print(f'{name}: {missing} of {len(truth)} points of the truth are not covered', file=sys.stderr)
    best = min(runs, key=lambda r: r.wall)
    return [name, measure.up(best.wall, 2), filling, measure.megabytes(max(r.peak for r in runs)), f'{len(corners):,}',
            measure.up(np.nanmean(e), 3), measure.up(np.nanmax(e), 2), f'{missing}/{len(truth)}']


HEADS = ['', 'process, s', 'filling alone, s', 'peak, MB', 'new triangles', 'mean error, m', 'max error, m', 'points not covered']


def peer_row(driver, mode, mesh, originals, truth, runs, folder):
    out = os.path.join(folder, 'peer.off')
    results, seconds = zip(*(peer.fill(driver, mode, mesh, out) for _ in range(runs)))
    points, triangles = surfaces.read_off(out)
    return row(f'CGAL, one mesh, `{mode}`', results, points[triangles[originals:]], truth, measure.up(min(seconds), 2))


def our_rows(bin_folder, scene, mesh, originals, truth, runs, folder):
    program, rows = os.path.join(bin_folder, 'tilemend'), []
    for flags in ([], ['--uniform']):
        out = os.path.join(folder, 'ours.off')
        results = [measure.Run([program, 'fill', mesh, '--out', out, '--overwrite', *flags]) for _ in range(runs)]
        points, triangles = surfaces.read_off(out)
        rows.append(row(' '.join(['`tilemend fill`, one mesh', *flags]), results, points[triangles[originals:]], truth))
    for workers, flags in ((1, []), (2, []), (2, ['--uniform'])):
        results = []
        for _ in range(runs):
            out = os.path.join(folder, 'ours')
            shutil.rmtree(out, ignore_errors=True)
            results.append(measure.Run([program, 'run', scene, '--out', out, '--workers', str(workers), *flags]))
        name = f'`tilemend run`, 24 tiles, --workers {workers}'
        rows.append(row(' '.join([name, *flags]), results, surfaces.filled(out), truth))
    return rows


def tables(bin_folder, source, runs):
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        driver = peer.build(source, folder)
        scene, mesh = os.path.join(folder, 'scene'), os.path.join(folder, 'mesh.off')
        lakes = [word for lake in LAKES for word in ('--ellipse', lake)]
        measure.make_scene(bin_folder, scene, '--cols', 6, '--rows', 4, '--spacing', 2.5, '--holes', 'none', *lakes)
        truth = np.loadtxt(os.path.join(scene, 'truth.csv'), delimiter=',', skiprows=1)
        points, triangles = surfaces.close_rim(*surfaces.merged(scene))
        surfaces.write_off(mesh, points, triangles)
        rows = [peer_row(driver, mode, mesh, len(triangles), truth, runs, folder) for mode in ('cdt', 'dt')]
        return measure.table(HEADS, rows + our_rows(bin_folder, scene, mesh, len(triangles), truth, runs, folder))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--peer-source', required=True)
    parser.add_argument('--runs', type=int, default=3)
    a = parser.parse_args()
    print(measure.machine())
    print(tables(a.bin, a.peer_source, a.runs))


if __name__ == '__main__':
    main()
