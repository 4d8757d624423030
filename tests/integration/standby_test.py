#!/usr/bin/env python3
"""Kills and stops the coordinator that is at work, of two with their journal in PostgreSQL.

    standby_test.py BIN [--kills 20] [--seed 1]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. A server of PostgreSQL is started in a
folder of its own; exit code 77 where there is none. Of two coordinators with one work folder one is at work and the
other stands by. While jobs run one after the other, the one at work is killed at a random moment (or, each fourth time,
stopped until the other has taken over, then woken: it must end with code 5). The other must take over, and another one is
started to stand by. Every file of each output must be that of an undisturbed run. Prints its figures. Exit code 1 if
anything was not so.
"""
import argparse
import glob
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from cluster_harness import LIMIT, Bench, Failure, await_, check_output, require

SILENCE = 3  # seconds


class Postgres:
    def __init__(self, folder):
        self.data = os.path.join(folder, 'postgres')
        os.makedirs(self.data)
        self.user = ['runuser', '-u', 'postgres', '--'] if os.getuid() == 0 else []
        if self.user:
            os.chmod(folder, 0o755)
            shutil.chown(self.data, 'postgres')
        self.uri = f'host={self.data} user=tilemend dbname=postgres'
        self.run('initdb', '-A', 'trust', '-U', 'tilemend')
        self.run('pg_ctl', '-w', '-l', os.path.join(self.data, 'log'), '-o', f"-k {self.data} -c listen_addresses=''", 'start')

    @staticmethod
    def programs():
        return sorted(glob.glob('/usr/lib/postgresql/*/bin/initdb'))

    def run(self, program, *words):
        path = os.path.join(os.path.dirname(self.programs()[-1]), program)
        # The server that pg_ctl leaves behind must hold no pipe of ours.
        done = subprocess.run([*self.user, path, '-D', self.data, *words], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL, cwd='/')
        require(done.returncode == 0, f'{program}: exit code {done.returncode}')

    def close(self):
        self.run('pg_ctl', '-m', 'immediate', 'stop')


class Coordinator:
    def __init__(self, bench, postgres, number):
        self.log = os.path.join(bench.folder, f'coordinator{number}.log')
        self.process = subprocess.Popen(
            [bench.program('tilemend-coordinator'), '--work', bench.work, '--listen', bench.address, '--journal',
             postgres.uri, '--stand-by', str(SILENCE)], stderr=open(self.log, 'w'))

    def said(self):
        with open(self.log) as log:
            return log.read()

    def await_ready(self):
        await_('a coordinator to be at work or stand by', lambda: 'standing by' in self.said() or self.serves())

    def serves(self):
        require(self.process.poll() is None, f'a coordinator ended: {self.said()}')
        return '"listening"' in self.said()

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


class Pair:
    def __init__(self, bench, postgres):
        self.bench, self.postgres, self.count = bench, postgres, 0
        self.took = []  # seconds until the other served
        self.at_work = self.new()
        self.stands_by = self.new()
        self.kills = self.stops = 0

    def new(self):
        self.count += 1
        coordinator = Coordinator(self.bench, self.postgres, self.count)
        coordinator.await_ready()
        return coordinator

    def disturb(self, stop):
        old, self.at_work = self.at_work, self.stands_by
        begin = time.time()
        if stop:
            # Its port is its own until it ends: it wakes when the other has taken the epoch.
            old.process.send_signal(signal.SIGSTOP)
            await_('the other to take over', lambda: '"at work"' in self.at_work.said())
            old.process.send_signal(signal.SIGCONT)
            require(old.process.wait(timeout=LIMIT) == 5, f'exit code {old.process.returncode}: {old.said()}')
            # Stopped within a commit: the server has ended its connection, and at times its last words get lost.
            require(re.search('another coordinator has taken over|PostgreSQL: ', old.said()), old.said())
            self.stops += 1
            if not self.await_serving():
                self.at_work = self.new()
        else:
            old.end()
            self.kills += 1
            require(self.await_serving(), self.at_work.said())
        self.took.append(time.time() - begin)
        self.stands_by = self.new()

    def await_serving(self):
        """False if it ended, since the port was still another's."""
        await_('the other to serve', lambda: '"listening"' in self.at_work.said() or self.at_work.process.poll() is not None)
        return self.at_work.process.poll() is None

    def close(self):
        for coordinator in (self.at_work, self.stands_by):
            coordinator.end()


def run_all(bench, postgres, arguments):
    dice = random.Random(arguments.seed)
    scene, reference = os.path.join(bench.folder, 'scene'), os.path.join(bench.folder, 'reference')
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', '5', '--rows', '5', '--cell', '100', '--spacing',
                    '1'], check=True, stdout=subprocess.DEVNULL)
    bench.run_undisturbed(scene, reference)
    pair = Pair(bench, postgres)
    bench.add_workers()
    jobs = 0
    try:
        while pair.kills + pair.stops < arguments.kills:
            jobs += 1
            out = os.path.join(bench.folder, f'out{jobs}')
            client = bench.submit(scene, out, f'request {jobs}')
            while client.poll() is None and pair.kills + pair.stops < arguments.kills:
                time.sleep(dice.uniform(0.1, 2))
                if client.poll() is None:
                    pair.disturb((pair.kills + pair.stops) % 4 == 3)
            stdout, stderr = client.communicate(timeout=LIMIT)
            require(client.returncode == bench.code, f'exit code {client.returncode}: {stdout}{stderr}{pair.at_work.said()}')
            check_output(reference, out)
            shutil.rmtree(out)
    finally:
        pair.close()
    pair.took.sort()
    print(f'{jobs} jobs, the coordinator at work killed {pair.kills} times and stopped {pair.stops} times; the other served '
          f'after {pair.took[len(pair.took) // 2]:.1f} s (median), {pair.took[-1]:.1f} s (most) with {SILENCE} s of '
          'silence; each that woke was refused; no output differs')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('--kills', type=int, default=20)
    parser.add_argument('--seed', type=int, default=1)
    arguments = parser.parse_args()
    if not Postgres.programs():
        print('SKIPPED: PostgreSQL is not installed')
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        postgres = Postgres(folder)
        bench = Bench(arguments.bin, folder)
        try:
            run_all(bench, postgres, arguments)
        except Failure as failure:
            print(f'FAILED: {failure}')
            sys.exit(1)
        finally:
            bench.close()
            postgres.close()


if __name__ == '__main__':
    main()
