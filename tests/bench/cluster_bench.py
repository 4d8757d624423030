#!/usr/bin/python3
"""What a job takes in a cluster: wall seconds, CPU seconds and the most memory of the coordinator and of its workers.

    cluster_bench.py [--bin DIR] [--scene FOLDER] [--cols 4] [--rows 4] [--spacing 0.36] [--rounds 3] [--folder DIR]
                     [--variant WORKERS:CHECK] ... [--pin none|workers|all] [--least-ratio 0]

A variant is a number of workers of one thread, and what the coordinator does with --check-tiles (size, digest or
content). Each is run once a round, in turn, in a cluster of its own; the default is 1:digest 1:size 2:digest.
WORKERS:run is `tilemend run --workers WORKERS` instead, in one process. Without --scene a scene of 250 m cells is made.
The table has the least of each figure, and the ratio of the wall seconds of the first variant to each.

With --pin workers each worker has a core of its own, and the coordinator all cores of the machine; with --pin all it
has those of the workers alone, so that one worker has it on its core. `run` has as many cores as workers with both.
Exit code 1 if the last variant's ratio is below --least-ratio. On a quiet machine:

    cluster_bench.py --cols 10 --rows 10 --variant 1:digest --variant 2:digest --pin all --least-ratio 1.8
    cluster_bench.py --cols 10 --rows 10 --variant 1:run --variant 2:run --pin all --least-ratio 1.8
"""
import argparse
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure

TICK = os.sysconf('SC_CLK_TCK')


def cpu_of(pid):
    with open(f'/proc/{pid}/stat', encoding='utf-8') as file:
        fields = file.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def peak_of(pid):
    with open(f'/proc/{pid}/status', encoding='utf-8') as file:
        return next(int(line.split()[1]) * 1024 for line in file if line.startswith('VmHWM'))


def on_cores(first, last, command):
    """The command, held to these cores."""
    return ['taskset', '-c', f'{first}-{last}', *command]


class Cluster:
    """A coordinator and its workers, each a process; ended by close()."""

    def __init__(self, a, workers, check, folder):
        self.workers = workers
        with socket.socket() as free:
            free.bind(('127.0.0.1', 0))
            self.address = f'127.0.0.1:{free.getsockname()[1]}'
        self.log = open(os.path.join(folder, 'log'), 'w', encoding='utf-8')
        self.processes = [self.start(a, 'coordinator', '--listen', self.address, '--work', os.path.join(folder, 'work'),
                                     '--check-tiles', check)]
        for n in range(workers):
            self.processes.append(self.start(a, 'worker', '--coordinator', self.address, '--threads', '1', core=n))
        self.await_workers(a, workers)

    def start(self, a, name, *flags, core=None):
        command = [os.path.join(a.bin, f'tilemend-{name}'), *flags]
        return subprocess.Popen(self.held(a, command, core), stderr=self.log)

    def held(self, a, command, core=None):
        if core is not None and a.pin != 'none':
            return on_cores(core, core, command)
        return on_cores(0, self.workers - 1, command) if a.pin == 'all' else command

    def command(self, a, *words):
        return self.held(a, [os.path.join(a.bin, 'tilemend'), words[0], '--coordinator', self.address, *words[1:]])

    def await_workers(self, a, workers):
        for _ in range(300):
            seen = subprocess.run(self.command(a, 'workers'), capture_output=True, text=True, check=False)
            if seen.stdout.count('idle') == workers:
                return
            time.sleep(0.1)
        raise SystemExit(f'the workers did not come: {seen.stdout}{seen.stderr}')

    def close(self):
        for process in reversed(self.processes):
            process.terminate()
            process.wait()
        self.log.close()


def run_alone(a, workers, scene, place):
    out = os.path.join(place, 'out')
    command = [os.path.join(a.bin, 'tilemend'), 'run', scene, '--out', out, '--workers', str(workers)]
    done = measure.Run(command if a.pin == 'none' else on_cores(0, workers - 1, command), accept=(0, 100))
    return done.wall, 0, done.cpu, 0, done.peak


def run_cluster(a, workers, check, scene, place):
    cluster = Cluster(a, workers, check, place)
    try:
        pids = [process.pid for process in cluster.processes]
        before = [cpu_of(pid) for pid in pids]
        begin = time.perf_counter()
        done = subprocess.run(cluster.command(a, 'submit', scene, '--out', os.path.join(place, 'out'), '--wait'),
                              capture_output=True, text=True, check=False)
        wall = time.perf_counter() - begin
        if done.returncode not in (0, 100):
            raise SystemExit(f'exit code {done.returncode}\n{done.stderr}')
        cpu = [cpu_of(pid) - b for pid, b in zip(pids, before)]
        peaks = [peak_of(pid) for pid in pids]
    finally:
        cluster.close()
    return wall, cpu[0], sum(cpu[1:]), peaks[0], max(peaks[1:])


def run(a, workers, check, scene, folder):
    """(wall, CPU of the coordinator, of the workers, memory of the coordinator, most of a worker)."""
    place = os.path.join(folder, 'cluster')
    os.mkdir(place)
    subprocess.run(['sync'], check=True)
    figures = run_alone(a, workers, scene, place) if check == 'run' else run_cluster(a, workers, check, scene, place)
    shutil.rmtree(place)
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--scene')
    parser.add_argument('--cols', type=int, default=4)
    parser.add_argument('--rows', type=int, default=4)
    parser.add_argument('--spacing', type=float, default=0.36)
    parser.add_argument('--rounds', type=int, default=3)
    parser.add_argument('--folder', help='where to write (default: the temporary folder)')
    parser.add_argument('--variant', action='append', metavar='WORKERS:CHECK')
    parser.add_argument('--pin', choices=('none', 'workers', 'all'), default='none')
    parser.add_argument('--least-ratio', type=float, default=0)
    a = parser.parse_args()
    variants = a.variant or ['1:digest', '1:size', '2:digest']
    print(measure.machine(), flush=True)
    figures = {variant: [] for variant in variants}
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-', dir=a.folder) as folder:
        scene = os.path.abspath(a.scene) if a.scene else os.path.join(folder, 'scene')
        if not a.scene:
            measure.make_scene(a.bin, scene, '--cols', a.cols, '--rows', a.rows, '--spacing', a.spacing)
        for _ in range(a.rounds):
            for variant in variants:
                workers, check = variant.split(':')
                figures[variant].append(run(a, int(workers), check, scene, folder))
                print(variant, *(f'{x:.2f}' for x in figures[variant][-1]), file=sys.stderr, flush=True)
    rows, ratio = [], 0
    for variant in variants:
        least = [min(column) for column in zip(*figures[variant])]
        first = min(row[0] for row in figures[variants[0]])
        ratio = first / least[0]
        rows.append([variant, *(measure.up(x, 2) for x in least[:3]), *(measure.megabytes(x) for x in least[3:]),
                     measure.down(ratio, 2)])
    print(measure.table(['workers:check', 's', 'coordinator, CPU s', 'workers, CPU s', 'coordinator, MB', 'worker, MB',
                         'first / this'], rows))
    return 0 if ratio >= a.least_ratio else 1


if __name__ == '__main__':
    sys.exit(main())
