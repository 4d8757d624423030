#!/usr/bin/env python3
"""Fills meshes as they are, scaled and turned, and compares what became of each hole.

    mesh_turn_test.py TILEMEND HOLES

HOLES is a folder with meshes (.off, .ply, both also .gz), as `data/holes` of the tools that judge outputs. Without it the test is
skipped, and says so. Factors are powers of two, which round nothing, and powers of ten; directions are an exact quarter turn,
and one askew.
"""
import collections
import gzip
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
# Of the ways in which holes are filled: a few are at the edge between two, and coordinates are rounded. What is a hole, of
# which kind, and whether it is filled may not differ.
MOST_OTHERWISE = 0.01
ASKEW = ((0.36, 0.48, -0.8), (-0.8, 0.6, 0.0), (0.48, 0.64, 0.6))
QUARTER = ((0, 0, 1), (1, 0, 0), (0, 1, 0))
STRAIGHT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
WAYS = {'1/1024': (2 ** -10, STRAIGHT), '1024': (2 ** 10, STRAIGHT), '1/1000': (1e-3, STRAIGHT), '1000': (1e3, STRAIGHT),
        'quarter turn': (1, QUARTER), 'askew': (1, ASKEW)}


def read_mesh(path):
    """Points and faces of an OFF or a PLY text file."""
    with (gzip.open if path.endswith('.gz') else open)(path, 'rt') as file:
        text = file.read()
    if text.startswith('ply'):
        header, body = text.split('end_header\n')
        counts = [int(line.split()[2]) for line in header.splitlines() if line.startswith('element')]
        rows = [line.split() for line in body.splitlines()]
        return [row[:3] for row in rows[:counts[0]]], [row for row in rows[counts[0]:counts[0] + counts[1]]]
    words = ' '.join(line.split('#')[0] for line in text.splitlines()).split()
    vertices, faces = int(words[1]), int(words[2])
    points = [words[4 + 3 * k:7 + 3 * k] for k in range(vertices)]
    at, rows = 4 + 3 * vertices, []
    for _ in range(faces):
        rows.append(words[at:at + 1 + int(words[at])])
        at += len(rows[-1])
    return points, rows


def write_turned(points, faces, factor, turn, path):
    with open(path, 'w') as file:
        file.write(f'OFF\n{len(points)} {len(faces)} 0\n')
        for p in points:
            x = [factor * float(c) for c in p]
            if turn is not STRAIGHT:
                x = [sum(row[k] * x[k] for k in range(3)) for row in turn]
            file.write('%r %r %r\n' % tuple(x))
        file.writelines(' '.join(f) + '\n' for f in faces)


def outcomes(tilemend, path, folder):
    """Of each hole its edges, its kind, and the way it was filled or None; and the number of outlines."""
    run = subprocess.run([tilemend, 'fill', path, '--out', os.path.join(folder, 'filled.off'), '--overwrite', '-o', 'json'],
                         capture_output=True, text=True, check=False)
    if run.returncode not in (0, 100):
        sys.exit(f'{path}: {run.stderr}')
    report = json.loads(run.stdout)
    holes = [(h['boundary_vertices'], h['single'], h['outcome'], h.get('method')) for h in report['per_hole']]
    return holes, report['outer_rims']


def main():
    tilemend, data = sys.argv[1:]
    if not os.path.isdir(data):
        print(f'SKIPPED: there is no {data}')
        sys.exit(SKIPPED)
    faults, totals = [], collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'mesh.off')
        for name in sorted(n for n in os.listdir(data) if n.removesuffix('.gz').endswith(('.off', '.ply'))):
            points, faces = read_mesh(os.path.join(data, name))
            write_turned(points, faces, 1, STRAIGHT, path)
            plain, outlines = outcomes(tilemend, path, folder)
            for way, (factor, turn) in WAYS.items() if plain else ():
                write_turned(points, faces, factor, turn, path)
                holes, others = outcomes(tilemend, path, folder)
                totals[way] += len(plain)
                if len(holes) != len(plain) or others != outlines:
                    faults.append(f'{name}, {way}: {len(holes)} holes and {others} outlines, not {len(plain)} and {outlines}')
                    continue
                otherwise = [(a, b) for a, b in zip(plain, holes) if a != b]
                totals[way, 'otherwise'] += len(otherwise)
                for a, b in otherwise:
                    text = f'{name}, {way}: {a} becomes {b}'
                    print(text) if a[:3] == b[:3] else faults.append(text)
    for way in WAYS:
        most = MOST_OTHERWISE * totals[way]
        print(f'{way}: {totals[way, "otherwise"]} of {totals[way]} holes otherwise')
        if totals[way, 'otherwise'] > most:
            faults.append(f'{way}: {totals[way, "otherwise"]} of {totals[way]} holes otherwise, at most {most:.0f}')
    if not totals:
        faults.append(f'{data}: no mesh with holes')
    print('\n'.join(faults))
    sys.exit(bool(faults))


if __name__ == '__main__':
    main()
