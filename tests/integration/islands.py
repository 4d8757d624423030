"""Workers in network namespaces of their own, and jobs for them, for the tests of a cluster's network."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.request

from cluster_harness import LIMIT, Bench, Failure, check_output, metrics_port, require

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

    def start(self, bench, port, *words):
        self.log = os.path.join(bench.folder, f'{self.name}.log')
        self.worker = subprocess.Popen(
            ['ip', 'netns', 'exec', self.name, bench.program('tilemend-worker'), '--coordinator',
             f'{self.host}:{port}', '--insecure', '--threads', '1', *words],
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


def metric(port, name, host='127.0.0.1'):
    with urllib.request.urlopen(f'http://{host}:{port}/metrics', timeout=LIMIT) as answer:
        lines = answer.read().decode().splitlines()
    return sum(float(line.split()[-1]) for line in lines if line.startswith(name))


def connected(port):
    return int(metric(port, 'tilemend_coordinator_workers_connected'))


def start_coordinator(bench):
    bench.log = open(os.path.join(bench.folder, 'coordinator.log'), 'w+')
    bench.coordinator = subprocess.Popen(
        [bench.program('tilemend-coordinator'), '--work', bench.work, '--listen', f'0.0.0.0:{bench.port}', '--insecure',
         '--lease', '5', '--metrics', '127.0.0.1:0'], stderr=bench.log)
    require(bench.await_serving(), bench.said())
    return metrics_port(bench.said())


def skip_without_namespaces():
    """Ends the program where they cannot be made."""
    missing = [tool for tool in ('ip', 'iptables') if shutil.which(tool) is None]
    if os.geteuid() != 0 or missing or run('iptables', '-S').returncode != 0:
        print(f'SKIPPED: needs root, ip and iptables (missing: {missing}, user {os.geteuid()})')
        sys.exit(77)


def run_on_islands(run_all, arguments):
    """Calls run_all(bench, arguments, islands) with `arguments.workers` islands for the programs in `arguments.bin`."""
    skip_without_namespaces()
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
