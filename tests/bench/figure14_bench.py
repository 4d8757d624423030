#!/usr/bin/python3
"""Repeats the experiment of Wang et al. 2021, figure 14, on made terrain and prints the errors of the fill.

    TILEMEND_SHARED_TOOLS=DIR figure14_bench.py [--bin DIR] [--seeds 1,2,3,4,5]

Four cells, a closed and an unclosed hole that the grid divides into four open holes of type I and two of type II, about 76,000 m2
together, 2 m of relief. DIR holds the scene tools, which are not part of this project: make_table_scene.py makes the scene and
check_fill.py judges the output. They need numpy and scipy.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure

# In cells of 250 m: [centre x, centre y, radius x, radius y]. The second disc reaches over the rim of the area.
LAYOUT = {'cols': 2, 'rows': 2, 'closed': 0, 'relief': 2.45,
          'holes': [{'kind': 'disc', 'at': [0.98, 0.8, 0.5, 0.52]}, {'kind': 'disc', 'at': [1.0, 2.0, 0.62, 0.42]}]}
HEADS = ['seed', 'relief, m', 'points', 'mean, m', 'max, m', 'std, m', 'promises']


def check(bin_folder, tools, layout, seed, folder):
    scene, out, result = (os.path.join(folder, f'{name}{seed}') for name in ('scene', 'out', 'result'))
    python = sys.executable
    subprocess.run([python, os.path.join(tools, 'make_table_scene.py'), scene, layout, '--spacing', '1', '--seed', str(seed)],
                   check=True, stdout=subprocess.DEVNULL)
    measure.Run([os.path.join(bin_folder, 'tilemend'), 'run', scene, '--out', out], accept=(0, 100))
    # Exit code 1 tells of a broken promise; it is in the result as well.
    measure.Run([python, os.path.join(tools, 'check_fill.py'), scene, out, '--json', result], accept=(0, 1))
    with open(result, encoding='utf-8') as file:
        return json.load(file)


def tables(bin_folder, tools, seeds):
    rows = [['Wang 2021', '2.02', '34', '0.10', '0.23', '0.11', '']]
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        layout = os.path.join(folder, 'layout.json')
        with open(layout, 'w', encoding='utf-8') as file:
            json.dump(LAYOUT, file)
        for seed in seeds:
            r = check(bin_folder, tools, layout, seed, folder)
            rows.append([seed, measure.down(r['relief of the removed surface, m'], 2), f"{r['truth points']:,}",
                         *(measure.up(r[f'error {k}, m'], 2) for k in ('mean', 'max', 'std')),
                         'all kept' if not r['broken'] else 'broken: ' + '; '.join(map(str, r['broken']))])
    return measure.table(HEADS, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--seeds', type=lambda t: [int(n) for n in t.split(',')], default=[1, 2, 3, 4, 5])
    a = parser.parse_args()
    tools = os.environ.get('TILEMEND_SHARED_TOOLS')
    if not tools:
        sys.exit('figure14_bench.py: set TILEMEND_SHARED_TOOLS to the folder of the scene tools')
    print(tables(a.bin, tools, a.seeds))


if __name__ == '__main__':
    main()
