#!/usr/bin/env python3
"""Holds the units of deploy/systemd to systemd, and runs what they start as systemd would: systemd_test.py BIN

`systemd-analyze` reads the units and says how much they could do to the machine. Then the programs run with a socket
for their notifications: they must say that they are ready, beat as often as the watchdog wants, fall silent while they
are stopped, and say that they end. Exit code 77 (skipped, and says so) without systemd-analyze. package_test.py runs the
units under a real systemd.
"""
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MOST_EXPOSURE = 1.6  # of 10
WATCHDOG_SECONDS = 0.5


def fail(text):
    raise SystemExit(f'FAILED: {text}')


def unit_text(name):
    with open(os.path.join(ROOT, 'deploy/systemd', name + '.service')) as file:
        return file.read()


def check_unit(name, bin_folder, folder):
    text = unit_text(name)
    path = os.path.join(folder, name + '.service')
    with open(path, 'w') as file:
        file.write(text.replace('/usr/bin/', bin_folder + '/').replace('User=tilemend', 'User=games').replace(
            'Group=tilemend', 'Group=games'))
    done = subprocess.run(['systemd-analyze', 'verify', '--man=no', path], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    complaints = [line for line in done.stdout.splitlines() if name in line]
    if complaints:
        fail('\n'.join(complaints))
    said = subprocess.run(['systemd-analyze', 'security', '--offline=true', path], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT).stdout
    exposure = float(re.search(r'Overall exposure level for \S+: ([\d.]+)', said).group(1))
    if exposure > MOST_EXPOSURE:
        fail(f'{name}: exposure {exposure}; at most {MOST_EXPOSURE}')
    print(f'{name}: exposure {exposure} of 10')


class Manager:
    """The end of systemd that hears notifications."""

    def __init__(self, folder):
        self.path = os.path.join(folder, 'notify')
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(self.path)

    def start(self, words):
        env = dict(os.environ, NOTIFY_SOCKET=self.path, WATCHDOG_USEC=str(int(WATCHDOG_SECONDS * 1e6)))
        return subprocess.Popen(words, env=env, stderr=subprocess.DEVNULL)

    def next(self, seconds=30):
        """The next message, None if none comes in so many seconds."""
        self.socket.settimeout(seconds)
        try:
            return self.socket.recv(4096).decode()
        except socket.timeout:
            return None

    def expect(self, text):
        said = self.next()
        if said is None or not re.fullmatch(text, said):
            fail(f'expected {text}, heard {said}')


def check_program(words, status, manager):
    program = manager.start(words)
    try:
        manager.expect('READY=1')
        for _ in range(3):
            manager.expect(f'WATCHDOG=1\nSTATUS={status}')
        program.send_signal(signal.SIGSTOP)
        while manager.next(WATCHDOG_SECONDS):  # what it said before it was stopped
            pass
        program.send_signal(signal.SIGCONT)
        manager.expect(f'WATCHDOG=1\nSTATUS={status}')
        program.terminate()
        while (said := manager.next()) != 'STOPPING=1':
            if said is None:
                fail(f'{words[0]}: ends without a word')
        if program.wait(30) != 0:
            fail(f'{words[0]}: ends with {program.returncode}')
        while manager.next(0.01):
            pass
    finally:
        program.kill()


def main():
    if not shutil.which('systemd-analyze'):
        print('SKIPPED: there is no systemd-analyze')
        sys.exit(77)
    bin_folder = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix='tilemend-systemd-') as folder:
        for name in ('tilemend-coordinator', 'tilemend-worker'):
            check_unit(name, bin_folder, folder)
        manager = Manager(folder)
        program = lambda name: os.path.join(bin_folder, name)
        check_program([program('tilemend-coordinator'), '--work', os.path.join(folder, 'work'), '--listen', '127.0.0.1:0'],
                      '0 jobs, 0 tasks', manager)
        check_program([program('tilemend-worker'), '--coordinator', '127.0.0.1:1'], '[^\n]*', manager)
    print('2 units, 2 programs: passed')


if __name__ == '__main__':
    main()
