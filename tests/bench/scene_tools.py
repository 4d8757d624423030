"""The scene tools: scenes with known truth and the check of an output, which are not part of this project.

TILEMEND_SHARED_TOOLS names their folder; data/ beside it holds elevation models and real tiles. They need numpy and scipy.
"""
import json
import os
import subprocess
import sys
import tempfile

import measure

FAULT = 'jacksboro_fault_dem.npz'  # the name of an elevation model; `run` finds its file


def folder():
    """The folder of the tools, or None."""
    return os.environ.get('TILEMEND_SHARED_TOOLS')


def needed(program):
    """The folder of the tools; ends `program` with a message where it is not named."""
    if not folder():
        sys.exit(f'{program}: set TILEMEND_SHARED_TOOLS to the folder of the scene tools')
    return folder()


def run(name, *arguments):
    """Runs one of the tools."""
    arguments = [os.path.join(folder(), '..', 'data', 'dem', FAULT) if a == FAULT else a for a in arguments]
    subprocess.run([sys.executable, os.path.join(folder(), name), *map(str, arguments)], check=True,
                   stdout=subprocess.DEVNULL)


def fill(bin_folder, scene, out, *flags):
    """Runs tilemend on a scene and returns its report."""
    measure.Run([os.path.join(bin_folder, 'tilemend'), 'run', scene, '--out', out, *flags], accept=(0, 100))
    return read_json(os.path.join(out, 'report.json'))


def read_json(path):
    with open(path, encoding='utf-8') as file:
        return json.load(file)


def check(scene, out, *flags):
    """What check_fill.py finds; 'broken' lists the broken promises."""
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as temporary:
        result = os.path.join(temporary, 'result.json')
        # Exit code 1 tells of a broken promise; it is in the result as well.
        measure.Run([sys.executable, os.path.join(folder(), 'check_fill.py'), scene, out, '--json', result, *flags],
                    accept=(0, 1))
        return read_json(result)


def promises(checked):
    return 'all kept' if not checked['broken'] else 'broken: ' + '; '.join(map(str, checked['broken']))


def tensions(report):
    """The chosen tensions in 1 / km2, the largest three."""
    values = sorted((t['tension'] * 1e6 for t in report['tension']), reverse=True)
    return ' '.join(f'{v:.0f}' for v in values[:3]) + (' …' if len(values) > 3 else '')
