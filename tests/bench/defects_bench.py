#!/usr/bin/python3
"""Fills meshes and compares the faults that `tilemend check` finds around their holes before and after.

    defects_bench.py MESH... [--bin DIR]

Before: in the triangles that touch a rim that was filled. After: in these and the patches. Exit code 1 if some kind of fault
has become more, 2 if there is no mesh to look at. Meshes are OFF files, also with .gz behind; others
are passed over, and named.
"""
import argparse
import gzip
import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import surfaces

KINDS = ('nonmanifold_edges', 'nonmanifold_vertices', 'turned_edges', 'self_intersections', 'creased_edges', 'spikes',
         'duplicate_triangles', 'flat_triangles')


def checked(tilemend, path):
    """What `check` counts, by kind of fault."""
    run = subprocess.run([tilemend, 'check', path, '-o', 'json'], capture_output=True, text=True, check=False)
    if run.returncode not in (0, 100):
        raise SystemExit(run.stderr)
    defects = json.loads(run.stdout)['defects']
    return {kind: defects[kind]['count'] for kind in KINDS}


def around_patches(points, triangles, originals):
    """The original triangles that touch a new one, and those with the new ones."""
    places, again = np.unique(points, axis=0, return_inverse=True)
    welded = again.reshape(-1)[triangles]
    touched = np.zeros(len(places), bool)
    touched[welded[originals:]] = True
    ring = np.flatnonzero(touched[welded[:originals]].any(1))
    return triangles[ring], triangles[np.concatenate([ring, np.arange(originals, len(triangles))])]


def compare(tilemend, mesh, folder):
    """A row of counts before and after, or None if nothing was filled; and whether none has become more."""
    name = os.path.basename(mesh).removesuffix('.gz')
    source, filled = os.path.join(folder, name), os.path.join(folder, f'filled_{name}')
    with (gzip.open if mesh.endswith('.gz') else open)(mesh, 'rb') as packed, open(source, 'wb') as plain:
        shutil.copyfileobj(packed, plain)
    run = subprocess.run([tilemend, 'fill', source, '--out', filled, '--overwrite'], capture_output=True, text=True, check=False)
    if run.returncode not in (0, 100):
        return [name, run.stderr.strip()[:60]], False
    (points, before), (new_points, after) = surfaces.read_off(source), surfaces.read_off(filled)
    if len(after) == len(before):
        return None, True
    counts = []
    for part, chosen in zip(('before', 'after'), around_patches(new_points, after, len(before))):
        path = os.path.join(folder, f'{part}.off')
        surfaces.write_off(path, new_points, chosen)
        counts.append(checked(tilemend, path))
    more = [kind for kind in KINDS if counts[1][kind] > counts[0][kind]]
    return [name, str(len(after) - len(before)), *(f'{counts[0][k]} → {counts[1][k]}' for k in KINDS), ', '.join(more)], not more


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('meshes', nargs='*')
    parser.add_argument('--bin', default=measure.BIN)
    a = parser.parse_args()
    meshes = [m for m in a.meshes if m.endswith(('.off', '.off.gz')) and os.path.isfile(m)]
    for other in sorted(set(a.meshes) - set(meshes)):
        print(f'defects_bench: passed over, not an OFF file: {other}', file=sys.stderr)
    if not meshes:
        print('defects_bench: no meshes to look at', file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        found = [compare(os.path.join(a.bin, 'tilemend'), mesh, folder) for mesh in sorted(meshes)]
    heads = ['', 'new triangles', *(k.replace('_', ' ') for k in KINDS), 'more']
    print(measure.table(heads, [row + [''] * (len(heads) - len(row)) for row, _ in found if row]))
    return 0 if all(good for _, good in found) else 1


if __name__ == '__main__':
    sys.exit(main())
