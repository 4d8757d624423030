#!/usr/bin/python3
"""Punches discs out of closed bodies of known shape, fills them with tilemend and with CGAL, and prints both side by side.

    punch_bench.py --peer-source cgal_fill.cpp [--bin DIR] [--seed 1] [--rounds 2] [--only torus,box] [--keep DIR]

Twelve bodies, from smooth ones to ones with sharp edges, thin parts, tubes and tips; discs of four sizes on each, more than 300
in all. An error is the mean distance from the patch (corners and middles of its triangles) to the body as it was, over the
disc's radius. Crossings are triangles that `tilemend check` finds, less those of the body before. Seconds are those of the CPU in
the whole process, of both: reading, filling and writing. Without CGAL (Debian: libcgal-dev) or its driver tilemend runs alone.
"""
import argparse
import collections
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import peer
import surfaces

RADII = (2, 3.5, 6, 10)  # mean edges
TRIES = 1000             # places tried on a body for discs of one size
MOST = 12                # discs of one size on a body
SAMPLES = 8              # along an edge of the body
NEAREST = 12             # samples of the body that are looked at for a distance


def sphere(level):
    """The unit sphere: an octahedron, cut `level` times."""
    points = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]], float)
    triangles = np.array([[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]])
    for _ in range(level):
        edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), 1)
        unique, at = np.unique(edges, axis=0, return_inverse=True)
        at = at.reshape(3, -1) + len(points)
        points = np.vstack([points, points[unique].mean(1)])
        (a, b, c), (d, e, f) = triangles.T, at
        triangles = np.concatenate([np.stack(t, 1) for t in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))])
    return points / np.linalg.norm(points, axis=1, keepdims=True), triangles


def tube(around, along, curve, radius):
    """A closed tube about a closed curve (parameter 0 to 2 pi)."""
    s = np.linspace(0, 2 * np.pi, along, endpoint=False)
    middle, ahead = curve(s), curve(s + 1e-4) - curve(s - 1e-4)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    side = np.cross(ahead, np.array([.13, .21, 1]))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, ahead)
    t = np.linspace(0, 2 * np.pi, around, endpoint=False)
    ring = np.cos(t)[None, :, None] * side[:, None] + np.sin(t)[None, :, None] * up[:, None]
    points = (middle[:, None] + radius * ring).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(around), np.arange(along))
    a, b = (j * around + i).ravel(), (j * around + (i + 1) % around).ravel()
    c, d = ((j + 1) % along * around + (i + 1) % around).ravel(), ((j + 1) % along * around + i).ravel()
    return points, np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)])


def ring(radius):
    return lambda s: np.stack([radius * np.cos(s), radius * np.sin(s), 0 * s], 1)


def knot(s):
    return np.stack([np.sin(s) + 2 * np.sin(2 * s), np.cos(s) - 2 * np.cos(2 * s), -np.sin(3 * s)], 1)


def shaped(shape, level=6):
    points, triangles = sphere(level)
    return shape(points), triangles


def box(sides, power=np.inf):
    """The sphere pushed out to a box: sharp for an infinite power, rounded for a finite one."""
    def shape(p):
        size = np.abs(p).max(1) if np.isinf(power) else (np.abs(p) ** power).sum(1) ** (1 / power)
        return p / size[:, None] * np.array(sides)
    return shape


def can(p):
    return p / np.maximum(np.hypot(p[:, 0], p[:, 1]), np.abs(p[:, 2]))[:, None] * [1, 1, 1.5]


def star(p):
    axes = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
    return p * (1 + 2 * np.exp(14 * ((p @ axes.T).max(1) - 1)))[:, None]


def bumps(p):
    return p * (1 + .12 * np.sin(5 * p[:, 0]) * np.cos(6 * p[:, 1]) + .08 * np.sin(9 * p[:, 2]))[:, None]


def drop(p):
    return np.stack([p[:, 0], p[:, 1], p[:, 2] + 1.2 * np.maximum(p[:, 2], 0) ** 4], 1) * \
        np.stack([1 - .75 * np.maximum(p[:, 2], 0)] * 2 + [np.ones(len(p))], 1)


BODIES = {  # name: (class, mesh)
    'sphere': ('smooth', lambda: sphere(6)),
    'ellipsoid': ('smooth', lambda: shaped(lambda p: p * [2, 1.2, .8])),
    'bumps': ('smooth', lambda: shaped(bumps)),
    'box': ('sharp', lambda: shaped(box([1, 1.3, .8]))),
    'can': ('sharp', lambda: shaped(can)),
    'round_box': ('sharp', lambda: shaped(box([1, 1, 1], 8))),
    'plate': ('thin', lambda: shaped(box([1.5, 1.5, .08], 8))),
    'lens': ('thin', lambda: shaped(lambda p: p * [1.5, 1.5, .15])),
    'torus': ('tubes', lambda: tube(40, 240, ring(3), .5)),
    'knot': ('tubes', lambda: tube(28, 480, knot, .35)),
    'star': ('tips', lambda: shaped(star)),
    'drop': ('tips', lambda: shaped(drop)),
}


def mean_edge(points, triangles):
    return np.linalg.norm(points[triangles[:, 0]] - points[triangles[:, 1]], axis=1).mean()


def is_disc(triangles):
    """Whether the triangles have one boundary loop that passes no vertex twice, and no handle."""
    edges = surfaces.boundary(triangles)
    if len(np.unique(edges[:, 0])) != len(edges):
        return False
    used, again = np.unique(edges, return_inverse=True)
    if len(np.unique(surfaces.components(again.reshape(-1, 2), len(used)))) != 1:
        return False
    vertices, all_edges = len(np.unique(triangles)), (3 * len(triangles) + len(edges)) // 2
    return vertices - all_edges + len(triangles) == 1


def punch(points, triangles, rng):
    """Which disc each triangle lies in (-1: none), and the discs' middles and radii."""
    edge, middles = mean_edge(points, triangles), points[triangles].mean(1)
    tree, of = cKDTree(middles), np.full(len(triangles), -1)
    blocked, discs = np.zeros(len(triangles), bool), []
    for radius in sorted(RADII, reverse=True):
        made = 0
        for place in rng.permutation(len(triangles))[:TRIES]:
            inside = np.array(tree.query_ball_point(middles[place], radius * edge))
            around = tree.query_ball_point(middles[place], (radius + 4) * edge)
            if made == MOST or len(inside) < 6 or blocked[around].any():
                continue
            number, again = np.unique(triangles[inside], return_inverse=True)
            again = again.reshape(-1, 3)
            group = surfaces.components(np.vstack([again[:, :2], again[:, 1:]]), len(number))[again[:, 0]]
            inside = inside[group == group[np.flatnonzero(inside == place)[0]]]
            if not is_disc(triangles[inside]):
                continue
            of[inside], blocked[around] = len(discs), True
            discs.append((middles[place], radius * edge))
            made += 1
    return of, discs


def samples(corners):
    """Points spread over triangles."""
    u, v = np.meshgrid(np.arange(SAMPLES + 1), np.arange(SAMPLES + 1))
    u, v = u[u + v <= SAMPLES] / SAMPLES, v[u + v <= SAMPLES] / SAMPLES
    weights = np.stack([1 - u - v, u, v], 1)
    return np.einsum('sk,tkd->tsd', weights, corners).reshape(-1, 3)


def distances(probes, corners):
    """Of each point from the nearest of the triangles, of which the twelve with samples nearest to it are looked at."""
    spread = samples(corners)
    near = cKDTree(spread).query(probes, k=NEAREST)[1] // (len(spread) // len(corners))
    a, b, c = (corners[near][:, :, k] for k in range(3))
    p = probes[:, None]

    def dot(u, v):
        return (u * v).sum(-1)

    def from_edge(q, r):
        along = np.clip(dot(p - q, r - q) / np.maximum(dot(r - q, r - q), 1e-300), 0, 1)
        return np.linalg.norm(p - q - along[..., None] * (r - q), axis=-1)

    normal = np.cross(b - a, c - a)
    square = np.maximum(dot(normal, normal), 1e-300)
    inside = np.logical_and.reduce([dot(np.cross(r - q, p - q), normal) >= 0 for q, r in ((a, b), (b, c), (c, a))])
    beside = np.minimum(np.minimum(from_edge(a, b), from_edge(b, c)), from_edge(c, a))
    return np.where(inside, np.minimum(beside, np.abs(dot(p - a, normal)) / np.sqrt(square)), beside).min(1)


def judge(points, triangles, of, discs, out):
    """For each disc the error of its patch; NaN where there is none."""
    new_points, new_triangles = surfaces.read_off(out)
    corners = new_points[new_triangles[(of < 0).sum():]]
    errors = np.full(len(discs), np.nan)
    if not len(corners):
        return errors
    centres = np.array([d[0] for d in discs])
    radii = np.array([d[1] for d in discs])
    patch, disc = surfaces.patches(corners), np.empty(len(corners), int)
    for p in np.unique(patch):
        disc[patch == p] = np.argmin(np.linalg.norm(centres - corners[patch == p].mean((0, 1)), axis=1) / radii)
    probes = np.concatenate([corners, corners.mean(1, keepdims=True)], 1)
    off = distances(probes.reshape(-1, 3), points[triangles]).reshape(-1, 4).mean(1)
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    for d in range(len(discs)):
        if (disc == d).any():
            errors[d] = np.average(off[disc == d], weights=area[disc == d] + 1e-300) / radii[d]
    return errors


def crossings(tilemend, path):
    text = subprocess.run([tilemend, 'check', path, '-o', 'json'], capture_output=True, text=True, check=False).stdout
    return json.loads(text)['defects']['self_intersections']['count']


Result = collections.namedtuple('Result', 'errors seconds crossings')


def fill_both(a, driver, name, seed, folder):
    """The discs' number and, by program, what came of them."""
    points, triangles = BODIES[name][1]()
    of, discs = punch(points, triangles, np.random.default_rng([seed, sorted(BODIES).index(name)]))
    whole, holed = os.path.join(folder, f'{name}.off'), os.path.join(folder, f'{name}_holed.off')
    surfaces.write_off(whole, points, triangles)
    surfaces.write_off(holed, points, triangles[of < 0])
    tilemend = os.path.join(a.bin, 'tilemend')
    before, results = crossings(tilemend, whole), {}
    ours, theirs = os.path.join(folder, f'{name}_ours.off'), os.path.join(folder, f'{name}_cgal.off')
    run = measure.Run([tilemend, 'fill', holed, '--out', ours, '--overwrite'], accept=(0, 100))
    results['tilemend'] = Result(judge(points, triangles, of, discs, ours), run.cpu, crossings(tilemend, ours) - before)
    if driver:
        run, _ = peer.fill(driver, 'dt', holed, theirs)
        results['CGAL'] = Result(judge(points, triangles, of, discs, theirs), run.cpu, crossings(tilemend, theirs) - before)
    return len(discs), results


def table(found):
    """Rows by class: discs, filled, crossings, median error, seconds; of both."""
    rows = []
    classes = list(dict.fromkeys(BODIES[name][0] for name in found))
    for group in [*classes, 'all', *found]:
        chosen = [r for n in found if group in ('all', n, BODIES[n][0]) for r in found[n]]
        row = [group, str(sum(discs for discs, _ in chosen))]
        for program in ('tilemend', 'CGAL'):
            results = [r[program] for _, r in chosen if program in r]
            if not results:
                row += ['–'] * 5
                continue
            errors = np.concatenate([r.errors for r in results])
            row += [str(np.isfinite(errors).sum()), str(sum(r.crossings for r in results)), f'{np.nanmedian(errors):.4f}',
                    f'{np.nanmax(errors):.3f}', f'{sum(r.seconds for r in results):.2f}']
        worse = sum(int((r['tilemend'].errors > 2 * r['CGAL'].errors + 1e-3).sum()) for _, r in chosen if 'CGAL' in r)
        rows.append([*row, str(worse)])
    heads = ['', 'discs', *(f'{p}{w}' for p in ('', 'CGAL, ') for w in ('filled', 'crossings', 'median error', 'worst', 's')),
             'above twice CGAL']
    return measure.table(heads, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--peer-source', default='')
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--rounds', type=int, default=2, help='how often each body is punched, at other places')
    parser.add_argument('--only', default=','.join(BODIES))
    parser.add_argument('--keep', default='')
    a = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        why = peer.missing(a.peer_source)
        if why:
            print(f'without CGAL: {why}', file=sys.stderr)
        driver = None if why else peer.build(a.peer_source, folder)
        place = a.keep or folder
        os.makedirs(place, exist_ok=True)
        seeds = range(a.seed, a.seed + a.rounds)
        print(table({name: [fill_both(a, driver, name, seed, place) for seed in seeds] for name in a.only.split(',')}))


if __name__ == '__main__':
    main()
