#!/usr/bin/python3
"""Fills meshes with one hole each with tilemend and with CGAL's hole filling, in turns, and prints both side by side.

    hole_bench.py --peers DIR [--bin DIR] [--build DIR] [--runs 3] [--only r1000,lake1000]

DIR holds cgal_fill.cpp (fills, refines and fairs; prints fill_s=SECONDS), eval.cpp (judges an output) and gen.py (makes the
meshes); they are not part of this project. Programs and meshes are made once, in the folder --build. Needs numpy, scipy, a compiler,
CGAL (Debian: libcgal-dev). A row is skipped with a message when its mesh cannot be made.

Seconds of tilemend are those of its whole process, start, reading and writing included; those of CGAL are its filling alone.
Memory is the peak of either process. The exponent is the slope of log seconds over log new vertices from r1000 to r30000.
"""
import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import peer as cgal

# Name of the mesh, what gen.py calls it, what eval calls its truth.
MESHES = (('r1000', '1000', 'terrain'), ('r3000', '3000', 'terrain'), ('r10000', '10000', 'terrain'),
          ('r30000', '30000b', 'terrain'), ('lake1000', 'lake', 'terrain'), ('bld300', 'bld', 'bld'),
          ('island400', 'island', 'terrain'))
GROWING = ('r1000', 'r3000', 'r10000', 'r30000')
BUILD = os.path.join(measure.ROOT, 'build', 'peers')
INCLUDES = ['-I/usr/include/eigen3']
DRIVERS = {'cgal_fill': ['-O3', '-DNDEBUG', '-DCGAL_EIGEN3_ENABLED', *INCLUDES], 'eval': ['-O2', *INCLUDES]}
HEADS = ['', 'new vertices', 'CGAL', 's', 'CGAL, s', 'ratio', 'filling, s', 'ratio', 'MB', 'CGAL, MB', 'ratio', 'mean error, m', 'CGAL, m',
         'least quality', 'mean', 'CGAL, least', 'mean', 'crossings', 'faces lost']


def missing(peers):
    """Why there is nothing to run, or None."""
    for name in ('cgal_fill.cpp', 'eval.cpp', 'gen.py'):
        if not os.path.exists(os.path.join(peers, name)):
            return f'{os.path.join(peers, name)}: no such file'
    return None if os.path.isdir('/usr/include/CGAL') else 'CGAL is not installed (Debian: libcgal-dev)'


def build_drivers(peers, build):
    os.makedirs(build, exist_ok=True)
    for name, flags in DRIVERS.items():
        source, program = os.path.join(peers, f'{name}.cpp'), os.path.join(build, name)
        if not os.path.exists(program) or os.path.getmtime(program) < os.path.getmtime(source):
            subprocess.run(['g++', '-std=c++17', *flags, source, '-o', program, '-lmpfr', '-lgmp'], check=True)


def make_mesh(peers, build, name, word):
    """The path of the mesh, or None."""
    path = os.path.join(build, 'meshes', f'{name}.off')
    if not os.path.exists(path):
        made = subprocess.run(['/usr/bin/python3', os.path.join(peers, 'gen.py'), word], cwd=build, check=False,
                              stdout=subprocess.DEVNULL)
        if made.returncode != 0 or not os.path.exists(path):
            print(f'SKIPPED {name}: gen.py {word} does not make it', file=sys.stderr)
            return None
    return path


class Best:
    """The best seconds and the largest memory of some runs."""

    def __init__(self):
        self.seconds, self.filling, self.peak = math.inf, math.inf, 0

    def add(self, seconds, peak):
        self.seconds, self.peak = min(self.seconds, seconds), max(self.peak, peak)


def fill(program, mesh, out, flags, best):
    run = measure.Run([program, 'fill', mesh, '--out', out, '--overwrite', *flags], accept=(0, 100))
    best.add(run.wall, run.peak)
    again = subprocess.run([program, 'fill', mesh, '--out', out, '--overwrite', '-o', 'json', *flags], check=False,
                           capture_output=True, text=True)
    best.filling = min(best.filling, json.loads(again.stdout)['seconds']['fill'])


def peer_fill(build, mesh, out, best):
    run, seconds = cgal.fill(os.path.join(build, 'cgal_fill'), 'cdt', mesh, out)
    best.add(seconds, run.peak)


def judge(build, mesh, out, kind):
    text = subprocess.run([os.path.join(build, 'eval'), mesh, out, kind], check=True, capture_output=True, text=True)
    return {k: float(v) for k, v in re.findall(r'(\S+)=(\S+)', text.stdout)}


def row(name, ours, theirs, judged, peer):
    def ratio(a, b):
        return measure.up(a / b, 3)

    def quality(j):
        return [measure.down(j['qmin'], 2), measure.down(j['qmean'], 3)]

    return [name, f'{judged["newv"]:,.0f}', f'{peer["newv"]:,.0f}', measure.up(ours.seconds, 3),
            measure.up(theirs.seconds, 3), ratio(ours.seconds, theirs.seconds),
            measure.up(ours.filling, 3), ratio(ours.filling, theirs.seconds), measure.megabytes(ours.peak),
            measure.megabytes(theirs.peak), ratio(ours.peak, theirs.peak), measure.up(judged['err_mean'], 4),
            measure.up(peer['err_mean'], 4), *quality(judged), *quality(peer), f'{judged["selfint"]:.0f}',
            f'{judged["lost_in_f"]:.0f}']


def exponent(points):
    """The slope of the least-squares line through the logarithms of (vertices, seconds)."""
    x, y = [math.log(n) for n, _ in points], [math.log(s) for _, s in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def tables(bin_folder, peers, build, runs, only=None):
    build_drivers(peers, build)
    program, rows, growth = os.path.join(bin_folder, 'tilemend'), [], {}
    for name, word, kind in MESHES:
        if only and name not in only:
            continue
        mesh = make_mesh(peers, build, name, word)
        if mesh is None:
            continue
        with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
            theirs, peer_out = Best(), os.path.join(folder, 'peer.off')
            modes = {flags: (Best(), os.path.join(folder, f'ours{flags}.off')) for flags in ('--uniform', '')}
            for _ in range(runs):
                peer_fill(build, mesh, peer_out, theirs)
                for flags, (ours, out) in modes.items():
                    fill(program, mesh, out, flags.split(), ours)
            peer = judge(build, mesh, peer_out, kind)
            for flags, (ours, out) in modes.items():
                judged = judge(build, mesh, out, kind)
                rows.append(row(f'{name} {flags}'.strip(), ours, theirs, judged, peer))
                if name in GROWING:
                    growth.setdefault(f'tilemend {flags}'.strip(), []).append((judged['newv'], ours.seconds))
            if name in GROWING:
                growth.setdefault('CGAL', []).append((peer['newv'], theirs.seconds))
    notes = [f'{name} {measure.up(exponent(points), 2)}' for name, points in growth.items() if len(points) > 2]
    table = measure.table(HEADS, rows)
    return f'{table}\n\nSeconds grow with the new vertices with the exponent: {", ".join(notes)}.' if notes else table


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--peers', required=True)
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--build', default=BUILD)
    parser.add_argument('--runs', type=int, default=3)
    parser.add_argument('--only', type=lambda t: t.split(','))
    a = parser.parse_args()
    reason = missing(a.peers)
    if reason:
        raise SystemExit(f'SKIPPED: {reason}')
    print(measure.machine())
    print(tables(a.bin, a.peers, a.build, a.runs, a.only))


if __name__ == '__main__':
    main()
