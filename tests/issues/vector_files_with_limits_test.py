#!/usr/bin/env python3
"""Gives a coordinator vector files that take GDAL forever: it must end them at once when it is told to.

    vector_files_with_limits_test.py BIN

BIN has tilemend, tilemend-coordinator, tilemend-gdal and tilemend-make-scene. While GDAL reads a GeoPackage whose layer
never ends, the job is cancelled, then the coordinator stopped, then killed: each time the process that reads must be
gone within MOST_SECONDS. A job with which three coordinators were killed must fail and say so. Files of shapes that take much memory must end with an error that names them, or be read.
Exit code 1 if anything was not so.
"""
import os
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'integration'))
from cluster_harness import await_, require, run_attack  # noqa: E402
from vector_bombs import crossing_ring, endless_view, many_holes  # noqa: E402

MOST_SECONDS = 5  # far below the 20 s after which the reader ends by itself
PREPARATIONS = 3  # that may end a coordinator before the job fails (coordinator/jobs/preparations.h)
MOST_READING = 100  # seconds: the reader's own limit of the clock, and a busy machine


def readers_of(pid):
    """Processes tilemend-gdal that this process started, or that it left behind."""
    found = []
    for number in filter(str.isdigit, os.listdir('/proc')):
        try:
            with open(f'/proc/{number}/stat') as stat:
                name, rest = stat.read().rsplit(')', 1)
            if name.endswith('(tilemend-gdal') and int(rest.split()[1]) == pid and rest.split()[0] != 'Z':
                found.append(int(number))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return found


def is_running(pid):
    try:
        with open(f'/proc/{pid}/stat') as stat:
            return stat.read().rsplit(')', 1)[1].split()[0] not in 'ZX'
    except (FileNotFoundError, ProcessLookupError):
        return False


def submit_and_await_reader(bench, scene, bomb, name):
    job = bench.told('submit', scene, '--out', os.path.join(bench.folder, name), '--water', bomb)
    readers = await_('the reader', lambda: readers_of(bench.coordinator.pid))
    return job['name'], readers


def await_gone(readers, start, what):
    await_('the reader to end', lambda: not any(is_running(reader) for reader in readers))
    took = time.time() - start
    print(f'{what}: reader gone after {took:.2f} s')
    require(took <= MOST_SECONDS, f'{what}: the reader went on for {took:.1f} s')


def start(bench):
    bench.start()
    require(bench.await_serving(), bench.said())


def end_early(bench, scene, bomb):
    start(bench)
    job, readers = submit_and_await_reader(bench, scene, bomb, 'cancelled')
    begin = time.time()
    require(bench.client('cancel', job).returncode == 0, 'cannot cancel')
    await_gone(readers, begin, 'job cancelled')
    require(bench.get(job)['state'] == 'cancelled', str(bench.get(job)))
    job, readers = submit_and_await_reader(bench, scene, bomb, 'stopped')
    begin = time.time()
    bench.coordinator.send_signal(signal.SIGTERM)
    await_gone(readers, begin, 'coordinator stopped')
    bench.coordinator.wait(timeout=MOST_SECONDS)
    for _ in range(PREPARATIONS):
        start(bench)
        readers = await_('the reader', lambda: readers_of(bench.coordinator.pid))
        begin = time.time()
        bench.kill()
        await_gone(readers, begin, 'coordinator killed')
    start(bench)
    await_('the job to end', lambda: (bench.get(job) or {'state': 'running'})['state'] != 'running')
    told = bench.get(job)
    print(f'after {PREPARATIONS} kills: {told["state"]}: {told["error"]["message"][:120]}')
    require(told['state'] == 'failed' and 'ended 3 times while it read' in told['error']['message'], str(told))


def read_shapes(bench, scene):
    for option, name, make, size in (('--water', 'crossing', crossing_ring, 5000), ('--area', 'holes', many_holes, 100000)):
        path = os.path.join(bench.folder, name + '.geojson')
        make(path, size)
        begin = time.time()
        said = subprocess.run([bench.program('tilemend'), 'inspect', scene, option, path], capture_output=True, text=True)
        took = time.time() - begin
        print(f'{name}, {os.path.getsize(path) // 1024} KB: exit code {said.returncode} after {took:.1f} s: '
              f'{said.stderr.strip()[-150:]}')
        require(took <= MOST_READING, f'{name}: {took:.0f} s')
        require(said.returncode in (0, 100) or path in said.stderr, f'{name}: the error does not name the file')


def attack(bench):
    scene, bomb = (os.path.join(bench.folder, name) for name in ('scene', 'bomb.gpkg'))
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', '2', '--rows', '2', '--cell', '20'], check=True,
                   stdout=subprocess.DEVNULL)
    endless_view(bomb)
    end_early(bench, scene, bomb)
    read_shapes(bench, scene)


if __name__ == '__main__':
    sys.exit(run_attack(attack))
