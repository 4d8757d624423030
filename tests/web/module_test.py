#!/usr/bin/env python3
"""Runs the tests of a module of the page in node: module_test.py FOLDER MODULE

FOLDER is that of report_page_test.py. MODULE is the name of a source in web/src; its tests are MODULE_test.mjs beside this
file. Exit code 77 (skipped, and says so) without npm or its registry.
"""
import os
import sys
import tempfile

from npm_packages import WEB, fail, install, run

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    folder, name = os.path.realpath(sys.argv[1]), sys.argv[2]
    install(folder)
    with tempfile.TemporaryDirectory() as built:
        module = os.path.join(built, f'{name}.mjs')
        bundled = run(os.path.join(folder, 'node_modules', '.bin', 'esbuild'), os.path.join(WEB, 'src', f'{name}.ts'),
                      '--bundle', '--format=esm', f'--outfile={module}',
                      env=dict(os.environ, NODE_PATH=os.path.join(folder, 'node_modules')))
        if bundled.returncode:
            fail(bundled.stdout)
        done = run('node', os.path.join(HERE, f'{name}_test.mjs'), module)
        print(done.stdout, end='')
        if done.returncode:
            fail(f'{name}_test.mjs')


if __name__ == '__main__':
    main()
