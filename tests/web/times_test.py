#!/usr/bin/env python3
"""Runs the page's functions on progress and time in node, by times_test.mjs: times_test.py FOLDER

FOLDER is that of report_page_test.py. Exit code 77 (skipped, and says so) without npm or its registry.
"""
import os
import sys
import tempfile

from npm_packages import WEB, fail, install, run

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    folder = os.path.realpath(sys.argv[1])
    install(folder)
    with tempfile.TemporaryDirectory() as built:
        module = os.path.join(built, 'times.mjs')
        bundled = run(os.path.join(folder, 'node_modules', '.bin', 'esbuild'), os.path.join(WEB, 'src', 'times.ts'),
                      '--bundle', '--format=esm', f'--outfile={module}')
        if bundled.returncode:
            fail(bundled.stdout)
        done = run('node', os.path.join(HERE, 'times_test.mjs'), module, os.path.join(HERE, 'progress_shares.txt'))
        if done.returncode:
            fail(done.stdout)


if __name__ == '__main__':
    main()
