"""The peer's driver: CGAL's hole filling as a program, compiled where it is needed. It is not part of this project.

It reads IN.off, writes OUT.off (the triangles of IN first), takes a mode (cdt, dt: ways to triangulate), prints fill_s=SECONDS.
"""
import os
import re
import subprocess
import tempfile

import measure

COMPILE = ['g++', '-std=c++17', '-O3', '-DNDEBUG', '-DCGAL_EIGEN3_ENABLED', '-I/usr/include/eigen3']


def missing(source):
    """Why there is no peer to run, or None."""
    if not source or not os.path.exists(source):
        return f'no driver for the peer: {source}'
    return None if os.path.isdir('/usr/include/CGAL') else 'CGAL is not installed (Debian: libcgal-dev)'


def build(source, folder):
    """The path of the compiled driver."""
    driver = os.path.join(folder, 'peer')
    subprocess.run([*COMPILE, source, '-o', driver, '-lmpfr', '-lgmp'], check=True)
    return driver


def fill(driver, mode, mesh, out):
    """The run of the process and the seconds that filling alone took in it."""
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        log = os.path.join(folder, 'log')
        run = measure.Run(['sh', '-c', f'exec "$0" "$1" "$2" {mode} >"$3"', driver, mesh, out, log])
        with open(log, encoding='utf-8') as file:
            return run, float(re.search(r'fill_s=([0-9.]+)', file.read()).group(1))
