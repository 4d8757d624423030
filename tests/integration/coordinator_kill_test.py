#!/usr/bin/env python3
"""Kills a coordinator at random moments and at every durable write, and holds what comes of it to an undisturbed run.

    coordinator_kill_test.py BIN [--kills 300] [--each 5] [--seed 1] [--failpoints NAME,NAME]
                            [--scene SCENE] [--options "of the job"] [--seconds LONGEST]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. A job runs on a made scene with two
workers. The coordinator is killed (SIGKILL), a new one is started on the same folder, and so on until the job is over.
Then every file of the output must be that of the undisturbed run (report.json but for dates and seconds), no task may
have been committed twice or forgotten, no more tasks may have run than were in flight at the kills, and nothing may be
left in the output or in the work folder. Prints what was reached every 20 seconds and its figures at the end. Exit code
1 if anything was not so; 3, with the figures of what was reached, after --seconds, SIGTERM or SIGINT.
"""
import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from cluster_harness import LIMIT, THREADS, Bench, Failure, await_, check_output, content, files, require

FAILPOINTS = ['journal.make', 'journal.commit', 'journal.committed', 'journal.checkpointed', 'journal.tidy', 'blob.sync',
              'blob.renamed', 'restore.swept', 'output.claimed', 'file.written', 'file.renamed', 'file.moved',
              'job.finished', 'job.released']
# What is reached only by a coordinator that starts again.
ONLY_AGAIN = {'restore.swept'}
LARGEST_FILE = 900000  # bytes: less than the journal's log of 64 small cells, more than any other file of theirs
STOPPED = 3  # exit code
IN_FLIGHT = sum(2 * threads + 2 for threads in THREADS)  # tasks that workers hold at most


class Stopped(Exception):
    """By whoever started the harness, or by --seconds."""


class Figures:
    def __init__(self):
        self.kills, self.jobs, self.again, self.in_flight = 0, 0, 0, 0
        self.told, self.failed_commits, self.full_disks = 0, 0, 0
        self.at_random = None  # until they are over
        self.serving, self.back = [], []  # seconds from the start of a coordinator
        self.reached = {}
        self.start = self.shown = time.time()

    def job_is_over(self, kills, again):
        """As it should be; shows where things are from time to time."""
        self.jobs += 1
        self.kills += kills
        self.again += again
        self.in_flight += kills * IN_FLIGHT
        if time.time() > self.shown + 20:
            self.shown = time.time()
            print(f'{self.shown - self.start:.0f} s: {self}', flush=True)

    def __str__(self):
        at_random = self.kills if self.at_random is None else self.at_random
        text = (f'{at_random} kills at random, {self.told} just after an answer, {sum(self.reached.values())} at '
                f'{len(self.reached)} durable writes, {self.failed_commits} failed commits, {self.full_disks} full disks, '
                f'{self.jobs} jobs: every byte as undisturbed, 0 tasks lost, 0 committed twice, {self.again} done again '
                f'(at most {self.in_flight} were in flight)')
        for what, seconds in (('serving', sorted(self.serving)), ('at work', sorted(self.back))):
            if seconds:
                text += f', {what} again after {seconds[len(seconds) // 2]:.2f} s (median), {seconds[-1]:.2f} s (most)'
        return text


class JobRun:
    """One job from submit to its end, with kills in between."""

    def __init__(self, bench, scene, reference, figures, number):
        self.bench, self.scene, self.reference, self.figures = bench, scene, reference, figures
        self.out = os.path.join(bench.folder, f'out{number}')
        self.ran_before, self.verified_before = bench.tasks_run(), bench.tasks_run('verify')
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
        # What was verified before a kill is not among the tasks of the last coordinator.
        verified = self.bench.tasks_run('verify') - self.verified_before
        most = self.kills * IN_FLIGHT + int(progress['tasks_retried']) + verified
        require(0 <= again <= most, f'{again} tasks were done again at {self.kills} kills')
        await_('the work folder to be empty', lambda: not files(os.path.join(self.bench.work, 'jobs')))
        self.figures.job_is_over(self.kills, again)
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
    figures.at_random = figures.kills


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
        figures.failed_commits += 1


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
        figures.full_disks += 1


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


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    for name, number in (('kills', 300), ('each', 5), ('seed', 1), ('seconds', 0)):
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
    kill_at_failpoints(bench, scene, reference, figures, arguments.each, [n for n in arguments.failpoints.split(',') if n])
    fail_commits(bench, scene, reference, figures, arguments.each)
    fill_the_disk(bench, figures, arguments.each)


def stop(number, _):
    raise Stopped(signal.Signals(number).name)


def main():
    arguments = parse_arguments()
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGALRM):
        signal.signal(number, stop)
    signal.alarm(arguments.seconds)
    figures = Figures()
    code = 0
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, folder, arguments.options.split())
        try:
            run_all(bench, arguments, figures)
        except Failure as failure:
            print(f'FAILED: {failure}')
            code = 1
        except Stopped as stopped:
            print(f'STOPPED by {stopped} before the end')
            code = STOPPED
        finally:
            bench.close()
    print(figures)
    sys.exit(code)


if __name__ == '__main__':
    main()
