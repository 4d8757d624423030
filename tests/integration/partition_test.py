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
import re
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request

from cluster_harness import LIMIT, Bench, Failure, await_, check_output, metrics_port, require

WAYS = {'to the coordinator': ['INPUT'], 'to the worker': ['OUTPUT'], 'both ways': ['INPUT', 'OUTPUT']}


def run(*words):
    return subprocess.run(words, capture_output=True, text=True)


def must(*words):
    done = run(*words)
    require(done.returncode == 0, f'{" ".join(words)}: {done.stderr}')


class Island:
    """A worker in a network of its own."""

    def __init__(self, number):
        self.name = f'tm{os.getpid() % 10000}w{number}'
        self.device = f'{self.name}h'
        self.host, self.own = f'10.213.{number}.1', f'10.213.{number}.2'
        self.rules = []
        self.worker = None

    def make(self):
        must('ip', 'netns', 'add', self.name)
        must('ip', 'link', 'add', self.device, 'type', 'veth', 'peer', 'name', 'inner', 'netns', self.name)
        must('ip', 'addr', 'add', f'{self.host}/24', 'dev', self.device)
        must('ip', 'link', 'set', self.device, 'up')
        for words in (['addr', 'add', f'{self.own}/24', 'dev', 'inner'], ['link', 'set', 'inner', 'up'],
                      ['link', 'set', 'lo', 'up']):
            must('ip', '-n', self.name, *words)

    def start(self, bench, port):
        self.log = os.path.join(bench.folder, f'{self.name}.log')
        self.worker = subprocess.Popen(
            ['ip', 'netns', 'exec', self.name, bench.program('tilemend-worker'), '--coordinator',
             f'{self.host}:{port}', '--insecure', '--threads', '1'],
            stderr=open(self.log, 'w'))

    def cut(self, way):
        for chain in WAYS[way]:
            rule = [chain, '-i' if chain == 'INPUT' else '-o', self.device, '-j', 'DROP']
            must('iptables', '-I', *rule)
            self.rules.append(rule)

    def heal(self):
        while self.rules:
            must('iptables', '-D', *self.rules.pop())

    def close(self):
        self.heal()
        if self.worker is not None and self.worker.poll() is None:
            self.worker.kill()
            self.worker.wait()
        run('ip', 'link', 'del', self.device)
        run('ip', 'netns', 'del', self.name)


class Jobs:
    """Jobs on one scene, one after the other, each held to the undisturbed run."""

    def __init__(self, bench, scene, reference):
        self.bench, self.scene, self.reference, self.code = bench, scene, reference, bench.code
        self.done, self.process, self.retried = 0, None, 0

    def keep_going(self):
        if self.process is not None and self.process.poll() is None:
            return
        self.take()
        self.out = f'{self.reference}-{self.done}'
        self.process = self.bench.submit(self.scene, self.out, os.path.basename(self.out))

    def take(self):
        if self.process is None:
            return
        said, error = self.process.communicate(timeout=LIMIT)
        require(self.process.returncode == self.code, f'the job ended with {self.process.returncode}: {error}')
        self.retried += int((re.search(r'"tasks_retried": "?(\d+)', said) or [0, 0])[1])
        check_output(self.reference, self.out)
        require(not os.path.exists(os.path.join(self.out, '.tilemend-attempts')), 'attempts were left')
        shutil.rmtree(self.out)
        self.process = None
        self.done += 1


def metric(port, name):
    with urllib.request.urlopen(f'http://127.0.0.1:{port}/metrics') as answer:
        lines = answer.read().decode().splitlines()
    return sum(float(line.split()[-1]) for line in lines if line.startswith(name))


def connected(port):
    return int(metric(port, 'tilemend_coordinator_workers_connected'))


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


def start_coordinator(bench):
    bench.log = open(os.path.join(bench.folder, 'coordinator.log'), 'w+')
    bench.coordinator = subprocess.Popen(
        [bench.program('tilemend-coordinator'), '--work', bench.work, '--listen', f'0.0.0.0:{bench.port}', '--insecure',
         '--lease', '5', '--metrics', '127.0.0.1:0'], stderr=bench.log)
    require(bench.await_serving(), bench.said())
    return metrics_port(bench.said())


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
    arguments = parser.parse_args()
    missing = [tool for tool in ('ip', 'iptables') if shutil.which(tool) is None]
    if os.geteuid() != 0 or missing or run('iptables', '-S').returncode != 0:
        print(f'SKIPPED: needs root, ip and iptables (missing: {missing}, user {os.geteuid()})')
        sys.exit(77)
    islands = [Island(number + 1) for number in range(arguments.workers)]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, folder)
        try:
            run_all(bench, arguments, islands)
        except Failure as failure:
            print(f'FAILED: {failure}')
            sys.exit(1)
        finally:
            for island in islands:
                island.close()
            bench.close()


if __name__ == '__main__':
    main()
