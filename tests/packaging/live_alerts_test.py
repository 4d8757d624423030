#!/usr/bin/env python3
"""Stages faults in a cluster that a real Prometheus watches, and waits for the alerts: live_alerts_test.py BIN

The rules are those of deploy/prometheus, but for how long a condition must last (`for`), which is a second here, and for
how large a journal must be and how long it is looked at. The
names of all metrics are held to Prometheus' conventions (`promtool check metrics`), and to have no ids as labels. Exit
code 77 (skipped, and says so) without prometheus, promtool and openssl.
"""
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.parse
import urllib.request

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RULES = os.path.join(ROOT, 'deploy/prometheus/tilemend.rules.yml')
IDS = {'job', 'cell', 'hole', 'task', 'id', 'trace', 'worker', 'owner', 'path'}
CONFIGURATION = '''
global: {{scrape_interval: 500ms, evaluation_interval: 500ms}}
rule_files: [{rules}]
scrape_configs:
  - {{job_name: tilemend-coordinator, static_configs: [{{targets: ["127.0.0.1:{coordinator}"]}}]}}
  - {{job_name: tilemend-worker, static_configs: [{{targets: ["127.0.0.1:{worker}"]}}]}}
'''


def free_port():
    with socket.socket() as s:
        s.bind(('127.0.0.1', 0))
        return s.getsockname()[1]


def get(url):
    with urllib.request.urlopen(url, timeout=10) as answer:
        return answer.read().decode()


def await_(what, condition, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.1)
    raise SystemExit(f'FAILED: waited {seconds} s in vain for {what}')


class Stage:
    def __init__(self, bin_folder, folder):
        self.bin, self.folder, self.programs = bin_folder, folder, []
        self.address, self.metrics, self.prometheus, self.worker_metrics = (free_port() for _ in range(4))
        self.scene = os.path.join(folder, 'scene')
        subprocess.run([self.program('tilemend-make-scene'), self.scene, '--cols', '8', '--rows', '4', '--holes', 'lakes,small'],
                       check=True, stdout=subprocess.DEVNULL)

    def program(self, name):
        return os.path.join(self.bin, name)

    def run(self, *words):
        program = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=self.folder)
        self.programs.append(program)
        return program

    def start(self):
        self.coordinator = self.run(
            self.program('tilemend-coordinator'), '--work', os.path.join(self.folder, 'work'), '--lease', '3',
            '--listen', f'127.0.0.1:{self.address}', '--metrics', f'127.0.0.1:{self.metrics}')
        with open(RULES) as file:
            rules = re.sub(r'for: \d+m', 'for: 1s', file.read())
        rules = rules.replace('journal_bytes > 1e9', 'journal_bytes > 1e4').replace('journal_bytes[1h]', 'journal_bytes[10s]')
        for name, text in (('rules.yml', rules), ('prometheus.yml', CONFIGURATION.format(
                rules=os.path.join(self.folder, 'rules.yml'), coordinator=self.metrics, worker=self.worker_metrics))):
            with open(os.path.join(self.folder, name), 'w') as file:
                file.write(text)
        self.run('prometheus', f'--config.file={self.folder}/prometheus.yml', f'--storage.tsdb.path={self.folder}/series',
                 f'--web.listen-address=127.0.0.1:{self.prometheus}')
        await_('a scrape', lambda: self.ask('up{job="tilemend-coordinator"} == 1'))

    def ask(self, query):
        url = f'http://127.0.0.1:{self.prometheus}/api/v1/query?' + urllib.parse.urlencode({'query': query})
        try:
            return json.loads(get(url))['data']['result']
        except OSError:
            return []

    def firing(self):
        return {a['metric']['alertname'] for a in self.ask('ALERTS{alertstate="firing"}')}

    def await_alert(self, name, story):
        await_(f'{name}, as {story}', lambda: name in self.firing())
        print(f'{name}: {story}')

    def start_worker(self, *more):
        return self.run(self.program('tilemend-worker'), '--coordinator', f'127.0.0.1:{self.address}', '--threads', '1', *more)

    def client(self, *words):
        return subprocess.run([self.program('tilemend'), *words, '--coordinator', f'127.0.0.1:{self.address}'],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def submit(self, out, scene=None):
        out = os.path.join(self.folder, out)
        return json.loads(self.client('submit', scene or self.scene, '--out', out, '-o', 'json').stdout)['name']

    def job(self, name):
        return json.loads(self.client('get', name, '-o', 'json').stdout)

    def stop(self):
        for program in self.programs:
            program.kill()
            program.wait()


def check_names(port):
    text = get(f'http://127.0.0.1:{port}/metrics')
    done = subprocess.run(['promtool', 'check', 'metrics'], input=text, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode or done.stdout:
        raise SystemExit(f'FAILED: promtool check metrics: {done.stdout}')
    labels = set(re.findall(r'[{,](\w+)="', text))
    if labels & IDS:
        raise SystemExit(f'FAILED: ids as labels: {labels & IDS}')
    return len(re.findall('^# TYPE', text, re.M))


def holds_task(stage):
    return re.search('^tilemend_coordinator_tasks_running [1-9]', get(f'http://127.0.0.1:{stage.metrics}/metrics'), re.M)


def stop_with_task(stage, worker, name):
    """Stops the worker, and says whether it stands still with a task of this job."""
    worker.send_signal(signal.SIGSTOP)
    return holds_task(stage) and stage.job(name)['state'] == 'running'


def spoil_a_tile(stage, worker):
    """Changes a tile that is written while its job still runs: of the first of some short jobs in which that is met."""
    for attempt in range(20):
        name = stage.submit(f'spoiled{attempt}')
        tiles = os.path.join(stage.folder, f'spoiled{attempt}', 'tiles')
        end, written = time.monotonic() + 20, []
        while time.monotonic() < end and not written:
            written = [n for n in os.listdir(tiles) if n.endswith('.ply')] if os.path.isdir(tiles) else []
        running = stop_with_task(stage, worker, name)
        if written and running:
            with open(os.path.join(tiles, written[0]), 'a') as file:
                file.write('more')
        worker.send_signal(signal.SIGCONT)
        await_('the end of the job', lambda: stage.job(name)['state'] != 'running')
        if written and running:
            if stage.job(name)['state'] != 'failed':
                raise SystemExit('FAILED: a job with a spoiled tile did not fail')
            return
    raise SystemExit('FAILED: the worker was never stopped between two tiles')


def freeze_with_tasks(stage, worker):
    """Stops the worker while it holds a task: of the first of some short jobs in which that is met."""
    for attempt in range(20):
        name = stage.submit(f'frozen{attempt}')
        end = time.monotonic() + 20
        while time.monotonic() < end and not holds_task(stage):
            pass
        if stop_with_task(stage, worker, name):
            return
        worker.send_signal(signal.SIGCONT)
    raise SystemExit('FAILED: the worker was never stopped with a task')


def fail_tasks(stage):
    """Jobs on a scene whose only tile is none, until they are more than one attempt in twenty."""
    bad = os.path.join(stage.folder, 'bad')
    os.mkdir(bad)
    for name, text in (('a.ply', 'no mesh'), ('scene.json', json.dumps({
            'cell_size': 10, 'cols': 1, 'rows': 1, 'tiles': [{'col': 0, 'row': 0, 'path': 'a.ply'}]}))):
        with open(os.path.join(bad, name), 'w') as file:
            file.write(text)
    count = 0
    while 'TilemendFailureRatio' not in stage.firing():
        jobs = [stage.submit(f'failed{count + i}', bad) for i in range(30)]
        await_('the end of these jobs', lambda: all(stage.job(name)['state'] == 'failed' for name in jobs))
        count += len(jobs)
        if count > 2000:
            raise SystemExit('FAILED: TilemendFailureRatio does not fire')
    print(f'TilemendFailureRatio: a tile is none, in {count} jobs')


def is_written(file, since):
    try:
        return file.stat().st_size > 0 and file.stat().st_mtime > since
    except FileNotFoundError:
        return False


def spoil_a_result(stage):
    """Changes what a worker has written before the coordinator looks at it, while another worker is there. Nobody knows
    which worker it will be: both end."""
    workers = [stage.start_worker() for _ in range(2)]
    wide = os.path.join(stage.folder, 'wide')
    subprocess.run([stage.program('tilemend-make-scene'), wide, '--cols', '20', '--rows', '20', '--holes', 'lakes,small'],
                   check=True, stdout=subprocess.DEVNULL)
    await_('two workers', lambda: stage.ask('tilemend_coordinator_workers_connected >= 2'))
    for attempt in range(20):
        name = stage.submit(f'lied{attempt}', wide)
        out = os.path.join(stage.folder, f'lied{attempt}')
        attempts = os.path.join(out, '.tilemend-attempts')
        tiles = os.path.join(out, 'tiles')
        while stage.job(name)['state'] == 'running' and not (os.path.isdir(tiles) and os.listdir(tiles)):
            time.sleep(0.002)
        stage.coordinator.send_signal(signal.SIGSTOP)
        stopped, written = time.time(), []
        while time.time() < stopped + 1 and not written and os.path.isdir(attempts):
            written = [f.path for f in os.scandir(attempts) if f.name != 'key' and is_written(f, stopped)]
        for path in written:
            with open(path, 'r+b') as file:
                file.write(b'x')
        stage.coordinator.send_signal(signal.SIGCONT)
        if written:
            return workers
        await_('the end of the job', lambda: stage.job(name)['state'] != 'running')
    raise SystemExit('FAILED: no worker wrote while the coordinator stood still')


def confine(process):
    """Puts a process into a control group that has little more memory than it uses; gives the group, or None where none can
    be made."""
    with open(f'/proc/{process.pid}/status') as file:
        used = int(re.search(r'VmRSS:\s+(\d+) kB', file.read())[1]) << 10
    own = dict(line.strip().split(':', 2)[1:] for line in open('/proc/self/cgroup'))
    for group, limit in ((f'/sys/fs/cgroup/memory{own.get("memory", "")}', 'memory.limit_in_bytes'),
                         (f'/sys/fs/cgroup{own.get("", "")}', 'memory.max')):
        group = f'{group}/tilemend-{process.pid}'
        try:
            os.mkdir(group)
            for name, value in ((limit, used * 105 // 100), ('cgroup.procs', process.pid)):
                with open(f'{group}/{name}', 'w') as file:
                    file.write(str(value))
            return group
        except OSError:
            if os.path.isdir(group):
                os.rmdir(group)
    return None


def fill_memory(stage, worker):
    group = confine(worker)
    if group is None:
        print('SKIPPED TilemendMemoryNearLimit: no control group can be made here')
        return
    stage.await_alert('TilemendMemoryNearLimit', 'a worker uses nearly all that its control group has')
    with open(f'{os.path.dirname(group)}/cgroup.procs', 'w') as file:
        file.write(str(worker.pid))
    os.rmdir(group)


def grow_journal(stage):
    count = 0
    while 'TilemendJournalGrowing' not in stage.firing():
        stage.submit(f'journal{count}', os.path.join(stage.folder, 'bad'))
        count += 1
        if count > 2000:
            raise SystemExit('FAILED: TilemendJournalGrowing does not fire')
    print(f'TilemendJournalGrowing: {count} jobs one after the other')


def let_a_certificate_end(stage):
    """A worker has one for six days."""
    key, certificate = (os.path.join(stage.folder, f'short.{kind}') for kind in ('key', 'pem'))
    subprocess.run(['openssl', 'req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:P-256', '-nodes', '-subj',
                    '/CN=worker', '-days', '6', '-keyout', key, '-out', certificate], check=True, stderr=subprocess.DEVNULL)
    worker = stage.start_worker('--metrics', f'127.0.0.1:{stage.worker_metrics}', '--tls-cert', certificate, '--tls-key', key)
    stage.await_alert('TilemendCertificateExpires', 'a certificate ends in six days')
    worker.kill()
    worker.wait()


def play(stage):
    stage.start()
    probe = stage.start_worker('--metrics', f'127.0.0.1:{stage.worker_metrics}')
    await_('a worker', lambda: stage.ask('tilemend_coordinator_workers_connected == 1'))
    print(f'{check_names(stage.metrics)} metrics of the coordinator and {check_names(stage.worker_metrics)} of a worker')
    if stage.firing():
        raise SystemExit(f'FAILED: alerts without a fault: {stage.firing()}')

    fill_memory(stage, probe)
    probe.terminate()
    probe.wait()
    await_('no worker', lambda: stage.ask('tilemend_coordinator_workers_connected == 0'))
    let_a_certificate_end(stage)
    name = stage.submit('first')
    stage.await_alert('TilemendNoProgress', 'a job has no worker')
    elsewhere = os.path.join(stage.folder, 'elsewhere')
    os.mkdir(elsewhere)
    blind = stage.start_worker('--root', elsewhere)
    stage.await_alert('TilemendWorkerBlind', 'a worker has not mounted the folder of a job')
    blind.terminate()
    blind.wait()
    worker = stage.start_worker()
    await_('the end of the job', lambda: stage.job(name)['state'] != 'running')
    await_('rest', lambda: not stage.firing() - {'TilemendNoFreeSlots'})
    play_with_workers(stage, worker)


def play_with_workers(stage, worker):
    spoil_a_tile(stage, worker)
    stage.await_alert('TilemendOutputMismatch', 'somebody changed a tile of a job that runs')
    stage.await_alert('TilemendJobFailed', 'that job failed')
    if 'TilemendFailureRatio' in stage.firing():
        raise SystemExit('FAILED: TilemendFailureRatio fires already')
    fail_tasks(stage)
    grow_journal(stage)

    worker.terminate()
    worker.wait()
    liars = spoil_a_result(stage)
    stage.await_alert('TilemendWorkerSetAside', 'a byte was changed of what a worker had written')
    for liar in liars:
        liar.terminate()
        liar.wait()
    worker = stage.start_worker()
    freeze_with_tasks(stage, worker)
    stage.await_alert('TilemendNoFreeSlots', 'one worker for many tasks')
    stage.await_alert('TilemendWorkerLost', 'that worker fell silent')
    stage.coordinator.kill()
    stage.await_alert('TilemendCoordinatorDown', 'the coordinator was killed')


def main():
    missing = [name for name in ('prometheus', 'promtool', 'openssl') if not shutil.which(name)]
    if missing:
        print(f'SKIPPED: there is no {", ".join(missing)} (apt-get install prometheus openssl)')
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix='tilemend-alerts-') as folder:
        stage = Stage(os.path.abspath(sys.argv[1]), folder)
        try:
            play(stage)
        finally:
            stage.stop()


if __name__ == '__main__':
    main()
