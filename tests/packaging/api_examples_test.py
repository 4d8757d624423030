#!/usr/bin/env python3
"""Runs every curl and grpcurl command of docs/api.md, and asks as each role over HTTPS: api_examples_test.py BIN

Without grpcurl, grpcurl.py beside this file stands in for it. Exit code 77 (skipped, and says so) without curl or openssl.
"""
import contextlib
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
HEALTH = '''syntax = "proto3"; package grpc.health.v1;
message HealthCheckRequest { string service = 1; }
message HealthCheckResponse { enum Status { UNKNOWN = 0; SERVING = 1; } Status status = 1; }
service Health { rpc Check(HealthCheckRequest) returns (HealthCheckResponse); }
'''
# What the answer has, by a part of the command.
EXPECTED = {
    '/v1/jobs/4f1d6c0a9be2/priority': '"priority":10', '/v1/jobs/4f1d6c0a9be2/watch': '"cursor":', '/v1/jobs/4f1d6c0a9be2': '"state":"RUNNING"', '/v1/workers': '{',
    'list tilemend.v1.Jobs': 'tilemend.v1.Jobs.WatchJob', 'describe tilemend.v1.Job': 'cursor',
    'Jobs/CreateJob': '"jobs/', 'Jobs/GetJob': '"RUNNING"', 'Workers/ListWorkers': '{', 'Jobs/ListJobs': '{',
    'Health/Check': '"SERVING"'}
# What GET /v1/me answers to certificates: watch and more may see.
ME = {'watch': (False, False), 'submit': (True, False), 'admin': (True, True), 'worker': None, 'scale': None}


def fail(why):
    sys.exit(f'FAILED: {why}')


class Coordinator:
    def __init__(self, ends, folder, name, *flags):
        work = os.path.join(folder, f'{name}-work')
        words = ['--work', work, '--listen', '127.0.0.1:0', '--web', '127.0.0.1:0', '--log', 'text', *flags]
        self.process = subprocess.Popen([os.path.join(BIN, 'tilemend-coordinator'), *words], stderr=subprocess.PIPE,
                                        text=True, cwd=folder)
        ends.callback(self.end)
        self.ports, log = {}, []
        for line in self.process.stderr:
            log.append(line)
            said = re.search(r'info (page served|listening) address=\S*:(\d+)', line)
            if said:
                self.ports['7080' if said.group(1) == 'page served' else '7070'] = said.group(2)
            if len(self.ports) == 2:
                return
        fail(f'the coordinator {name} ended\n{"".join(log)}')

    def end(self):
        self.process.terminate()
        self.process.wait()
        self.process.stderr.close()


def commands():
    """Those of the blocks of shell in docs/api.md, each on one line."""
    with open(os.path.join(ROOT, 'docs/api.md'), encoding='utf-8') as file:
        blocks = re.findall(r'^```sh\n(.*?)^```', file.read(), re.M | re.S)
    lines = ''.join(blocks).replace('\\\n', ' ').splitlines()
    return [line for line in lines if line.split()[0] in ('curl', 'grpcurl')]


class Trial:
    def __init__(self, ends, folder):
        self.folder = folder
        subprocess.run([os.path.join(ROOT, 'scripts/make_certificates.sh'), folder], check=True, stderr=subprocess.DEVNULL)
        self.write('token', 'word')
        self.write('tokens', f'ann submit {hashlib.sha256(b"word").hexdigest()}\n')
        self.write('health.proto', HEALTH)
        programs = os.path.join(folder, 'programs')
        os.mkdir(programs)
        if not shutil.which('grpcurl'):
            self.write('programs/grpcurl', f'#!/bin/sh\nexec {sys.executable} {HERE}/grpcurl.py "$@"\n')
            os.chmod(os.path.join(programs, 'grpcurl'), 0o755)
        self.env = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", CURL_CA_BUNDLE='ca.pem')
        subprocess.run([os.path.join(BIN, 'tilemend-make-scene'), os.path.join(folder, 'scene'), '--cols', '1', '--rows', '1',
                        '--spacing', '10'], check=True, stdout=subprocess.DEVNULL)
        tls = ('--tls-cert', 'coordinator.pem', '--tls-key', 'coordinator.key')
        flags = {'plain': (), 'token': (*tls, '--tokens', 'tokens'), 'certificate': (*tls, '--tls-ca', 'ca.pem')}
        self.coordinators = {kind: Coordinator(ends, folder, kind, *more) for kind, more in flags.items()}
        self.jobs = {}

    def write(self, name, text):
        with open(os.path.join(self.folder, name), 'w', opener=lambda path, flags: os.open(path, flags, 0o600)) as file:
            file.write(text)

    def run(self, command, kind):
        """What the command prints, asked of the coordinator of that kind and about a job of its own."""
        for port, real in self.coordinators[kind].ports.items():
            command = command.replace(f'HOST:{port}', f'localhost:{real}')
        command = command.replace('/data/', f'{self.folder}/').replace('4f1d6c0a9be2', self.jobs.get(kind, ''))
        done = subprocess.run(['bash', '-c', command], env=self.env, cwd=self.folder, capture_output=True, text=True, timeout=60)
        return done.returncode, done.stdout, done.stderr

    def example(self, command):
        kind = 'token' if 'cat token' in command else 'certificate' if '-cert ' in command else 'plain'
        name = next((part for part in EXPECTED if part in command), None)
        if name is None:
            fail(f'nothing is expected of {command!r}; see EXPECTED')
        if '4f1d6c0a9be2' in command and kind not in self.jobs:
            self.create(kind)
        code, text, errors = self.run(command, kind)
        if code or EXPECTED[name] not in text:
            fail(f'{command}\nexit code {code}, expected {EXPECTED[name]!r}\n{text}\n{errors}')
        if 'CreateJob' in command:
            self.jobs[kind] = json.loads(text)['name'].split('/')[1]

    def create(self, kind):
        proof = {'plain': '-plaintext', 'token': '-cacert ca.pem -H "authorization: Bearer $(cat token)"'}[kind]
        code, text, errors = self.run(
            f'grpcurl {proof} -d \'{{"spec": {{"scene": "/data/scene", "out": "/data/{kind}-out"}}}}\' HOST:7070 '
            'tilemend.v1.Jobs/CreateJob', kind)
        if code:
            fail(f'CreateJob: {errors}')
        self.jobs[kind] = json.loads(text)['name'].split('/')[1]

    def check_certificates(self):
        """Over HTTPS with --tls-ca: roles count as over gRPC, and whoever has none of that authority gets no answer."""
        def curl(who, path):
            return self.run(f"curl -s --compressed -w '\\n%{{http_code}}' --cert {who}.pem --key {who}.key https://HOST:7080{path}", 'certificate')

        for who, expected in ME.items():
            body, status = curl(who, '/v1/me')[1].rsplit('\n', 1)
            answer = json.loads(body)
            listen = answer.pop('listen', '')
            if expected and (status, answer, ':' in listen) != ('200', {'name': who, 'maySteer': expected[0], 'isAdmin': expected[1]}, True):
                fail(f'/v1/me as {who}: {status} {body}')
            if not expected and (status, answer['error']['reason']) != ('403', 'ROLE_NEEDED'):
                fail(f'/v1/me as {who}: {status} {body}')
        for page in ('/', '/console.js', '/v1/openapi.json'):
            if not curl('watch', page)[1].endswith('\n200'):
                fail(f'{page} is not served to a certificate')
        subprocess.run([os.path.join(ROOT, 'scripts/make_certificates.sh'), os.path.join(self.folder, 'foreign')], check=True,
                       stderr=subprocess.DEVNULL)
        for refused in ('', '--cert foreign/admin.pem --key foreign/admin.key', '--cert coordinator.pem --key coordinator.key',
                        '-H "Authorization: Bearer $(cat token)"'):
            code, text, _ = self.run(f'curl -s {refused} https://HOST:7080/v1/me', 'certificate')
            if code == 0 or text:
                fail(f'curl {refused}: exit code {code}: {text}')


def main():
    for program in ('curl', 'openssl'):
        if not shutil.which(program):
            print(f'SKIPPED: there is no {program}')
            sys.exit(77)
    found = commands()
    if len(found) < len(EXPECTED):
        fail(f'docs/api.md has {len(found)} commands, of {len(EXPECTED)} that are known')
    with tempfile.TemporaryDirectory(prefix='tilemend-api-') as folder, contextlib.ExitStack() as ends:
        trial = Trial(ends, folder)
        for command in found:
            trial.example(command)
        trial.check_certificates()
    print(f'{len(found)} commands of docs/api.md, and certificates of {len(ME)} roles over HTTPS: passed')


if __name__ == '__main__':
    BIN = os.path.abspath(sys.argv[1])
    main()
