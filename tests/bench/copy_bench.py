#!/usr/bin/python3
"""What `tilemend run` takes beside `cp -r` of the same tiles: CPU and wall seconds of both, `sync` included in the wall
seconds of the copy as a run syncs what it writes, and the most memory of the run.

    copy_bench.py [--bin DIR] [--scene FOLDER] [--cols 10] [--rows 10] [--spacing 0.36] [--workers 2] [--pairs 3]
                  [--folder DIR] [--most-cpu-ratio 0] [--most-megabytes 0]

The two take turns, and the one that begins changes from pair to pair. Without --scene a scene of 250 m cells is made, with
lakes, islands, a river and small holes. Exit code 1 if the median of the ratios, or the memory, is above what is given.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure


def fresh(path):
    """The path, with nothing there and nothing that waits to be written."""
    shutil.rmtree(path, ignore_errors=True)
    subprocess.run(['sync'], check=True)
    return path


def copy(scene, folder):
    out = fresh(os.path.join(folder, 'copy'))
    result = measure.Run(['sh', '-c', 'cp -r "$0" "$1" && sync', scene, out])
    shutil.rmtree(out)
    return result


def fill(client, scene, workers, folder):
    out = fresh(os.path.join(folder, 'out'))
    result = measure.Run([client, 'run', scene, '--out', out, '--workers', str(workers)], accept=(0, 100))
    shutil.rmtree(out)
    return result


def pairs(a, scene, folder):
    """(copy, run) for each pair; the first copy brings the scene into the page cache and does not count."""
    client = os.path.join(a.bin, 'tilemend')
    copy(scene, folder)
    for n in range(a.pairs):
        if n % 2 == 0:
            copied = copy(scene, folder)
            filled = fill(client, scene, a.workers, folder)
        else:
            filled = fill(client, scene, a.workers, folder)
            copied = copy(scene, folder)
        yield copied, filled


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--scene')
    parser.add_argument('--cols', type=int, default=10)
    parser.add_argument('--rows', type=int, default=10)
    parser.add_argument('--spacing', type=float, default=0.36)
    parser.add_argument('--workers', type=int, default=2)
    parser.add_argument('--pairs', type=int, default=3)
    parser.add_argument('--folder', help='where to write (default: the temporary folder)')
    parser.add_argument('--most-cpu-ratio', type=float, default=0)
    parser.add_argument('--most-megabytes', type=float, default=0)
    a = parser.parse_args()
    print(measure.machine(), flush=True)
    ratios, walls, rows = [], [], []
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-', dir=a.folder) as folder:
        scene = a.scene or os.path.join(folder, 'scene')
        if not a.scene:
            measure.make_scene(a.bin, scene, '--cols', a.cols, '--rows', a.rows, '--spacing', a.spacing)
        for copied, filled in pairs(a, scene, folder):
            ratios.append(filled.cpu / max(copied.cpu, 1e-3))
            walls.append(filled.wall / copied.wall)
            rows.append([measure.up(copied.cpu, 2), measure.up(filled.cpu, 2), measure.up(ratios[-1], 2),
                         measure.up(copied.wall, 2), measure.up(filled.wall, 2), measure.up(walls[-1], 2),
                         measure.megabytes(filled.peak), measure.up(os.getloadavg()[0], 1)])
            print(' '.join(rows[-1]), file=sys.stderr, flush=True)
    peak = max(float(row[6]) for row in rows)
    print(measure.table(['copy, CPU s', 'run, CPU s', 'ratio', 'copy, s', 'run, s', 'ratio', 'run, MB', 'load'], rows))
    print(f'median of the ratios: CPU {measure.median(ratios):.2f}, wall {measure.median(walls):.2f}; at most {peak:.0f} MB')
    too_much = (0 < a.most_cpu_ratio < measure.median(ratios)) or 0 < a.most_megabytes < peak
    return 1 if too_much else 0


if __name__ == '__main__':
    sys.exit(main())
