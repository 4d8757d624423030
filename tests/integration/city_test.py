#!/usr/bin/python3
"""Runs `tilemend run` on a scene of overlapping tiles of the shared tools and holds it to their judgement.

    city_test.py TILEMEND TOOLS [make_city.py's options]

TOOLS has make_city.py and check_city.py. Every bar of check_city.py must be met.
Exits 77 (skipped) without the tools or without numpy.
"""
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
SMALL = ['--cols', '3', '--rows', '2', '--cell', '80']


def skip(why):
    print('SKIPPED:', why)
    sys.exit(SKIPPED)


def tool(tools, name, *arguments):
    return subprocess.run([sys.executable, os.path.join(tools, name), *arguments], capture_output=True, text=True)


def main():
    tilemend, tools, options = sys.argv[1], sys.argv[2], sys.argv[3:]
    for needed in ('make_city.py', 'check_city.py'):
        if not os.path.exists(os.path.join(tools, needed)):
            skip(f'{os.path.join(tools, needed)} is not there; set TILEMEND_SHARED_TOOLS')
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        skip(f'{error}; install python3-numpy')
    with tempfile.TemporaryDirectory() as folder:
        scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
        made = tool(tools, 'make_city.py', scene, *SMALL, *options)
        if made.returncode != 0:
            sys.exit(f'make_city.py: exit code {made.returncode}\n{made.stderr}')
        run = subprocess.run([tilemend, 'run', scene, '--out', out], capture_output=True, text=True, timeout=280)
        if run.returncode not in (0, 100):  # 100: outlines or holes are left; what is judged is the surface
            sys.exit(f'tilemend run: exit code {run.returncode}\n{run.stdout}{run.stderr}')
        check = tool(tools, 'check_city.py', scene, out)
        print(check.stdout + check.stderr)
        sys.exit(0 if check.returncode == 0 and 'all bars met' in check.stdout else 'check_city.py: a bar is missed')


if __name__ == '__main__':
    main()
