#!/usr/bin/env python3
"""Gives jobs to a crowd of workers that come and go, kills the coordinator, and looks whether each worker gets its share.

    crowd_test.py BIN [--workers 200] [--kills 10] [--side 24] [--seed 1]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. Each worker runs in a network namespace
of its own. First a job on a made scene of `side` x `side` small cells runs on all of them: each must get work. Then jobs
run one after the other while workers are killed, end or come at random moments, and the coordinator is killed `kills`
times. Every file of each output must be that of a run on this machine alone (report.json but for dates and seconds), no
task may have been committed twice, and nothing may be left in the output. Needs root, ip and iptables; skips loudly
without (exit code 77). Prints its figures. Exit code 1 if anything was not so.
"""
import argparse
import os
import random
import signal
import subprocess
import time

from cluster_harness import await_, require
from islands import Jobs, connected, metric, run_on_islands, start_coordinator

METRICS = 9100  # of each worker, in its own network


def start_worker(island, bench):
    island.start(bench, bench.port, '--metrics', f'{island.own}:{METRICS}')


def seconds_of(process):
    """CPU of a process."""
    with open(f'/proc/{process.pid}/stat', encoding='utf-8') as file:
        fields = file.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def status_of(process, field):
    with open(f'/proc/{process.pid}/status', encoding='utf-8') as file:
        return int(next(line.split()[1] for line in file if line.startswith(field)))


def share_out(bench, jobs, islands):
    """One job on all workers: each must get work."""
    before = seconds_of(bench.coordinator)
    start = time.time()
    jobs.keep_going()
    jobs.process.wait()
    took = time.time() - start
    coordinator = seconds_of(bench.coordinator) - before
    tasks = sorted(int(metric(METRICS, 'tilemend_worker_tasks_started_total', island.own)) for island in islands)
    workers = sum(seconds_of(island.worker) for island in islands)
    jobs.take()
    print(f'one job on {len(islands)} workers in {took:.1f} s: {tasks[0]} to {tasks[-1]} tasks each, {sum(tasks)} in all; '
          f'coordinator {coordinator:.2f} s of CPU, {status_of(bench.coordinator, "Threads")} threads, '
          f'{status_of(bench.coordinator, "VmHWM") // 1024} MB; workers {workers:.1f} s with their starts', flush=True)
    require(tasks[0] > 0, f'{tasks.count(0)} of {len(tasks)} workers got no task')


class Churn:
    """Workers that come and go."""

    def __init__(self, bench, islands, chance):
        self.bench, self.islands, self.chance = bench, islands, chance
        self.ended, self.killed, self.came = 0, 0, 0

    def alive(self):
        return sum(island.worker.poll() is None for island in self.islands)

    def step(self):
        island = self.chance.choice(self.islands)
        if island.worker.poll() is not None:
            start_worker(island, self.bench)
            self.came += 1
        elif self.chance.random() < 0.5:
            island.worker.send_signal(signal.SIGTERM)
            self.ended += 1
        else:
            island.worker.kill()
            self.killed += 1


def kill_often(bench, arguments, jobs, islands, port):
    chance = random.Random(arguments.seed)
    churn = Churn(bench, islands, chance)
    back = []
    for _ in range(arguments.kills):
        end = time.time() + chance.uniform(1, 6)
        while time.time() < end:
            jobs.keep_going()
            churn.step()
            time.sleep(chance.uniform(0, 0.4))
        bench.kill()
        start = time.time()
        port = start_coordinator(bench)
        await_('the workers to be back', lambda: connected(port) >= 0.9 * churn.alive() or jobs.keep_going())
        back.append(time.time() - start)
    await_('the last job', lambda: jobs.process is None or jobs.process.poll() is not None)
    jobs.take()
    return churn, sorted(back)


def run_all(bench, arguments, islands):
    scene, reference = os.path.join(bench.folder, 'scene'), os.path.join(bench.folder, 'reference')
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', str(arguments.side), '--rows',
                    str(arguments.side), '--cell', '60', '--spacing', '1.5'], check=True, stdout=subprocess.DEVNULL)
    bench.run_undisturbed(scene, reference)
    port = start_coordinator(bench)
    for island in islands:
        island.make()
        start_worker(island, bench)
    await_('all workers', lambda: connected(port) == len(islands))
    jobs = Jobs(bench, scene, reference)
    share_out(bench, jobs, islands)
    churn, back = kill_often(bench, arguments, jobs, islands, port)
    bench.kill()
    bench.check_committed_once()
    print(f'{arguments.kills} kills of the coordinator, {churn.killed} of workers, {churn.ended} workers ended and '
          f'{churn.came} came, {jobs.done} jobs: every byte as on one machine, 0 committed twice, {jobs.retried} tasks '
          f'given out again; nine of ten workers back after {back[len(back) // 2]:.1f} s (median), {back[-1]:.1f} s (most)')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('--workers', type=int, default=200)
    parser.add_argument('--kills', type=int, default=10)
    parser.add_argument('--side', type=int, default=24)
    parser.add_argument('--seed', type=int, default=1)
    run_on_islands(run_all, parser.parse_args())


if __name__ == '__main__':
    main()
