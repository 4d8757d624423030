#!/usr/bin/env python3
"""Times jobs on workers of unequal speed, and looks whether priorities and pauses are kept.

    flow_test.py BIN [--cells 12] [--pairs 3] [--most-slowdown 1.3] [--least-speedup 1.9]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. Jobs on a made scene of `cells` x `cells`
cells run with three workers of one thread that are alike, with three of which one gets a tenth of its time (it is stopped
and woken in turn), with one worker and with two. Each is done `pairs` times in turn; the fastest of each counts. Then a
job is paused, the coordinator is killed and started again, and nothing of the job may be given out until it is resumed;
a job of higher priority that is submitted meanwhile must end first. Every tile must be that of the first job. Prints its
figures. Exit code 1 if anything was not so, or a figure is beyond its limit (0: no limit).
"""
import argparse
import filecmp
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time

from cluster_harness import Bench, Failure, await_, require

TENTH = 0.01  # seconds that a slow worker runs, of ten such


class Slowed:
    """A process that gets a tenth of its time."""

    def __init__(self, process):
        self.process, self.is_over = process, False
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def run(self):
        while not self.is_over:
            self.process.send_signal(signal.SIGSTOP)
            time.sleep(9 * TENTH)
            self.process.send_signal(signal.SIGCONT)
            time.sleep(TENTH)

    def close(self):
        self.is_over = True
        self.thread.join()


class Jobs:
    def __init__(self, bench, scene):
        self.bench, self.scene, self.count, self.first = bench, scene, 0, None

    def submit(self, *words):
        self.count += 1
        out = os.path.join(self.bench.folder, f'out{self.count}')
        made = self.bench.client('submit', self.scene, '--out', out, *words)
        require(made.returncode == 0, made.stderr)
        return next(word for word in made.stdout.split() if word.startswith('jobs/')), out

    def check(self, out):
        tiles = os.path.join(out, 'tiles')
        if self.first is None:
            self.first = tiles
        names = sorted(os.listdir(self.first))
        require(sorted(os.listdir(tiles)) == names, f'{tiles}: other tiles than {self.first}')
        same, differ, errors = filecmp.cmpfiles(self.first, tiles, names, shallow=False)
        require(len(same) == len(names), f'{tiles}: {differ + errors} differ')

    def end_of(self, name):
        return await_(f'the end of {name}', lambda: (lambda job: job if job and 'ended' in job else None)(
            self.bench.get(name)))

    def worker(self):
        return subprocess.Popen([self.bench.program('tilemend-worker'), '--coordinator', self.bench.address, '--threads',
                                 '1'], stderr=subprocess.DEVNULL)

    def time(self, workers, slow=0):
        """Seconds of a job on so many workers, and how often a second attempt was made."""
        running = [self.worker() for _ in range(workers)]
        await_('the workers', lambda: self.bench.client('workers').stdout.count('idle') >= workers)
        slowed = [Slowed(process) for process in running[:slow]]
        begin = time.time()
        name, out = self.submit()
        job = self.end_of(name)
        took = time.time() - begin
        for process in slowed:
            process.close()
        for process in running:
            process.send_signal(signal.SIGTERM)
        for process in running:
            process.wait()
        require(job['state'] in ('done', 'partial'), f'{name}: {job}')
        self.check(out)
        return took, job['progress']['tasks_retried']


def tasks_done(bench, name):
    return bench.get(name)['progress']['tasks_done']


def steer(bench, jobs):
    """Pauses a job over a restart, and lets another overtake it."""
    worker = jobs.worker()
    slowed = Slowed(worker)  # or the job could be over before it is paused
    name, out = jobs.submit()
    await_('some tasks', lambda: tasks_done(bench, name) > 3)
    require(bench.client('pause', name).returncode == 0, 'pause failed')
    slowed.close()
    await_('tasks in hand to end', lambda: bench.get(name)['progress']['tasks_running'] == 0)
    before = tasks_done(bench, name)
    bench.kill()
    start(bench)
    await_('the job to be what it was', lambda: tasks_done(bench, name) == before)
    job = bench.get(name)
    require(job['paused'] and 'paused' in job.get('waiting', ''), f'not paused after a restart: {job}')
    urgent, urgent_out = jobs.submit('--priority', '5')
    require(bench.client('prioritize', urgent, '7').returncode == 0, 'prioritize failed')
    await_('the other job to be at work', lambda: tasks_done(bench, urgent) > 3)
    require(tasks_done(bench, name) == before, 'tasks of a paused job were given out')
    require(bench.client('resume', name).returncode == 0, 'resume failed')
    first, last = jobs.end_of(urgent), jobs.end_of(name)
    require(first['ended'] <= last['ended'], 'the job of lower priority ended first')
    for path in (out, urgent_out):
        jobs.check(path)
    worker.kill()
    worker.wait()


def start(bench):
    bench.start()
    require(bench.await_serving(), bench.said())


def run_all(bench, arguments):
    scene = os.path.join(bench.folder, 'scene')
    side = str(arguments.cells)
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', side, '--rows', side, '--cell', '100',
                    '--spacing', '0.8'], check=True, stdout=subprocess.DEVNULL)
    start(bench)
    jobs = Jobs(bench, scene)
    runs = [jobs.time(3) + jobs.time(3, slow=1) + jobs.time(1) + jobs.time(2) for _ in range(arguments.pairs)]
    alike, _, unequal, _, one, _, two, _ = (min(column) for column in zip(*runs))
    slowdown, speedup = unequal / alike, one / two
    print(f'{side} x {side} cells, {arguments.pairs} times, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}: three '
          f'workers alike {alike:.1f} s; one of them at a tenth of its speed {unequal:.1f} s, {slowdown:.2f} times, '
          f'{max(run[3] for run in runs)} tasks given out again; one worker {one:.1f} s, two {two:.1f} s, {speedup:.2f} times '
          'as fast')
    steer(bench, jobs)
    print('a paused job stood still over a restart of the coordinator, and one of higher priority overtook it')
    for figure, is_met in ((slowdown, not arguments.most_slowdown or slowdown <= arguments.most_slowdown),
                           (speedup, not arguments.least_speedup or speedup >= arguments.least_speedup)):
        require(is_met, f'{figure:.2f} is beyond its limit')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('--cells', type=int, default=12)
    parser.add_argument('--pairs', type=int, default=3)
    parser.add_argument('--most-slowdown', type=float, default=1.3)
    parser.add_argument('--least-speedup', type=float, default=1.9)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, folder)
        try:
            run_all(bench, arguments)
        except Failure as failure:
            print(f'FAILED: {failure}')
            sys.exit(1)
        finally:
            bench.close()


if __name__ == '__main__':
    main()
