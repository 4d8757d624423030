#!/usr/bin/env python3
"""The end of the interpreter while a thread is in tilemend.fill: exit_test.py BIN PACKAGE"""
import os
import subprocess
import sys
import unittest

PACKAGE = sys.argv[2] if len(sys.argv) > 2 else None

# Ends while a daemon thread, and in the child of a fork while none, is in `fill`.
DAEMON = '''
import os, sys, threading, time
sys.path[:0] = {paths!r}
import tilemend
from meshes import plane
vertices, faces = plane(600, 2, 598, 0.01)
started = threading.Event()

def show(*_):
    started.set()
    {in_callback}

def work():
    while True:
        tilemend.fill(vertices, faces, uniform=True, progress=show)

threading.Thread(target=work, daemon=True).start()
started.wait()
time.sleep(0.1)
if {forks} and os.fork() == 0:
    sys.exit()
if {forks}:
    sys.exit(os.wait()[1])
'''


class ExitTest(unittest.TestCase):
    def test_the_interpreter_ends_quietly_while_a_daemon_thread_fills(self):
        paths = [PACKAGE, os.path.dirname(os.path.abspath(__file__))]
        for in_callback in ('pass', 'time.sleep(0.4)', 'time.sleep(1000)'):
            for forks in (False, True):
                with self.subTest(in_callback=in_callback, forks=forks):
                    text = DAEMON.format(paths=paths, in_callback=in_callback, forks=forks)
                    program = subprocess.run([sys.executable, '-c', text], stderr=subprocess.PIPE, text=True, timeout=60)
                    self.assertEqual((program.returncode, program.stderr), (0, ''))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
