"""A work folder, its coordinators and workers, for the tests that kill them; and what an output must be."""
import glob
import json
import os
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

THREADS = [1, 1]  # of the workers
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
        self.submitted = None  # the client of the last job

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

    def tasks_run(self, stage=''):
        """Of one stage, or all."""
        total = 0
        for port in self.worker_ports:
            with urllib.request.urlopen(f'http://127.0.0.1:{port}/metrics') as answer:
                for line in answer.read().decode().splitlines():
                    if line.startswith('tilemend_worker_tasks_started_total') and stage in line:
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
        self.submitted = subprocess.Popen(
            [self.program('tilemend'), 'submit', scene, '--out', out, '--coordinator', self.address, '--request-id', request,
             '--wait', '-o', 'json', *self.options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        return self.submitted

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
        for process in [*self.workers, self.coordinator, self.submitted]:
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


# Made from report.json, with its date; by `run` alone.
NOT_COMPARED = {'.tilemend-results', 'report.html', 'holes.csv'}


def files(folder):
    return {os.path.relpath(os.path.join(where, name), folder)
            for where, _, names in os.walk(folder) for name in names if name not in NOT_COMPARED}


def check_output(reference, out):
    wanted, found = files(reference), files(out)
    require(wanted == found, f'missing {sorted(wanted - found)}, too many {sorted(found - wanted)}')
    wrong = [name for name in sorted(wanted) if content(os.path.join(reference, name)) != content(os.path.join(out, name))]
    require(not wrong, f'other bytes: {wrong}')


def run_attack(attack):
    """The exit code of a test that calls `attack` with a bench for the programs in the folder sys.argv[1].

    A bench has a folder of its own, bench.folder, which is removed at the end.
    """
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(sys.argv[1], folder)
        try:
            attack(bench)
        except Failure as failure:
            print(failure)
            return 1
        finally:
            bench.close()
    return 0
