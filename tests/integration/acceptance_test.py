#!/usr/bin/python3
"""Runs `tilemend run` on a scene of the shared tools and holds it to their judgement.

    acceptance_test.py TILEMEND TOOLS LAYOUT CUT

TOOLS has make_table_scene.py and check_fill.py, LAYOUT is a JSON file of ../scenes beside TOOLS, CUT is clipped or ragged.
The report's counts must be those of expected.json, and check_fill.py must find every promise kept.
Exits 77 (skipped) without the tools or without numpy and scipy.
"""
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77


def skip(why):
    print('SKIPPED:', why)
    sys.exit(SKIPPED)


def main():
    tilemend, tools, layout, cut = sys.argv[1:5]
    layout = os.path.join(tools, '..', 'scenes', layout + '.json')
    for needed in (os.path.join(tools, 'check_fill.py'), layout):
        if not os.path.exists(needed):
            skip(f'{needed} is not there; set TILEMEND_SHARED_TOOLS')
    try:
        import numpy  # noqa: F401
        import scipy  # noqa: F401
    except ImportError as error:
        skip(f'{error}; install python3-numpy and python3-scipy')
    with tempfile.TemporaryDirectory() as folder:
        scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
        subprocess.run([sys.executable, os.path.join(tools, 'make_table_scene.py'), scene, layout, '--cut', cut], check=True,
                       stdout=subprocess.DEVNULL)
        run = subprocess.run([tilemend, 'run', scene, '--out', out], capture_output=True, text=True, timeout=280)
        if run.returncode != 0:
            sys.exit(f'tilemend run: exit code {run.returncode}\n{run.stdout}{run.stderr}')
        with open(os.path.join(scene, 'expected.json')) as file:
            expected = json.load(file)
        with open(os.path.join(out, 'report.json')) as file:
            report = json.load(file)
        faults = [f'{part}: expected {expected}, found {report[part]}' for part in ('holes', 'filled')
                  if report[part] != expected]
        check = subprocess.run([sys.executable, os.path.join(tools, 'check_fill.py'), scene, out], capture_output=True, text=True)
        print(check.stdout + check.stderr)
        if check.returncode != 0 or 'all promises kept' not in check.stdout:
            faults.append('check_fill.py: a promise is broken')
        sys.exit('\n'.join(faults) if faults else 0)


if __name__ == '__main__':
    main()
