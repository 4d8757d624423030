#!/usr/bin/python3
"""Fills the same holes with tilemend and with CGAL's hole filling (refined and faired) and prints time, memory and error.

    peer_bench.py --peer-source cgal_fill.cpp [--bin DIR] [--runs 3]

The scene has 24 cells, five lakes over several cells, no islands and no holes at the rim: the peer takes every
boundary loop for a hole. It gets all tiles as one welded mesh, an OFF file whose outer rim is closed by a cone. tilemend
gets the same file (`fill`), and the tiles (`run`). Errors are taken at every vertex that the holes took from the made
surface. The peer's driver reads IN.off, writes OUT.off, takes a mode (cdt, dt) and prints fill_s=SECONDS; it is compiled here and
is not part of this project. Needs numpy, a compiler, and CGAL (Debian: libcgal-dev).
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure

sys.path.insert(0, os.path.join(measure.ROOT, 'scripts'))
import render

LAKES = ('350,300,180,120', '900,250,200,140', '1250,650,130,200', '700,700,160,150', '250,750,120,140')
COMPILE = ['g++', '-std=c++17', '-O3', '-DNDEBUG', '-DCGAL_EIGEN3_ENABLED', '-I/usr/include/eigen3']


def merged(scene):
    """All tiles as one mesh, equal positions welded."""
    corners, _ = render.read_folder(scene)
    points, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return points, index.reshape(-1, 3)


def close_rim(points, triangles):
    """Adds an apex far below and a cone from it to the longest boundary loop's box: the outer rim."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    n = len(points)
    key, back = edges[:, 0] * n + edges[:, 1], edges[:, 1] * n + edges[:, 0]
    alone = edges[~np.isin(key, back)]
    lo, hi = points[:, :2].min(0), points[:, :2].max(0)
    xy = points[:, :2]
    on_rim = ((np.abs(xy - lo) < 1e-3) | (np.abs(xy - hi) < 1e-3)).any(1)
    rim = alone[on_rim[alone[:, 0]] & on_rim[alone[:, 1]]]
    apex = np.append((lo + hi) / 2, points[:, 2].min() - (hi - lo).max())
    cone = np.column_stack([rim[:, 1], rim[:, 0], np.full(len(rim), n)])
    return np.vstack([points, apex]), np.vstack([triangles, cone])


def write_off(path, points, triangles):
    with open(path, 'w', encoding='ascii') as file:
        file.write(f'OFF\n{len(points)} {len(triangles)} 0\n')
        np.savetxt(file, points, '%.9g')
        np.savetxt(file, np.column_stack([np.full(len(triangles), 3), triangles]), '%d')


def read_off(path):
    with open(path, encoding='ascii') as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], float).reshape(-1, 3)
    return points, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], int).reshape(-1, 4)[:, 1:]


def errors(corners, truth):
    """|height of the fill - height of the truth| at each point of the truth; NaN where there is no fill."""
    result, order = np.full(len(truth), np.nan), np.argsort(truth[:, 0])
    x = truth[order, 0]
    for a, b, c in corners:
        xs, ys = (a[0], b[0], c[0]), (a[1], b[1], c[1])
        near = order[np.searchsorted(x, min(xs) - 1e-6):np.searchsorted(x, max(xs) + 1e-6)]
        near = near[(truth[near, 1] >= min(ys) - 1e-6) & (truth[near, 1] <= max(ys) + 1e-6)]
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        if not len(near) or area == 0:
            continue
        p = truth[near]
        u = ((p[:, 0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (p[:, 1] - a[1])) / area
        v = ((b[0] - a[0]) * (p[:, 1] - a[1]) - (p[:, 0] - a[0]) * (b[1] - a[1])) / area
        inside = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9)
        height = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])
        result[near[inside]] = np.abs(height - p[:, 2])[inside]
    return result


def row(name, runs, corners, truth, filling='–'):
    e = errors(corners, truth)
    missing = int(np.isnan(e).sum())
    if missing:
        print(f'{name}: {missing} of {len(truth)} points of the truth are not covered', file=sys.stderr)
    best = min(runs, key=lambda r: r.wall)
    return [name, measure.up(best.wall, 2), filling, measure.megabytes(max(r.peak for r in runs)), f'{len(corners):,}',
            measure.up(np.nanmean(e), 3), measure.up(np.nanmax(e), 2), f'{missing}/{len(truth)}']


HEADS = ['', 'process, s', 'filling alone, s', 'peak, MB', 'new triangles', 'mean error, m', 'max error, m', 'points not covered']


def peer_row(driver, mode, mesh, originals, truth, runs, folder):
    out, text, results = os.path.join(folder, 'peer.off'), [], []
    for _ in range(runs):
        log = os.path.join(folder, 'peer.log')
        results.append(measure.Run(['sh', '-c', f'exec "$0" "$1" "$2" {mode} >"$3"', driver, mesh, out, log]))
        with open(log, encoding='utf-8') as file:
            text.append(float(re.search(r'fill_s=([0-9.]+)', file.read()).group(1)))
    points, triangles = read_off(out)
    return row(f'CGAL, one mesh, `{mode}`', results, points[triangles[originals:]], truth, measure.up(min(text), 2))


def our_rows(bin_folder, scene, mesh, originals, truth, runs, folder):
    program, rows = os.path.join(bin_folder, 'tilemend'), []
    for flags in ([], ['--uniform']):
        out = os.path.join(folder, 'ours.off')
        results = [measure.Run([program, 'fill', mesh, '--out', out, '--overwrite', *flags]) for _ in range(runs)]
        points, triangles = read_off(out)
        rows.append(row(' '.join(['`tilemend fill`, one mesh', *flags]), results, points[triangles[originals:]], truth))
    for workers, flags in ((1, []), (2, []), (2, ['--uniform'])):
        results = []
        for _ in range(runs):
            out = os.path.join(folder, 'ours')
            shutil.rmtree(out, ignore_errors=True)
            results.append(measure.Run([program, 'run', scene, '--out', out, '--workers', str(workers), *flags]))
        corners, marks = render.read_folder(out)
        name = f'`tilemend run`, 24 tiles, --workers {workers}'
        rows.append(row(' '.join([name, *flags]), results, corners[marks], truth))
    return rows


def tables(bin_folder, source, runs):
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        driver = os.path.join(folder, 'peer')
        subprocess.run([*COMPILE, source, '-o', driver, '-lmpfr', '-lgmp'], check=True)
        scene, mesh = os.path.join(folder, 'scene'), os.path.join(folder, 'mesh.off')
        lakes = [word for lake in LAKES for word in ('--ellipse', lake)]
        measure.make_scene(bin_folder, scene, '--cols', 6, '--rows', 4, '--spacing', 2.5, '--holes', 'none', *lakes)
        truth = np.loadtxt(os.path.join(scene, 'truth.csv'), delimiter=',', skiprows=1)
        points, triangles = close_rim(*merged(scene))
        write_off(mesh, points, triangles)
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
