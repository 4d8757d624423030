#!/usr/bin/python3
"""Fills the same 40 made holes with each filler of `tilemend fill --filler` and prints what became of them.

    filler_bench.py [--bin DIR] [--only flat,tube] [--fillers auto,minimum-area] [--rims 10,400] [--json FILE] [--keep DIR]

Four kinds of surface, each with ten holes whose boundaries have 10 to 403 vertices: nearly flat ground, a curved surface, a sheet
folded by 90 degrees, the wall of a tube, of which large holes take nearly half. Meshes are triangles of side 1, each vertex off its
place; holes are blobs, larger with their boundary. An error is the mean distance from what was removed to the patch, over the
hole's radius. Quality is 2 * inradius / circumradius of the patch's triangles. Crossings are triangles that `tilemend check` finds.
Seconds and memory are those of the whole process;
a fill that takes more than 30 s is stopped and counts as not filled. Needs numpy and scipy.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from scipy.spatial import Delaunay, cKDTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import surfaces

FILLERS = ('auto', 'advancing-front-normal', 'advancing-front-curvature', 'advancing-front-poisson', 'svm-laplacian', 'minimum-area')
RIMS = (10, 16, 24, 36, 54, 80, 120, 180, 270, 400)
LIMIT = 30  # seconds; what takes longer counts as not filled
MARGIN = 9  # of the sheet around its hole, edges
NEAR = 12  # places of a patch whose triangles count as near


def flat(u, v, _):
    return np.stack([u, v, .02 * np.sin(1.7 * u) * np.cos(1.3 * v)], 1)


def curved(u, v, radius):
    return np.stack([u, v, .25 * radius * (np.cos(1.2 * u / radius) + np.sin(.9 * v / radius + .4))], 1)


def creased(u, v, _):
    return np.stack([u, v * np.sqrt(.5), -np.abs(v) * np.sqrt(.5)], 1)


def tube(u, v, radius):
    around = max(radius / 1.5, (1.3 * radius + MARGIN + 2) / 2.8)  # the sheet does not meet itself behind
    return np.stack([u, around * np.sin(v / around), around * np.cos(v / around)], 1)


def over(height):
    """A surface of that height, in radii of the hole, over u and v in radii."""
    return lambda u, v, radius: np.stack([u, v, radius * height(u / radius, v / radius)], 1)


FORTY = {'flat': flat, 'curved': curved, 'creased': creased, 'tube': tube}
# Curved in other ways, from even to most of it inside the hole; not among the forty.
CURVED = {'cylinder': over(lambda u, v: .15 * u ** 2), 'paraboloid': over(lambda u, v: .15 * (u ** 2 + v ** 2)),
          'sphere': over(lambda u, v: np.sqrt(np.maximum(12 - u ** 2 - v ** 2, 0))), 'wave': over(lambda u, v: .25 * (np.sin(1.2 * u) + np.sin(.9 * v))),
          'hills': over(lambda u, v: .25 * np.cos(1.2 * u + .5) * np.sin(.9 * v + .4)), 'bump': over(lambda u, v: .25 * np.exp(-(u ** 2 + v ** 2) / 1.5))}
KINDS = FORTY | CURVED | {'plane': over(lambda u, v: 0 * u)}


def sheet(reach, rng):
    """Points (n x 2) and triangles of a plane of that half width; lines v = 0 stay straight for folds."""
    rows = np.arange(-np.ceil(reach / .866), np.ceil(reach / .866) + 1)
    points = np.concatenate([np.stack([np.arange(-reach, reach + 1) + .5 * (k % 2), np.full(int(2 * reach + 1), .866 * k)], 1) for k in rows])
    shift = rng.uniform(-.18, .18, points.shape)
    shift[np.abs(points[:, 1]) < 1e-9, 1] = 0
    points = points + shift
    triangles = Delaunay(points).simplices
    a, b, c = (points[triangles[:, k]] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    triangles[turn < 0] = triangles[turn < 0][:, ::-1]
    longest = np.max([np.linalg.norm(points[triangles[:, k]] - points[triangles[:, k - 1]], axis=1) for k in range(3)], 0)
    return points, triangles[(np.abs(turn) > .1) & (longest < 2)]


def one_disc(triangles):
    """Whether triangles are one piece with one boundary that passes no vertex twice."""
    edges = surfaces.boundary(triangles)
    if len(np.unique(edges[:, 0])) != len(edges):
        return False
    used, again = np.unique(edges, return_inverse=True)
    return len(np.unique(surfaces.components(again.reshape(-1, 2), len(used)))) == 1


def make(kind, rim):
    """Points, triangles, which of them are removed, the radius of the hole: its boundary has about `rim` vertices."""
    best = None
    for attempt in range(12):
        rng = np.random.default_rng([list(KINDS).index(kind), rim, attempt])
        phase, radius = rng.uniform(0, 2 * np.pi, 3), rim / (2 * np.pi) * rng.uniform(.75, 1.05)
        flat_points, triangles = sheet(int(np.ceil(1.3 * radius + MARGIN)), rng)
        middle = flat_points[triangles].mean(1)
        angle = np.arctan2(middle[:, 1], middle[:, 0])
        wobble = 1 + .12 * np.sin(2 * angle + phase[0]) + .08 * np.sin(3 * angle + phase[1]) + .04 * np.sin(5 * angle + phase[2])
        removed = np.hypot(*middle.T) < radius * wobble
        if not removed.any() or not one_disc(triangles[removed]):
            continue
        off = abs(len(surfaces.boundary(triangles[removed])) - rim)
        if best is None or off < best[0]:
            best = off, (KINDS[kind](*flat_points.T, radius), triangles, removed, radius)
        if off <= .02 * rim:
            break
    return best[1]


def spread(corners, most):
    """Places over triangles, no further apart than `most`, and the triangle that each lies on."""
    cuts = np.maximum(1, np.ceil(np.linalg.norm(corners - np.roll(corners, 1, 1), axis=2).max(1) / most)).astype(int)
    places, owners = [], []
    for n in np.unique(cuts):
        i, j = (k.ravel() for k in np.meshgrid(np.arange(n + 1), np.arange(n + 1)))
        i, j = i[i + j <= n] / n, j[i + j <= n] / n
        weights = np.stack([1 - i - j, i, j], 1)
        chosen = np.flatnonzero(cuts == n)
        places.append(np.einsum('pk,tkx->tpx', weights, corners[chosen]).reshape(-1, 3))
        owners.append(np.repeat(chosen, len(weights)))
    return np.concatenate(places), np.concatenate(owners)


def to_segment(p, a, b):
    along = b - a
    share = np.einsum('nx,nx->n', p - a, along) / np.maximum(np.einsum('nx,nx->n', along, along), 1e-30)
    return np.linalg.norm(p - a - share.clip(0, 1)[:, None] * along, axis=1)


def to_triangle(p, corners):
    """The distance from each point (n x 3) to its triangle (n x 3 x 3)."""
    a, b, c = corners.transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    length = np.maximum(np.linalg.norm(normal, axis=1), 1e-30)
    inside = np.all([np.einsum('nx,nx->n', np.cross(t - s, p - s), normal) >= 0 for s, t in ((a, b), (b, c), (c, a))], 0)
    plane = np.abs(np.einsum('nx,nx->n', p - a, normal)) / length
    return np.where(inside, plane, np.min([to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)], 0))


def error(truth, patch, radius):
    """The mean distance from places of the truth to the patch, over the radius: to the nearest of the triangles that have a place near by."""
    places, owners = spread(patch, max(.1, radius / 60))
    points = spread(truth, .5)[0]
    near = owners[cKDTree(places).query(points, min(NEAR, len(places)))[1].reshape(len(points), -1)]
    return np.min([to_triangle(points, patch[near[:, k]]) for k in range(near.shape[1])], 0).mean() / radius


def quality(corners):
    a, b, c = (np.linalg.norm(corners[:, k] - corners[:, k - 1], axis=1) for k in range(3))
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    return 16 * area ** 2 / ((a + b + c) * a * b * c)


def crossings(program, path):
    text = subprocess.run([program, 'check', path, '-o', 'json'], capture_output=True, text=True, check=False).stdout
    return json.loads(text)['defects']['self_intersections']['count']


def patch_of(path, originals):
    points, triangles = surfaces.read_off(path)
    return points[triangles[originals:]]


def run(a, filler, kind, rim, made, folder, *flags):
    points, triangles, removed, radius = made
    path, out = (os.path.join(folder, f'{kind}_{rim}{end}.off') for end in ('', '_' + filler))
    surfaces.write_off(path, points, triangles[~removed])
    program = os.path.join(a.bin, 'tilemend')
    edges = len(surfaces.boundary(triangles[removed]))
    # What is left of a tube has no side: its outline counts as a hole, too.
    process = measure.Run(['timeout', str(LIMIT), program, 'fill', path, '--out', out, '--overwrite', '--filler', filler, '--largest-hole', str(edges), *flags],
                          accept=(0, 100, 124))
    patch = patch_of(out, (~removed).sum()) if process.code != 124 else ()
    result = {'filler': filler, 'kind': kind, 'rim': edges, 'filled': len(patch) > 0,
              'seconds': process.wall, 'peak': process.peak}
    if result['filled']:
        q = quality(patch)
        result |= {'error': float(error(points[triangles[removed]], patch, radius)), 'quality': float(q.mean()), 'least': float(q.min()),
                   'histogram': np.histogram(q, 20, (0, 1))[0].tolist(), 'triangles': len(patch), 'crossings': crossings(program, out)}
    return result


def of_hole(a, kind, rim, folder, *flags):
    """What became of one hole with each filler."""
    made = make(kind, rim)
    return [run(a, filler, kind, rim, made, folder, *flags) for filler in a.fillers]


def measured(a, folder):
    results = []
    for kind in a.only:
        for rim in a.rims:
            print(f'{kind}, {rim} edges', file=sys.stderr)
            results += of_hole(a, kind, rim, folder)
            if a.json:
                with open(a.json, 'w', encoding='utf-8') as file:
                    json.dump(results, file)
    return results


def mean_of(rows, key):
    return np.mean([r[key] for r in rows]) if rows else np.nan


def table(results):
    """A row by filler and kind; the last columns compare with the default on the holes that both filled."""
    rows = []
    errors = {(r['kind'], r['rim']): r['error'] for r in results if r['filler'] == 'auto' and r['filled']}
    for filler in dict.fromkeys(r['filler'] for r in results):
        for kind in [*dict.fromkeys(r['kind'] for r in results), 'all']:
            chosen = [r for r in results if r['filler'] == filler and kind in ('all', r['kind'])]
            good = [r for r in chosen if r['filled']]
            both = [(r['error'], errors[r['kind'], r['rim']]) for r in good if (r['kind'], r['rim']) in errors]
            better = sum(own < default for own, default in both) if filler != 'auto' else '–'
            mean = '–' if not both else f'{np.mean([d for _, d in both]):.5f}'
            rows.append([f'`{filler}`', kind, f'{len(good)}/{len(chosen)}', f'{mean_of(good, "error"):.5f}', mean, better,
                         f'{mean_of(good, "quality"):.3f}', sum(r['crossings'] for r in good), measure.up(sum(r['seconds'] for r in chosen), 2),
                         measure.megabytes(max(r['peak'] for r in chosen))])
    return measure.table(['', '', 'filled', 'mean error', "default's, same holes", 'better than default', 'mean quality', 'crossings', 's', 'peak, MB'], rows)


def words(text):
    return text.split(',')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--only', type=words, default=list(FORTY), help='of ' + ', '.join(KINDS))
    parser.add_argument('--fillers', type=words, default=list(FILLERS))
    parser.add_argument('--rims', type=lambda t: [int(r) for r in words(t)], default=list(RIMS))
    parser.add_argument('--json', default='')
    parser.add_argument('--keep', default='')
    return parser.parse_args()


def main():
    a = arguments()
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        if a.keep:
            os.makedirs(a.keep, exist_ok=True)
        results = measured(a, a.keep or folder)
    print(measure.machine())
    print(table(results))


if __name__ == '__main__':
    main()
