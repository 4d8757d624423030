#!/usr/bin/env python3
"""Renews all certificates again and again while a job is filled, and expects that no call fails: certificates_test.py BIN

The job is paused at the first change, so that one lies within it however fast it is; the others follow while it runs.
The folder of certificates is a link that is replaced, as Kubernetes does it. Then the files are spoiled where they stand,
and replaced one after the other: what was read before counts on, and the log says so. Exit code 77 (skipped, and says so) without
openssl.
"""
import json
import os
import re
import shutil
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

METRICS_TOKEN = 'a-token-for-readers'
ENDS = ('OK', 'ABORTED', 'CANCELLED')  # a worker that has news leaves its call for the next


class Program:
    """A program, its log as it comes, and the addresses that it tells."""

    def __init__(self, *words):
        self.process = subprocess.Popen(words + ('--log', 'json'), stderr=subprocess.PIPE, text=True)
        self.log, self.changed = [], threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self.process.stderr:
            with self.changed:
                self.log.append(json.loads(line))
                self.changed.notify_all()

    def await_event(self, event, start=0):
        """The first of them after `start` lines."""
        found = lambda: next((entry for entry in self.log[start:] if entry['event'] == event), None)
        with self.changed:
            if not self.changed.wait_for(found, timeout=60):
                raise SystemExit(f'FAILED: waited in vain for {event}')
            return found()

    def port(self, event):
        return self.await_event(event)['address'].rsplit(':', 1)[1]


class Certificates:
    def __init__(self, folder):
        self.folder, self.current, self.count = folder, os.path.join(folder, 'tls'), 0
        self.callers = self.current  # where workers and clients have theirs
        self.renew()

    def renew(self):
        """New ones by the same authority, all in one step."""
        self.count += 1
        fresh = f'{self.current}-{self.count}'
        if self.count > 1:
            shutil.copytree(os.path.realpath(self.current), fresh)
        subprocess.run([os.path.join(ROOT, 'scripts/make_certificates.sh'), fresh], check=True, stderr=subprocess.DEVNULL)
        os.symlink(fresh, fresh + '-link')
        os.rename(fresh + '-link', self.current)

    def part_callers(self):
        """From now on the coordinator's are in a folder of its own."""
        self.callers = os.path.join(self.folder, 'callers')
        shutil.copytree(os.path.realpath(self.current), self.callers)

    def path(self, file):
        return os.path.join(self.callers if file.split('.')[0] in ('worker', 'submit') else self.current, file)

    def write(self, file, text):
        """In place, as an editor or `cp` does it."""
        with open(self.path(file), 'w') as out:
            out.write(text)

    def text(self, file):
        with open(self.path(file)) as read:
            return read.read()

    def flags(self, name):
        path = lambda file: os.path.join(self.current if name == 'coordinator' else self.callers, file)
        return ('--tls-ca', path('ca.pem'), '--tls-cert', path(f'{name}.pem'), '--tls-key', path(f'{name}.key'))


def serial(*source):
    certificate = subprocess.run(['openssl', *source], input='', text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    shown = subprocess.run(['openssl', 'x509', '-noout', '-serial'], input=certificate.stdout, text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return shown.stdout.strip()


class Cluster:
    def __init__(self, bin_folder, folder):
        self.bin, self.folder, self.tls = bin_folder, folder, Certificates(folder)
        self.scene = os.path.join(folder, 'scene')
        shutil.copy(os.path.join(self.tls.current, 'ca.pem'), os.path.join(folder, 'authority.pem'))
        with open(os.path.join(folder, 'metrics.token'), 'w') as file:
            file.write(METRICS_TOKEN)
        subprocess.run([self.program('tilemend-make-scene'), self.scene, '--cols', '6', '--rows', '4', '--holes', 'lakes,small'],
                       check=True, stdout=subprocess.DEVNULL)
        self.coordinator = Program(self.program('tilemend-coordinator'), '--work', os.path.join(folder, 'work'), '--listen',
                                   '127.0.0.1:0', '--metrics', '127.0.0.1:0', '--metrics-tls', '--metrics-token',
                                   os.path.join(folder, 'metrics.token'), *self.tls.flags('coordinator'))
        self.address = f'localhost:{self.coordinator.port("listening")}'
        self.programs = [self.coordinator]

    def start_worker(self):
        worker = Program(self.program('tilemend-worker'), '--coordinator', self.address, '--threads', '1',
                         *self.tls.flags('worker'))
        self.programs.append(worker)
        worker.await_event('connected')
        return worker

    def program(self, name):
        return os.path.join(self.bin, name)

    def client(self, *words):
        done = subprocess.run([self.program('tilemend'), *words, '-o', 'json', '--coordinator', self.address,
                               *self.tls.flags('submit')], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if done.returncode:
            raise SystemExit(f'FAILED: {" ".join(words)}: code {done.returncode}: {done.stderr}')
        return json.loads(done.stdout)

    def await_new_certificate(self):
        """New connections see it."""
        wanted = serial('x509', '-in', os.path.join(self.tls.current, 'coordinator.pem'))
        end = time.monotonic() + 60
        while serial('s_client', '-connect', self.address) != wanted:
            if time.monotonic() > end:
                raise SystemExit('FAILED: the coordinator never showed its new certificate')
            time.sleep(0.1)

    def metrics(self):
        context = ssl.create_default_context(cafile=os.path.join(self.tls.folder, 'authority.pem'))
        context.check_hostname = False
        request = urllib.request.Request(f'https://127.0.0.1:{self.coordinator.port("metrics served")}/metrics',
                                         headers={'Authorization': 'Bearer ' + METRICS_TOKEN})
        with urllib.request.urlopen(request, context=context) as answer:
            return answer.read().decode()

    def failed_calls(self):
        text = self.metrics()
        counts = re.findall(r'tilemend_coordinator_rpcs_total\{code="(\w+)",rpc="([\w./]+)"\} (\S+)', text)
        if not any(code == 'OK' and rpc.endswith('/Sync') for code, rpc, _ in counts):
            raise SystemExit(f'FAILED: no calls are counted: {counts}')
        return {f'{rpc} {code}': float(count) for code, rpc, count in counts if code not in ENDS and float(count)}

    def stop(self):
        for program in self.programs:
            program.process.kill()
            program.process.wait()


def play(cluster):
    name = cluster.client('submit', cluster.scene, '--out', os.path.join(cluster.folder, 'out'))['name']
    cluster.client('pause', name)
    worker = cluster.start_worker()
    cluster.tls.renew()
    cluster.await_new_certificate()
    if cluster.client('get', name)['state'] != 'running':
        raise SystemExit('FAILED: the job did not wait')
    cluster.client('resume', name)
    while cluster.client('get', name)['state'] == 'running':
        cluster.tls.renew()
    job = cluster.client('get', name)
    if job['state'] not in ('done', 'partial'):
        raise SystemExit(f'FAILED: {job}')
    lost = [entry for entry in worker.log if entry['event'] == 'not connected']
    if cluster.failed_calls() or lost:
        raise SystemExit(f'FAILED: {cluster.failed_calls()}, {lost}')
    print(f'{cluster.tls.count - 1} changes of all certificates while a job ran: no call failed')


def spoil(cluster, program, file, text):
    """Writes something else over a file of a running program; gives it back when the log has said so."""
    right, told = cluster.tls.text(file), len(program.log)
    cluster.tls.write(file, text)
    entry = program.await_event('certificates not read', told)
    if file.split('.')[0] not in entry['error'] or entry['in_use'] != 'what was read before':
        raise SystemExit(f'FAILED: {entry}')
    return right


def play_with_spoiled_files(cluster):
    """Whoever comes anew is let in by what was read before, until there is something in order again."""
    shown = lambda: serial('s_client', '-connect', cluster.address)
    cluster.await_new_certificate()
    cluster.tls.part_callers()
    before, faults = shown(), 0
    certificate = cluster.tls.text('coordinator.pem')
    for file, text in (('coordinator.pem', 'garbage'), ('coordinator.pem', certificate[:len(certificate) // 2]),
                       ('coordinator.key', ''), ('ca.pem', '-----BEGIN CERTIFICATE-----\n')):
        right = spoil(cluster, cluster.coordinator, file, text)
        time.sleep(3)  # longer than anything here takes to look at a file again
        cluster.client('workers')
        cluster.start_worker()
        cluster.metrics()
        if shown() != before:
            raise SystemExit(f'FAILED: another certificate is shown after {file} was spoiled')
        cluster.tls.write(file, right)
        time.sleep(2)  # it is seen to be right: else the next fault could be the same one
        faults += 1
    worker = cluster.programs[-1]
    right = spoil(cluster, worker, 'worker.key', 'garbage')
    cluster.tls.write('worker.key', right)
    change_one_by_one(cluster, shown)
    print(f'{faults + 1} files were spoiled: what was read before counted on')


def change_one_by_one(cluster, shown):
    """Certificate first, key later: the pair is taken when it is one."""
    old = os.path.realpath(cluster.tls.current)
    cluster.tls.renew()
    fresh = {name: cluster.tls.text(name) for name in ('coordinator.pem', 'coordinator.key')}
    os.remove(cluster.tls.current)
    os.symlink(old, cluster.tls.current)
    cluster.await_new_certificate()  # the one of before
    spoil(cluster, cluster.coordinator, 'coordinator.pem', fresh['coordinator.pem'])
    cluster.client('workers')
    cluster.tls.write('coordinator.key', fresh['coordinator.key'])
    cluster.await_new_certificate()
    cluster.client('workers')


def main():
    if not shutil.which('openssl'):
        print('SKIPPED: there is no openssl')
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix='tilemend-certificates-') as folder:
        cluster = Cluster(os.path.abspath(sys.argv[1]), folder)
        try:
            play(cluster)
            play_with_spoiled_files(cluster)
        finally:
            cluster.stop()


if __name__ == '__main__':
    main()
