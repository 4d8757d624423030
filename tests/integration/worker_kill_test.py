#!/usr/bin/env python3
"""Kills and stops workers at random moments and holds what comes of it to an undisturbed run.

    worker_kill_test.py BIN [--kills 200] [--jobs 20] [--most-a-job N] [--seed 1] [--scene SCENE ...]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. Jobs run one after the other with three
workers, on a made scene or on those that are given in turn. Half of the workers are killed (SIGKILL, and another one is
started), half are stopped (SIGSTOP) until after their lease has run out, so that they wake with tasks that are others'.
A task is given up when three workers were lost with it: with --most-a-job 2 that cannot be, however slow the machine is.
Some jobs see the coordinator stopped for twice its lease as well, which is to count against nobody. At last every worker
is asked to end (SIGTERM) in the midst of a job, one after the other, and replaced. Every file of each output must be
that of the undisturbed run, no task may have been committed twice or given up. Prints its figures. Exit code 1 if
anything was not so.
"""
import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

from cluster_harness import LIMIT, Bench, Failure, await_, metrics_port, require
from partition_test import Jobs, metric

LEASE = 3  # seconds
WORKERS = 3


class Crowd:
    """Workers that come and go."""

    def __init__(self, bench):
        self.bench = bench
        self.running, self.stopped = [], []
        self.kills, self.stops = 0, 0

    def fill(self):
        while len(self.running) < WORKERS:
            self.running.append(subprocess.Popen(
                [self.bench.program('tilemend-worker'), '--coordinator', self.bench.address, '--threads', '1'],
                stderr=subprocess.DEVNULL))

    def disturb(self, chance):
        worker = self.running.pop(chance.randrange(len(self.running)))
        if chance.random() < 0.5:
            worker.kill()
            worker.wait()
            self.kills += 1
        else:
            worker.send_signal(signal.SIGSTOP)
            self.stopped.append((time.time() + chance.uniform(0.5, 2.5) * LEASE, worker))
            self.stops += 1
        self.fill()

    def wake(self, all_of_them=False):
        now = time.time()
        due = [entry for entry in self.stopped if all_of_them or entry[0] <= now]
        for entry in due:
            self.stopped.remove(entry)
            entry[1].send_signal(signal.SIGCONT)
            self.running.insert(0, entry[1])
        while len(self.running) > WORKERS:  # an older one leaves in good order
            self.end(self.running.pop(1))

    def end(self, worker):
        worker.send_signal(signal.SIGTERM)
        require(worker.wait(timeout=LIMIT) == 0, f'a worker that was asked to end: exit code {worker.returncode}')

    def close(self):
        for worker in self.running + [entry[1] for entry in self.stopped]:
            worker.kill()
            worker.wait()


def start_coordinator(bench):
    bench.log = open(os.path.join(bench.folder, 'coordinator.log'), 'w+')
    bench.coordinator = subprocess.Popen(
        [bench.program('tilemend-coordinator'), '--work', bench.work, '--listen', bench.address, '--lease', str(LEASE),
         '--metrics', '127.0.0.1:0'], stderr=bench.log)
    require(bench.await_serving(), bench.said())
    return metrics_port(bench.said())


def await_job(jobs, crowd, meanwhile=lambda: None):
    while jobs.process.poll() is None:
        meanwhile()
        crowd.wake()
        time.sleep(0.02)
    jobs.take()


def kill_often(arguments, crowd, all_jobs, chance):
    for number in range(arguments.jobs):
        jobs = all_jobs[number % len(all_jobs)]
        jobs.keep_going()
        wanted = arguments.kills * (number + 1) // arguments.jobs
        next_one = [time.time() + chance.uniform(0, 0.5)]
        before = [crowd.kills + crowd.stops]  # the job

        def disturb():
            done = crowd.kills + crowd.stops
            if done < min(wanted, before[0] + arguments.most_a_job) and time.time() >= next_one[0]:
                crowd.disturb(chance)
                next_one[0] = time.time() + chance.uniform(0.05, 0.6)
        await_job(jobs, crowd, disturb)
        while crowd.kills + crowd.stops < wanted:  # the job was over before
            before[0] = crowd.kills + crowd.stops
            jobs.keep_going()
            await_job(jobs, crowd, disturb)


def stop_the_coordinator(bench, jobs, crowd, metrics, times):
    for _ in range(times):
        before = metric(metrics, 'tilemend_coordinator_tasks_retried_total')
        jobs.keep_going()
        time.sleep(0.5)
        bench.coordinator.send_signal(signal.SIGSTOP)
        time.sleep(2 * LEASE)
        bench.coordinator.send_signal(signal.SIGCONT)
        await_job(jobs, crowd)
        again = metric(metrics, 'tilemend_coordinator_tasks_retried_total') - before
        require(again == 0, f'{again} tasks were taken from healthy workers after the coordinator had been stopped')


def roll(jobs, crowd, metrics):
    """Each worker is asked to end in the midst of a job, and replaced."""
    before = metric(metrics, 'tilemend_coordinator_tasks_retried_total')
    jobs.keep_going()
    for worker in list(crowd.running):
        time.sleep(0.3)
        crowd.running.remove(worker)
        crowd.end(worker)
        crowd.fill()
    await_job(jobs, crowd)
    return int(metric(metrics, 'tilemend_coordinator_tasks_retried_total') - before)


def run_all(bench, arguments, crowd):
    scenes = [os.path.abspath(scene) for scene in arguments.scene]
    if not scenes:
        scenes = [os.path.join(bench.folder, 'scene')]
        subprocess.run([bench.program('tilemend-make-scene'), scenes[0], '--cols', '6', '--rows', '6', '--cell', '100',
                        '--spacing', '0.6'], check=True, stdout=subprocess.DEVNULL)
    all_jobs = []
    for number, scene in enumerate(scenes):
        reference = os.path.join(bench.folder, f'reference{number}')
        bench.run_undisturbed(scene, reference)
        all_jobs.append(Jobs(bench, scene, reference))
    metrics = start_coordinator(bench)
    crowd.fill()
    kill_often(arguments, crowd, all_jobs, random.Random(arguments.seed))
    await_('the stopped workers to be due', lambda: crowd.wake(True) or not crowd.stopped)
    stop_the_coordinator(bench, all_jobs[0], crowd, metrics, max(1, arguments.jobs // 5))
    given_back = roll(all_jobs[0], crowd, metrics)
    late = int(metric(metrics, 'tilemend_coordinator_tasks_refused_late_total'))
    lost = int(metric(metrics, 'tilemend_coordinator_tasks_quarantined_total'))
    require(lost == 0, f'{lost} tasks were given up')
    bench.kill()
    bench.check_committed_once()
    print(f'{crowd.kills} workers killed, {crowd.stops} stopped beyond their lease, {max(1, arguments.jobs // 5)} times '
          f'the coordinator, {WORKERS} workers replaced one after the other ({given_back} tasks given back), '
          f'{sum(jobs.done for jobs in all_jobs)} jobs on {len(scenes)} scenes: every byte as undisturbed, 0 tasks lost, '
          f'0 committed twice, {late} late results refused')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('--kills', type=int, default=200)
    parser.add_argument('--jobs', type=int, default=20)
    parser.add_argument('--most-a-job', type=int, default=1000)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--scene', action='append', default=[])
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, folder)
        crowd = Crowd(bench)
        try:
            run_all(bench, arguments, crowd)
        except Failure as failure:
            print(f'FAILED after {crowd.kills} kills and {crowd.stops} stops: {failure}')
            sys.exit(1)
        finally:
            crowd.close()
            bench.close()


if __name__ == '__main__':
    main()
