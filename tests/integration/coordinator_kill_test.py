#!/usr/bin/env python3
"""Kills a coordinator at random moments and at every durable write, and holds what comes of it to an undisturbed run.

    coordinator_kill_test.py BIN [--kills 300] [--each 5] [--seed 1] [--failpoints NAME,NAME]
                            [--scene SCENE] [--options "of the job"]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. A job runs on a made scene with two
workers. The coordinator is killed (SIGKILL), a new one is started on the same folder, and so on until the job is over.
Then every file of the output must be that of the undisturbed run (report.json but for dates and seconds), no task may
have been committed twice or forgotten, no more tasks may have run than were in flight at the kills, and nothing may be
left in the output or in the work folder. Prints its figures. Exit code 1 if anything was not so.
"""
import argparse
import glob
import json
import os
import random
import re
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import urllib.request

from free_port import free_port

FAILPOINTS = ['journal.make', 'journal.commit', 'journal.committed', 'journal.checkpointed', 'journal.tidy', 'blob.sync',
              'blob.renamed', 'restore.swept', 'output.claimed', 'file.written', 'file.renamed', 'file.moved',
              'job.finished', 'job.released']
# What is reached only by a coordinator that starts again.
ONLY_AGAIN = {'restore.swept'}
THREADS = [1, 1]  # of the workers
LARGEST_FILE = 900000  # bytes: less than the journal's log of 64 small cells, more than any other file of theirs
LIMIT = 120  # seconds for anything to happen


class Failure(Exception):
    pass


def require(condition, text):
    if not condition:
        raise Failure(text)


def await_(what, condition):
    end = time.time() + LIMIT
    while time.time() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.005)
    raise Failure(f'waited in vain for {what}')


def metrics_port(log):
    found = re.search(r'"metrics served".*"address":"[^"]*:(\d+)"', log)
    return int(found.group(1)) if found else 0


class Bench:
    """A work folder, its coordinators and workers."""

    def __init__(self, bin_folder, folder, options=()):
        self.bin, self.folder, self.options = bin_folder, folder, options
        self.code = 0  # of the undisturbed run
        self.work = os.path.join(folder, 'work')
        self.port = free_port()
        self.address = f'127.0.0.1:{self.port}'
        self.coordinator = None
        self.log = None
        self.workers, self.worker_ports = [], []

    def program(self, name):
        return os.path.join(self.bin, name)

    def start(self, failpoint='', largest_file=resource.RLIM_INFINITY):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))

        self.log = open(os.path.join(self.folder, 'coordinator.log'), 'w+')
        self.coordinator = subprocess.Popen(
            [self.program('tilemend-coordinator'), '--work', self.work, '--listen', self.address, '--lease', '30'],
            stderr=self.log, env=dict(os.environ, TILEMEND_FAILPOINT=failpoint), preexec_fn=limit, restore_signals=False)

    def said(self):
        with open(self.log.name) as log:
            return log.read()

    def await_serving(self):
        await_('the coordinator to serve', lambda: 'listening' in self.said() or self.coordinator.poll() is not None)
        return self.coordinator.poll() is None

    def kill(self):
        self.coordinator.send_signal(signal.SIGKILL)
        self.coordinator.wait()

    def add_workers(self):
        for number, threads in enumerate(THREADS):
            path = os.path.join(self.folder, f'worker{number}.log')
            self.workers.append(subprocess.Popen(
                [self.program('tilemend-worker'), '--coordinator', self.address, '--threads', str(threads),
                 '--metrics', '127.0.0.1:0'], stderr=open(path, 'w')))
            self.worker_ports.append(await_('a worker', lambda path=path: metrics_port(open(path).read())))

    def tasks_run(self):
        total = 0
        for port in self.worker_ports:
            with urllib.request.urlopen(f'http://127.0.0.1:{port}/metrics') as answer:
                for line in answer.read().decode().splitlines():
                    if line.startswith('tilemend_worker_tasks_started_total'):
                        total += int(float(line.split()[-1]))
        return total

    def client(self, *words):
        return subprocess.run([self.program('tilemend'), *words, '--coordinator', self.address], capture_output=True,
                              text=True, timeout=LIMIT)

    def told(self, *words):
        said = self.client(*words, '-o', 'json')
        require(said.returncode == 0, f'{words}: exit code {said.returncode}: {said.stderr}')
        return json.loads(said.stdout)

    def get(self, name):
        got = self.client('get', name, '-o', 'json')
        return json.loads(got.stdout) if got.returncode == 0 else None

    def run_undisturbed(self, scene, out):
        run = subprocess.run([self.program('tilemend'), 'run', scene, '--out', out, '--workers', '2', *self.options],
                             capture_output=True, text=True)
        self.code = run.returncode
        require(self.code in (0, 100), f'tilemend run: exit code {self.code}: {run.stderr}')

    def submit(self, scene, out, request):
        return subprocess.Popen([self.program('tilemend'), 'submit', scene, '--out', out, '--coordinator', self.address,
                                 '--request-id', request, '--wait', '-o', 'json', *self.options], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def check_committed_once(self):
        """In a copy of what the dead coordinator left."""
        copy = os.path.join(self.folder, 'copy')
        shutil.rmtree(copy, ignore_errors=True)
        os.makedirs(copy)
        for path in glob.glob(os.path.join(self.work, 'journal.sqlite*')):
            shutil.copy(path, copy)
        path = os.path.join(copy, 'journal.sqlite')
        if not os.path.exists(path):
            return
        with sqlite3.connect(path) as journal:
            twice = journal.execute('SELECT count(*) FROM (SELECT 1 FROM result WHERE state > 1 GROUP BY job, name'
                                    ' HAVING count(*) > 1)').fetchone()[0]
        require(twice == 0, f'{twice} tasks were committed twice')

    def close(self):
        for process in [*self.workers, self.coordinator]:
            if process is not None and process.poll() is None:
                process.kill()
                process.wait()


def content(path):
    with open(path, 'rb') as file:
        data = file.read()
    if os.path.basename(path) != 'report.json':
        return data
    report = json.loads(data)
    for key in ('seconds', 'date', 'peak_rss_bytes', 'tasks'):
        report.pop(key, None)
    return json.dumps(report, sort_keys=True)


def files(folder):
    return {os.path.relpath(os.path.join(where, name), folder)
            for where, _, names in os.walk(folder) for name in names if name != '.tilemend-results'}


def check_output(reference, out):
    wanted, found = files(reference), files(out)
    require(wanted == found, f'missing {sorted(wanted - found)}, too many {sorted(found - wanted)}')
    wrong = [name for name in sorted(wanted) if content(os.path.join(reference, name)) != content(os.path.join(out, name))]
    require(not wrong, f'other bytes: {wrong}')


class Figures:
    def __init__(self):
        self.kills, self.jobs, self.again, self.most_again, self.in_flight = 0, 0, 0, 0, 0
        self.at_random, self.told = 0, 0
        self.serving, self.back = [], []  # seconds from the start of a coordinator
        self.reached = {}


class JobRun:
    """One job from submit to its end, with kills in between."""

    def __init__(self, bench, scene, reference, figures, number):
        self.bench, self.scene, self.reference, self.figures = bench, scene, reference, figures
        self.out = os.path.join(bench.folder, f'out{number}')
        self.ran_before = bench.tasks_run()
        self.kills = 0
        self.client = bench.submit(scene, self.out, f'r{number}')

    def is_over(self):
        return self.client.poll() is not None

    def killed(self):
        self.kills += 1
        self.bench.check_committed_once()
        start = time.time()
        self.bench.start()
        require(self.bench.await_serving(), f'the coordinator did not start again: {self.bench.said()}')
        self.figures.serving.append(time.time() - start)

        def at_work():
            got = self.bench.client('list', '-o', 'json')
            jobs = json.loads(got.stdout) if got.returncode == 0 else []
            jobs = jobs.get('jobs', []) if isinstance(jobs, dict) else jobs
            return self.is_over() or (jobs and (jobs[0]['state'] != 'running' or jobs[0]['progress']['tasks_running'] > 0))
        await_('the job to go on', at_work)
        self.figures.back.append(time.time() - start)

    def finish(self):
        try:
            stdout, stderr = self.client.communicate(timeout=LIMIT)
        except subprocess.TimeoutExpired:
            self.client.kill()
            raise Failure(f'the job did not end: {self.bench.client("list").stdout} {self.bench.said()}')
        require(self.client.returncode == self.bench.code, f'exit code {self.client.returncode}: {stdout}{stderr}{self.bench.said()}')
        shown = [line for line in stderr.splitlines() if ': waits: ' not in line]  # for workers, after each restart
        require(len(shown) == len(set(shown)), f'shown twice: {shown}')
        progress = json.loads(stdout)['progress']
        require(progress['tasks'] == progress['tasks_done'], f'tasks: {progress}')
        require(progress['tasks_quarantined'] == 0, f'quarantined: {progress}')
        check_output(self.reference, self.out)
        again = self.bench.tasks_run() - self.ran_before - progress['tasks']
        # A task that a worker got and the coordinator did not give out durably does not exist: it is in flight, too.
        # Where a machine stands still for a second, a task may get a second attempt.
        most = self.kills * sum(THREADS) + int(progress['tasks_retried'])
        require(0 <= again <= most, f'{again} tasks were done again at {self.kills} kills')
        await_('the work folder to be empty', lambda: not files(os.path.join(self.bench.work, 'jobs')))
        figures = self.figures
        figures.jobs += 1
        figures.kills += self.kills
        figures.again += again
        figures.most_again = max(figures.most_again, again)
        figures.in_flight += self.kills * sum(THREADS)
        shutil.rmtree(self.out)


def kill_at_random(bench, scene, reference, figures, kills, seconds, dice):
    number = 0
    while figures.kills < kills:
        number += 1
        run = JobRun(bench, scene, reference, figures, f'-random-{number}')
        for _ in range(min(dice.randint(1, 6), kills - figures.kills)):
            time.sleep(dice.uniform(0, seconds))
            if run.is_over():
                break
            bench.kill()
            run.killed()
        run.finish()


def pass_failpoint(bench, scene, reference, figures, name, times, number):
    """A job whose coordinator dies the given time that it passes the place; False if that never comes."""
    bench.kill()
    if name == 'journal.make':
        shutil.rmtree(bench.work)
    first = name not in ONLY_AGAIN
    bench.start(f'{name}:{times}' if first else '')
    serving = bench.await_serving()
    if not serving:
        bench.start()
        bench.await_serving()
    run = JobRun(bench, scene, reference, figures, number)
    if not first:
        await_('a task', lambda: bench.tasks_run() > run.ran_before)
        bench.kill()
        run.kills += 1
        bench.start(f'{name}:{times}')
    died = not serving
    if serving:
        # What is done when nothing else is to do comes half a second after the end.
        end = None
        while bench.coordinator.poll() is None and (end is None or time.time() < end):
            if run.is_over() and end is None:
                end = time.time() + (30 if times == 1 else 3)  # the first time comes in every job
            time.sleep(0.005)
        died = bench.coordinator.poll() is not None
        if died:
            require(bench.coordinator.returncode == -signal.SIGKILL, f'the coordinator ended by itself: {bench.said()}')
            run.killed()
    run.finish()
    return died


def kill_at_failpoints(bench, scene, reference, figures, each, names):
    for name in names:
        figures.reached[name] = 0
        times = 0
        for number in range(each):
            times += 1
            if pass_failpoint(bench, scene, reference, figures, name, times, f'-{name}-{number}'):
                figures.reached[name] += 1
            elif times > 1:  # it is passed less often than that: once more from the first time
                times = 1
                figures.reached[name] += pass_failpoint(bench, scene, reference, figures, name, 1, f'-{name}-{number}b')
    missing = [name for name, reached in figures.reached.items() if reached < each]
    require(not missing, f'not reached {each} times: {missing} of {figures.reached}')


def fail_commits(bench, scene, reference, figures, each):
    """A commit that fails ends the coordinator with its message; the next one goes on."""
    for number in range(each):
        bench.kill()
        bench.start(f'journal.commit:{3 + 4 * number}:error')
        bench.await_serving()
        run = JobRun(bench, scene, reference, figures, f'-error-{number}')
        await_('the coordinator to end', lambda: bench.coordinator.poll() is not None)
        require(bench.coordinator.returncode == 5, f'exit code {bench.coordinator.returncode}')
        require('the journal cannot be written' in bench.said(), bench.said())
        run.killed()
        run.finish()


def fill_the_disk(bench, figures, each):
    """As fail_commits, where a file can grow no more."""
    scene, reference = make_scene(bench, 'small', 8, 30, 3), os.path.join(bench.folder, 'small-reference')
    bench.run_undisturbed(scene, reference)
    for number in range(each):
        bench.kill()
        shutil.rmtree(bench.work)
        bench.start(largest_file=LARGEST_FILE + 20000 * number)
        bench.await_serving()
        run = JobRun(bench, scene, reference, figures, f'-full-{number}')
        await_('the coordinator to end', lambda: bench.coordinator.poll() is not None or run.is_over())
        require(bench.coordinator.poll() == 5, f'exit code {bench.coordinator.poll()} {run.is_over()}: {bench.said()}')
        require('the journal cannot be written' in bench.said(), bench.said())
        run.killed()
        run.finish()


def check_told_stays(bench, scene, figures, each):
    """What a client was told is so after a kill that follows at once."""
    def restart():
        bench.kill()
        figures.told += 1
        bench.start()
        bench.await_serving()

    for number in range(each):
        for worker in bench.workers:
            worker.send_signal(signal.SIGSTOP)  # or the job could be over
        made = bench.told('submit', scene, '--out', os.path.join(bench.folder, f'told{number}'))
        restart()
        require(bench.get(made['name'])['state'] == 'running', f'{made["name"]} is not there any more')
        bench.told('cancel', made['name'])
        restart()
        require(bench.get(made['name'])['state'] == 'cancelled', f'{made["name"]} is not cancelled any more')
        again = bench.told('retry', made['name'])
        restart()
        require(bench.get(again['name'])['state'] == 'running', f'{again["name"]} is not there any more')
        bench.client('cancel', again['name'])
        for worker in bench.workers:
            worker.send_signal(signal.SIGCONT)


def check_refusals(bench):
    """A second coordinator on the folder, and a file there that is no journal."""
    def try_to_start(folder):
        return subprocess.run([bench.program('tilemend-coordinator'), '--work', folder, '--listen', '127.0.0.1:0'],
                              capture_output=True, text=True, timeout=LIMIT)
    second = try_to_start(bench.work)
    require(second.returncode == 5 and bench.work in second.stderr and f'process {bench.coordinator.pid} ' in second.stderr,
            f'a second coordinator: {second}')
    folder = os.path.join(bench.folder, 'foreign')
    os.makedirs(folder)
    path = os.path.join(folder, 'journal.sqlite')
    with open(path, 'w') as file:
        file.write('a diary of some other kind\n' * 100)
    before = content(path)
    foreign = try_to_start(folder)
    require(foreign.returncode == 4 and path in foreign.stderr and content(path) == before, f'a foreign journal: {foreign}')


def print_figures(figures, each):
    back, serving = sorted(figures.back), sorted(figures.serving)
    print(f'{figures.at_random} kills at random, {figures.told} just after an answer, {sum(figures.reached.values())} at {len(figures.reached)} durable writes, '
          f'{each} failed commits, {each} full disks, {figures.jobs} jobs: every byte as undisturbed, 0 tasks lost, 0 committed twice')
    print(f'{figures.again} tasks done again (at most {figures.in_flight} were in flight), serving again after '
          f'{serving[len(serving) // 2]:.2f} s (median), {serving[-1]:.2f} s (most), at work again after '
          f'{back[len(back) // 2]:.2f} s (median), {back[-1]:.2f} s (most)')


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    for name, number in (('kills', 300), ('each', 5), ('seed', 1)):
        parser.add_argument('--' + name, type=int, default=number)
    for name, text in (('scene', ''), ('options', ''), ('failpoints', ','.join(FAILPOINTS))):
        parser.add_argument('--' + name, default=text)
    return parser.parse_args()


def make_scene(bench, name, side, cell, spacing):
    scene = os.path.join(bench.folder, name)
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', str(side), '--rows', str(side), '--cell',
                    str(cell), '--spacing', str(spacing)], check=True, stdout=subprocess.DEVNULL)
    return scene


def run_all(bench, arguments, figures):
    reference = os.path.join(bench.folder, 'reference')
    scene = os.path.abspath(arguments.scene) if arguments.scene else make_scene(bench, 'scene', 4, 100, 1)
    start = time.time()
    bench.run_undisturbed(scene, reference)
    seconds = time.time() - start
    bench.start()
    bench.await_serving()
    bench.add_workers()
    check_refusals(bench)
    check_told_stays(bench, scene, figures, arguments.each)
    kill_at_random(bench, scene, reference, figures, arguments.kills, seconds, random.Random(arguments.seed))
    figures.at_random = figures.kills
    kill_at_failpoints(bench, scene, reference, figures, arguments.each, [n for n in arguments.failpoints.split(',') if n])
    fail_commits(bench, scene, reference, figures, arguments.each)
    fill_the_disk(bench, figures, arguments.each)


def main():
    arguments = parse_arguments()
    figures = Figures()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, folder, arguments.options.split())
        try:
            run_all(bench, arguments, figures)
        except Failure as failure:
            print(f'FAILED after {figures.kills} kills in {figures.jobs} jobs: {failure}')
            sys.exit(1)
        finally:
            bench.close()
    print_figures(figures, arguments.each)


if __name__ == '__main__':
    main()
