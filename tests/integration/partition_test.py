#!/usr/bin/env python3
"""Cuts workers off from their coordinator, one way and both, and holds what comes of it to an undisturbed run.

    partition_test.py BIN [--cuts 50] [--longest 20] [--workers 3] [--seed 1]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. Each worker runs in a network namespace
of its own; packets to it, from it or both ways are dropped for 1 to `longest` seconds, of one worker, some or all of
them, while jobs run one after the other. Every file of each output must be that of the undisturbed run (report.json but
for dates and seconds), no task may have been committed twice, and nothing may be left in the output. Needs root, ip and
iptables; skips loudly without (exit code 77). Prints its figures. Exit code 1 if anything was not so.
"""
import argparse
import os
import random
import subprocess
import time

from cluster_harness import await_
from islands import WAYS, Jobs, connected, metric, run_on_islands, start_coordinator


def cut_often(arguments, islands, jobs, port):
    chance = random.Random(arguments.seed)
    seconds, back = [], []
    for number in range(arguments.cuts):
        await_('all workers', lambda: connected(port) == len(islands))
        jobs.keep_going()
        time.sleep(chance.uniform(0.2, 2))
        chosen = chance.sample(islands, chance.choice([1, 1, 2, len(islands)]) if len(islands) > 1 else 1)
        way = list(WAYS)[number % len(WAYS)]
        length = chance.uniform(1, arguments.longest)
        for island in chosen:
            island.cut(way)
        end = time.time() + length
        while time.time() < end:
            jobs.keep_going()
            time.sleep(0.1)
        for island in chosen:
            island.heal()
        start = time.time()
        await_('all workers to be back', lambda: connected(port) == len(islands) or jobs.keep_going())
        seconds.append(length)
        back.append(time.time() - start)
    await_('the last job', lambda: jobs.process is None or jobs.process.poll() is not None)
    jobs.take()
    return seconds, sorted(back)


def run_all(bench, arguments, islands):
    scene, reference = os.path.join(bench.folder, 'scene'), os.path.join(bench.folder, 'reference')
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', '6', '--rows', '6', '--cell', '100',
                    '--spacing', '0.6'], check=True, stdout=subprocess.DEVNULL)
    bench.run_undisturbed(scene, reference)
    metrics = start_coordinator(bench)
    for island in islands:
        island.make()
        island.start(bench, bench.port)
    jobs = Jobs(bench, scene, reference)
    seconds, back = cut_often(arguments, islands, jobs, metrics)
    late = int(metric(metrics, 'tilemend_coordinator_tasks_refused_late_total'))
    bench.kill()
    bench.check_committed_once()
    print(f'{len(seconds)} cuts of {min(seconds):.1f} to {max(seconds):.1f} s, {sum(seconds):.0f} s in all, of '
          f'{len(islands)} workers, {jobs.done} jobs: every byte as undisturbed, 0 tasks lost, 0 committed twice, '
          f'{jobs.retried} tasks given out again, {late} late results refused; all workers back after '
          f'{back[len(back) // 2]:.1f} s (median), {back[-1]:.1f} s (most)')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('--cuts', type=int, default=50)
    parser.add_argument('--longest', type=float, default=20)
    parser.add_argument('--workers', type=int, default=3)
    parser.add_argument('--seed', type=int, default=1)
    run_on_islands(run_all, parser.parse_args())


if __name__ == '__main__':
    main()
