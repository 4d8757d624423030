#!/usr/bin/env python3
"""The pixels of scripts/render.py beside those of a search over all triangles: render_test.py ROOT"""
import importlib.util
import os
import subprocess
import sys
import tempfile

import numpy as np

PATH = os.path.join(sys.argv[1], 'scripts', 'render.py')


def render():
    spec = importlib.util.spec_from_file_location('render', PATH)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def by_search(corners, box, shape):
    """The topmost triangle at each pixel's centre."""
    height, width = shape
    owners = np.full(shape, -1)
    for row in range(height):
        for column in range(width):
            at = box[:2] + (np.array([column, row]) + 0.5) * (box[2:] - box[:2]) / [width, height]
            best = -np.inf
            for number, (a, b, c) in enumerate(corners):
                edges = np.array([b[:2] - a[:2], c[:2] - a[:2]]).T
                if np.linalg.det(edges) == 0:
                    continue
                u, v = np.linalg.solve(edges, at - a[:2])
                z = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])
                if min(u, v, 1 - u - v) >= 0 and z > best:
                    owners[row, column], best = number, z
    return owners[::-1]


def main():
    module, rng = render(), np.random.default_rng(3)
    box, shape = np.array([0., 0., 8., 6.]), (18, 24)
    for count, size in ((40, 12), (200, 2), (1, 30)):
        corners = rng.random((count, 3, 3)) * size - [size / 4, size / 4, 0]
        corners[0, 2] = corners[0, 1]  # without area
        found, expected = module.rasterise(corners, box, shape), by_search(corners, box, shape)
        if not np.array_equal(found, expected):
            raise SystemExit(f'FAILED: {count} triangles: {np.count_nonzero(found != expected)} pixels differ')
    if (module.rasterise(np.zeros((0, 3, 3)), box, shape) != -1).any():
        raise SystemExit('FAILED: nothing is drawn as something')
    with tempfile.TemporaryDirectory() as folder:
        open(os.path.join(folder, 'Tile.osgb'), 'w').close()
        told = subprocess.run([sys.executable, PATH, folder, folder, os.path.join(folder, 'a.png')], stderr=subprocess.PIPE, text=True)
        if told.returncode != 4 or '.osgb files, and only .ply and .obj are drawn' not in told.stderr:
            raise SystemExit(f'FAILED: a scene of other tiles: {told.returncode} {told.stderr}')
    print('the same pixels')


if __name__ == '__main__':
    main()
