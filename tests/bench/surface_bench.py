#!/usr/bin/python3
"""Fills scenes with both surfaces, `wang` and `thin-plate`, and prints their errors and kinks side by side.

    TILEMEND_SHARED_TOOLS=DIR surface_bench.py [--bin DIR] [--seeds 1,2,3] [--only NAME]

Scenes of two or more layers, where heights come from farther away than the next cell: made ones with both cuts, the layouts of
Wang's tables, an elevation model. Errors and kinks are those of check_fill.py, at every removed vertex. DIR holds the scene tools,
which are not part of this project. They need numpy and scipy.
"""
import argparse
import os
import statistics
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure
import scene_tools

GOAL = 0.85
GRID = ('--cols', 6, '--rows', 6, '--cell', 100, '--spacing', 2.5)
GROUNDS = {'Hurst 0.7': ('--hurst', 0.7), 'Hurst 1.0': ('--hurst', 1.0), 'Hurst 1.2': ('--hurst', 1.2),
           'DEM': ('--dem', scene_tools.FAULT, '--relief', 100)}
HOLES = {'lakes, islands, river': ('--holes', 'lakes,islands,river,small', '--lake-share', 0.25),
         'lake 5 cells wide': ('--holes', 'none', '--ellipse', '300,300,250,220')}
TABLES = ('table1', 'table3')  # layouts beside the tools
REAL = {'Mars crater, real cut': 'mars', 'DEM, real cut': 'dem'}
HEADS = ['scene', 'seed', 'layers', 'relief, m', '`wang`, m', '`thin-plate`, m', 'ratio', 'tension, 1/km²', 'border / inside',
         'the same, `wang`', 'rim / input', 'the same, `wang`', 'promises']


def makers():
    """Name of each scene -> what makes it in a folder from a seed and returns where it is."""
    def made(folder, seed, *flags):
        scene_tools.run('make_scene.py', os.path.join(folder, 'scene'), *GRID, '--seed', seed, *flags)
        return os.path.join(folder, 'scene')

    def table(folder, seed, layout, cut):
        path = os.path.join(scene_tools.folder(), '..', 'scenes', f'{layout}.json')
        scene_tools.run('make_table_scene.py', os.path.join(folder, 'scene'), path, '--seed', seed, '--cut', cut)
        return os.path.join(folder, 'scene')

    def real(folder, seed, name):
        scene_tools.run('real_scenes.py', folder, '--cut', '--only', name, '--seed', seed)
        return os.path.join(folder, name)

    result = {}
    for cut in ('clipped', 'ragged'):
        for hole, holes in HOLES.items():
            for ground, flags in GROUNDS.items():
                result[f'{hole}, {ground}, {cut}'] = (made, '--cut', cut, *holes, *flags)
        for layout in TABLES:
            result[f'{layout}, {cut}'] = (table, layout, cut)
    for name, word in REAL.items():
        result[name] = (real, word)
    return result


def judged(bin_folder, scene):
    """What check_fill.py says of both surfaces, and their reports; nothing where the scene has fewer than two layers."""
    checked, report = {}, {}
    for surface in ('wang', 'thin-plate'):
        out = f'{scene}-{surface}'
        report[surface] = scene_tools.fill(bin_folder, scene, out, '--surface', surface)
        if report[surface]['layers'] < 2:
            return None
        checked[surface] = scene_tools.check(scene, out)
    return checked, report


def errors(bin_folder, scene):
    """Mean error by surface, metres, and the broken promises of all; nothing where the scene has fewer than two layers."""
    found = judged(bin_folder, scene)
    if found is None:
        return None
    checked = found[0]
    return {s: c['error mean, m'] for s, c in checked.items()} | {'broken': [f'{s}: {b}' for s, c in checked.items() for b in c['broken']]}


def row(bin_folder, name, seed, scene):
    """The row of a scene and its ratio of errors; nothing where it has fewer than two layers."""
    found = judged(bin_folder, scene)
    if found is None:
        return None
    checked, report = found
    wang, plate = checked['wang'], checked['thin-plate']
    ratio = plate['error mean, m'] / wang['error mean, m']

    def kinks(a, b):
        return [measure.up(c[f'kink {a}, deg'] / c[f'kink {b}, deg'], 2) for c in (plate, wang)]

    broken = {k: scene_tools.promises(c) for k, c in checked.items() if c['broken']}
    return [name, seed, report['wang']['layers'], measure.down(plate['relief of the removed surface, m'], 1),
            measure.down(wang['error mean, m'], 3), measure.up(plate['error mean, m'], 3), measure.up(ratio, 2),
            scene_tools.tensions(report['thin-plate']), *kinks('across cell borders', 'inside the fill'),
            *kinks('along the rims', 'of the input surface'),
            '; '.join(f'`{k}` {v}' for k, v in broken.items()) or 'all kept'], ratio


def summary(ratios):
    within = sum(r <= GOAL for r in ratios)
    return (f'{within} of {len(ratios)} scenes at or below {GOAL}; mean ratio {measure.up(statistics.mean(ratios), 2)}, '
            f'median {measure.up(statistics.median(ratios), 2)}, largest {measure.up(max(ratios), 2)}.')


def tables(bin_folder, seeds, only=None):
    rows, ratios = [], []
    for name, (make, *arguments) in makers().items():
        if only and only not in name:
            continue
        for seed in seeds:
            with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
                result = row(bin_folder, name, seed, make(folder, seed, *arguments))
            if result is None:
                print(f'{name}, seed {seed}: fewer than two layers, left out', file=sys.stderr)
                continue
            rows.append(result[0])
            ratios.append(result[1])
            print(' | '.join(map(str, rows[-1])), file=sys.stderr, flush=True)
    return f'{measure.table(HEADS, rows)}\n\n{summary(ratios)}' if rows else 'no scene has two layers'


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--seeds', type=lambda t: [int(n) for n in t.split(',')], default=[1, 2, 3])
    parser.add_argument('--only', help='scenes with this in their name')
    a = parser.parse_args()
    scene_tools.needed('surface_bench.py')
    print(tables(a.bin, a.seeds, a.only))


if __name__ == '__main__':
    main()
