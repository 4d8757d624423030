#!/usr/bin/python3
"""Runs `tilemend run` on a scene of the shared tools and holds it to their judgement.

    acceptance_test.py TILEMEND MAKER TOOLS LAYOUT CUT

TOOLS has make_table_scene.py and check_fill.py, LAYOUT is a JSON file of ../scenes beside TOOLS, CUT is clipped, ragged or
overlap. MAKER is tilemend-make-scene, which makes scenes of tiles that overlap. With both surfaces the report's counts must
be those of expected.json, and check_fill.py must find every promise kept. It knows no tiles that overlap: there the report
must have the fills of two tiles nowhere more than 2 cm apart at 99 % of the places that it looks at.
Exits 77 (skipped) without the tools or without numpy and scipy.
"""
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
SURFACES = 'thin-plate', 'wang'
MOST_APART = 0.02  # metres


def skip(why):
    print('SKIPPED:', why)
    sys.exit(SKIPPED)


def make(maker, tools, layout, cut, folder):
    """Makes the scene, and gives its folder and the counts that are expected."""
    scene, counted = os.path.join(folder, 'scene'), os.path.join(folder, 'counted')
    command = [sys.executable, os.path.join(tools, 'make_table_scene.py'), counted, layout]
    if cut == 'overlap':
        command += ['--spacing', '25']  # for its counts alone
        subprocess.run([maker, scene, '--layout', layout, '--cut', cut], check=True, stdout=subprocess.DEVNULL)
    else:
        command += ['--cut', cut]
        scene = counted
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(counted, 'expected.json')) as file:
        return scene, json.load(file)


def judge(tools, scene, out):
    check = subprocess.run([sys.executable, os.path.join(tools, 'check_fill.py'), scene, out], capture_output=True, text=True)
    print(check.stdout + check.stderr)
    kept = check.returncode == 0 and 'all promises kept' in check.stdout
    return [] if kept else ['check_fill.py: a promise is broken']


def apart(report):
    gaps = [border['fill_apart_m']['percentile_99'] for border in report['borders']['inexact'] if 'fill_apart_m' in border]
    print('fills apart, m:', *gaps)
    return [] if gaps and max(gaps) <= MOST_APART else [f'fills of two tiles are apart: {gaps}']


def faults_of(tilemend, tools, scene, expected, cut, surface):
    out = f'{scene}-{surface}'
    run = subprocess.run([tilemend, 'run', scene, '--out', out, '--surface', surface], capture_output=True, text=True, timeout=280)
    if run.returncode != 0:
        return [f'tilemend run: exit code {run.returncode}\n{run.stdout}{run.stderr}']
    with open(os.path.join(out, 'report.json')) as file:
        report = json.load(file)
    faults = [f'{part}: expected {expected}, found {report[part]}' for part in ('holes', 'filled') if report[part] != expected]
    return faults + (apart(report) if cut == 'overlap' else judge(tools, scene, out))


def main():
    tilemend, maker, tools, layout, cut = sys.argv[1:6]
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
        scene, expected = make(maker, tools, layout, cut, folder)
        faults = [f'{surface}: {fault}' for surface in SURFACES
                  for fault in faults_of(tilemend, tools, scene, expected, cut, surface)]
        sys.exit('\n'.join(faults) if faults else 0)


if __name__ == '__main__':
    main()
