#!/usr/bin/env python3
"""Cancels a job, and stops a worker, while a worker computes the fill of one large hole, which takes minutes.

    cancel_test.py BIN [--vertices 60000] [--waits 2 15] [--most-seconds 20]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. The hole has a rim of `vertices`
vertices. It is filled by a coordinator and two workers. `waits` seconds after the fill began, the job is cancelled.
Within `most-seconds` no worker may hold a task, compute, or have much more memory than before. The cluster must do
another job then. At last the worker that fills gets SIGINT twice and must end as soon. Prints how long each took. Exit
code 1 if anything was not so.
"""
import argparse
import json
import math
import os
import random
import signal
import struct
import subprocess
import sys
import time

from cluster_harness import await_, require, run_attack

TICKS = os.sysconf('SC_CLK_TCK')
HEADER = '''ply
format binary_little_endian 1.0
element vertex {}
property double x
property double y
property double z
element face {}
property list uchar int vertex_indices
end_header
'''


def write_scene(folder, vertices):
    """One tile with a round hole of that many vertices at the rim, 0.4 m apart, in hills with noise."""
    noise = random.Random(1)
    radius = vertices * 0.4 / (2 * math.pi)
    half = radius + 20
    points, faces = [], []
    for ring in range(4):
        for i in range(vertices):
            x, y = math.cos(2 * math.pi * i / vertices), math.sin(2 * math.pi * i / vertices)
            distance = half / max(abs(x), abs(y)) if ring == 3 else radius + 0.4 * ring
            x, y = half + distance * x, half + distance * y
            points.append((x, y, 3 * math.sin(x / 30) + 2 * math.cos(y / 20) + 0.2 * noise.random()))
    for a in range(3 * vertices):
        b = a + 1 if (a + 1) % vertices else a + 1 - vertices
        faces += [(a, a + vertices, b + vertices), (a, b + vertices, b)]
    os.makedirs(folder)
    with open(os.path.join(folder, 'tile.ply'), 'wb') as file:
        file.write(HEADER.format(len(points), len(faces)).encode())
        file.writelines(struct.pack('<3d', *point) for point in points)
        file.writelines(struct.pack('<B3i', 3, *face) for face in faces)
    with open(os.path.join(folder, 'scene.json'), 'w', encoding='utf-8') as file:
        json.dump({'origin': [0, 0, 0], 'grid_corner': [0, 0], 'cell_size': 2 * half, 'cols': 1, 'rows': 1,
                   'tiles': [{'col': 0, 'row': 0, 'path': 'tile.ply'}]}, file)


def cpu_of(process):
    with open(f'/proc/{process.pid}/stat', encoding='utf-8') as file:
        fields = file.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def megabytes_of(process):
    with open(f'/proc/{process.pid}/statm', encoding='utf-8') as file:
        return int(file.read().split()[1]) * os.sysconf('SC_PAGE_SIZE') / 1e6


def is_at_rest(workers):
    before = sum(map(cpu_of, workers))
    time.sleep(0.5)
    return sum(map(cpu_of, workers)) - before <= 0.1


class Attack:
    def __init__(self, bench, scene, limit):
        self.bench, self.scene, self.limit, self.fills = bench, scene, limit, 0

    def begin_fill(self):
        made = self.bench.client('submit', self.scene, '--water', 'off', '--out',
                                 os.path.join(self.bench.folder, f'out{self.fills}'))
        require(made.returncode == 0, made.stderr)
        self.fills += 1
        await_('the fill', lambda: self.bench.tasks_run('"fill"') == self.fills)
        return next(word for word in made.stdout.split() if word.startswith('jobs/'))

    def require_computing(self, name):
        """Other tests may keep the processors from the workers for a while."""
        begin = time.time()
        while is_at_rest(self.bench.workers):
            require(time.time() - begin < self.limit,
                    f'no worker computes: {self.bench.told("get", name)}, {self.bench.told("workers")}, '
                    f'exit codes {[worker.poll() for worker in self.bench.workers]}')

    def require_soon(self, what, condition):
        begin = time.time()
        while not condition():
            require(time.time() - begin < self.limit, f'after {self.limit} s: not {what}')
            time.sleep(0.05)
        print(f'{what} after {time.time() - begin:.1f} s', flush=True)

    def cancel(self, wait):
        before = max(map(megabytes_of, self.bench.workers))
        name = self.begin_fill()
        time.sleep(wait)
        self.require_computing(name)
        cancelled = self.bench.client('cancel', name)
        require(cancelled.returncode == 0, cancelled.stderr)
        require(self.bench.told('get', name)['state'] == 'cancelled', 'the job is not cancelled')
        self.require_soon('free of tasks', lambda: all(worker['tasks'] == 0 for worker in self.bench.told('workers')))
        self.require_soon('at rest', lambda: is_at_rest(self.bench.workers))
        after = max(map(megabytes_of, self.bench.workers))
        require(after < before + 150, f'a worker has {after:.0f} MB, and had {before:.0f} MB before')

    def do_another_job(self):
        scene = os.path.join(self.bench.folder, 'small')
        subprocess.run([self.bench.program('tilemend-make-scene'), scene, '--cols', '2', '--rows', '2'], check=True,
                       capture_output=True)
        done = self.bench.client('submit', scene, '--wait', '--out', os.path.join(self.bench.folder, 'small-out'))
        require(done.returncode in (0, 100), done.stderr)
        self.fills = self.bench.tasks_run('"fill"')

    def stop_a_worker(self, wait):
        self.begin_fill()
        time.sleep(wait)
        before = [cpu_of(worker) for worker in self.bench.workers]
        time.sleep(0.5)
        filling = max(zip(self.bench.workers, before), key=lambda pair: cpu_of(pair[0]) - pair[1])[0]
        filling.send_signal(signal.SIGINT)
        time.sleep(0.5)
        require(filling.poll() is None, 'the first SIGINT lets a worker finish what it has')
        filling.send_signal(signal.SIGINT)
        self.require_soon('stopped', lambda: filling.poll() is not None)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('bin')
    parser.add_argument('--vertices', type=int, default=60000)
    parser.add_argument('--waits', type=float, nargs='+', default=[2, 15])
    parser.add_argument('--most-seconds', type=float, default=20)
    options = parser.parse_args()

    def attack_with(bench):
        folder = bench.folder
        scene = os.path.join(folder, 'scene')
        write_scene(scene, options.vertices)
        bench.start()
        require(bench.await_serving(), bench.said())
        bench.add_workers()
        attack = Attack(bench, scene, options.most_seconds)
        attack.do_another_job()
        for wait in options.waits:
            attack.cancel(wait)
        os.rename(os.path.join(folder, 'small'), os.path.join(folder, 'first'))
        os.rename(os.path.join(folder, 'small-out'), os.path.join(folder, 'first-out'))
        attack.do_another_job()
        attack.stop_a_worker(options.waits[-1])

    return run_attack(attack_with)


if __name__ == '__main__':
    sys.exit(main())
