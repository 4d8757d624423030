#!/usr/bin/python3
"""Times `tilemend run` on whole scenes: wall and CPU seconds, peak resident memory, seconds of each stage.

    scene_bench.py [--bin DIR] [--scene FOLDER] [--cells 6,24,96,384] [--workers 1,2,4] [--runs 5]

Scenes are made by tilemend-make-scene (250 m cells, a vertex every 2.5 m, lakes with islands, a river and small holes), or
--scene names one. Each run writes to a new folder; wall time is that of the whole process, writing and syncing included.
"""
import argparse
import json
import os
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure

STAGES = ('survey', 'plan', 'sample', 'fill', 'assemble')
GRIDS = {1: (1, 1), 6: (3, 2), 24: (6, 4), 96: (12, 8), 384: (24, 16)}
HOLES = ('--spacing', 2.5, '--holes', 'lakes,islands,river,small')


def bench(bin_folder, scene, workers, runs, folder):
    """The runs of one scene with one number of workers, the fastest first, and the report of that one."""
    results = []
    for _ in range(runs):
        out = os.path.join(folder, 'out')
        shutil.rmtree(out, ignore_errors=True)
        run = measure.Run([os.path.join(bin_folder, 'tilemend'), 'run', scene, '--out', out, '--workers', str(workers)],
                          accept=(0, 100))
        with open(os.path.join(out, 'report.json'), encoding='utf-8') as file:
            results.append((run, json.load(file)))
    shutil.rmtree(os.path.join(folder, 'out'), ignore_errors=True)
    results.sort(key=lambda r: r[0].wall)
    return [r[0] for r in results], results[0][1]


def count(holes):
    return holes['closed'] + sum(holes['I'].values()) + sum(holes['II'].values())


def triangles_of(scene):
    """From the headers of the tiles."""
    with open(os.path.join(scene, 'scene.json'), encoding='utf-8') as file:
        paths = [t['path'] for t in json.load(file)['tiles'] if t['path']]
    total = 0
    for path in paths:
        with open(os.path.join(scene, path), 'rb') as file:
            for line in file.read(4096).split(b'\n'):
                if line.startswith(b'element face'):
                    total += int(line.split()[2])
    return total


def row(scene, workers, runs, report):
    peak = max(r.peak for r in runs)
    stages = [measure.up(report['seconds'][s], 3) for s in STAGES]
    holes = f"{count(report['filled'])}/{count(report['holes'])}"
    return [report['cells'], f'{triangles_of(scene):,}', holes, workers, measure.up(runs[0].wall, 2),
            measure.up(measure.median([r.wall for r in runs]), 2), measure.up(runs[0].cpu, 2), measure.megabytes(peak), *stages]


HEADS = ['cells', 'triangles', 'holes filled', 'workers', 'best, s', 'median, s', 'CPU, s', 'peak, MB',
         *(f'{s}, s' for s in STAGES)]


def tables(bin_folder, cells, workers, runs, scene=None):
    rows = []
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        scenes = [scene] if scene else []
        for n in [] if scene else cells:
            path = os.path.join(folder, f'scene{n}')
            cols, grid_rows = GRIDS[n]
            measure.make_scene(bin_folder, path, '--cols', cols, '--rows', grid_rows, *HOLES)
            scenes.append(path)
        for path in scenes:
            for w in workers:
                rows.append(row(path, w, *bench(bin_folder, path, w, runs, folder)))
                print(' '.join(map(str, rows[-1])), file=sys.stderr, flush=True)
    return measure.table(HEADS, rows)


def big_tile(bin_folder, runs):
    """One cell of a million triangles with one worker: the survey as the whole program does it."""
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        scene = os.path.join(folder, 'scene')
        measure.make_scene(bin_folder, scene, '--cols', 1, '--rows', 1, '--spacing', 0.35355339, '--holes', 'small',
                           '--small-per-cell', 10)
        return measure.table(HEADS, [row(scene, 1, *bench(bin_folder, scene, 1, runs, folder))])


def numbers(text):
    return [int(n) for n in text.split(',')]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--scene')
    parser.add_argument('--cells', type=numbers, default=[6, 24, 96, 384])
    parser.add_argument('--workers', type=numbers, default=[1, 2, 4])
    parser.add_argument('--runs', type=int, default=5)
    a = parser.parse_args()
    unknown = [n for n in a.cells if n not in GRIDS]
    if unknown:
        parser.error(f'--cells: one of {", ".join(map(str, GRIDS))}')
    print(measure.machine())
    print(tables(a.bin, a.cells, a.workers, a.runs, a.scene))


if __name__ == '__main__':
    main()
