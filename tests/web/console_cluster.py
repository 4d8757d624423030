"""A coordinator with its page and a worker, for tests that use the page."""
import hashlib
import json
import os
import signal
import subprocess
import sys
import time
import urllib.request

from npm_packages import fail

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'integration'))
from free_port import free_port  # noqa: E402


class Cluster:
    def __init__(self, folder, programs):
        self.folder, self.programs = folder, programs
        self.address, self.web = f'127.0.0.1:{free_port()}', f'127.0.0.1:{free_port()}'
        with open(self.path('tokens'), 'w') as file:
            for name, role in (('ann', 'admin'), ('eve', 'watch'), ('wrk', 'worker')):
                file.write(f'{name} {role} {hashlib.sha256(name.encode()).hexdigest()}\n')
                with open(self.path(f'token_{name}'), 'w') as token:
                    token.write(name)
        os.chmod(self.path('tokens'), 0o600)
        self.coordinator = self.worker = None

    def path(self, name):
        return os.path.join(self.folder, name)

    def program(self, name):
        return os.path.join(self.programs, name)

    def start(self):
        self.coordinator = subprocess.Popen(
            [self.program('tilemend-coordinator'), '--work', self.path('work'), '--listen', self.address, '--web', self.web,
             '--tokens', self.path('tokens')], stderr=open(self.path('coordinator.log'), 'a'))
        end = time.time() + 30
        while time.time() < end:
            try:
                urllib.request.urlopen(f'http://{self.web}/', timeout=5).read()
                return
            except OSError:
                time.sleep(0.05)
        fail('the coordinator does not serve its page: ' + open(self.path('coordinator.log')).read())

    def kill(self):
        self.coordinator.send_signal(signal.SIGKILL)
        self.coordinator.wait()

    def start_worker(self):
        self.worker = subprocess.Popen(
            [self.program('tilemend-worker'), '--coordinator', self.address, '--threads', '1', '--token-file',
             self.path('token_wrk')], stderr=open(self.path('worker.log'), 'w'))

    def client(self, *words):
        done = subprocess.run([self.program('tilemend'), *words, '--coordinator', self.address, '--token-file', self.path('token_ann'),
                               '-o', 'json'], capture_output=True, text=True, timeout=120)
        if done.returncode not in (0, 4, 100):  # 4: a tile is broken
            fail(f'{words}: {done.stderr}')
        return done.stdout

    def submit(self, scene, *words):
        return json.loads(self.client('submit', scene, '--out', self.path('out_' + os.path.basename(scene)), *words))

    def close(self):
        for process in (self.coordinator, self.worker):
            if process is not None and process.poll() is None:
                process.kill()
                process.wait()
