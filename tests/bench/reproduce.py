#!/usr/bin/python3
"""Repeats the experiments of the papers behind tilemend and writes docs/papers.md: our figures beside the printed ones.

    TILEMEND_SHARED_TOOLS=DIR reproduce.py [--bin DIR] [--only wang,efficiency,sun,xu,zhang,fillers] [--areas 8,16,24,32] [--spacing 2]
                                           [--page FILE]

DIR holds the scene tools, which are not part of this project; without it what needs them is left out, and the page says so. The
papers' own models and photographs cannot be had: made ones stand in, as the page says of each. Parts that are not run keep what the
page has of them. Needs numpy, scipy and matplotlib.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import filler_bench
import measure
import scene_tools
import surfaces

TYPES = [('closed', None), *(('I', t) for t in 'ABCD'), *(('II', t) for t in 'ABCD')]
PRINTED = {  # holes by TYPES; what the Han method filled
    'table1': ('Tables 1 and 2', [16, 4, 17, 0, 1, 0, 2, 0, 0], [16, 1, 9, 0, 1, 0, 0, 0, 0]),
    'table3': ('Table 3 (its type II: as in table 2)', [20, 5, 20, 4, 4, 0, 2, 0, 0], [20, 2, 12, 4, 4, 0, 0, 0, 0]),
}
AREAS = {8: (0.5, 3.9, 17.2, 0.8, 5.5), 16: (1.0, 6.7, 32.8, 0.8, 11.4), 24: (1.5, 11.6, 46.5, 1.0, 17.6), 32: (2.0, 15.2, 68.2, 1.2, 24.7)}
SUN = (('green pepper', 22, 15, 50, 4.234), ('leaf of maize', 41, 18, 75, 5.485), ('cucumber', 60, 68, 194, 8.922),
       ('ginger', 126, 116, 356, 15.781), ('mustard', 62, 65, 190, 8.813))
IMAGES = os.path.join(measure.ROOT, 'docs', 'images')


def program(a):
    return os.path.join(a.bin, 'tilemend')


def count(report, name, kind, letter):
    return report[name]['closed'] if kind == 'closed' else report[name][kind][letter]


def wang_rows(a, layout, cut, folder):
    scene = os.path.join(folder, f'{layout}-{cut}')
    scene_tools.run('make_table_scene.py', scene, os.path.join(scene_tools.folder(), '..', 'scenes', f'{layout}.json'), '--cut', cut)
    rows = []
    for surface in ('wang', 'thin-plate'):
        report = scene_tools.fill(a.bin, scene, f'{scene}-{surface}', '--surface', surface)
        checked = scene_tools.check(scene, f'{scene}-{surface}')
        rows.append([f'`{surface}`, {cut}', *(f"{count(report, 'filled', *t)}/{count(report, 'holes', *t)}" for t in TYPES), scene_tools.promises(checked)])
    joined = subprocess.run([program(a), 'aggregate', scene, '--out', f'{scene}.ply', '-o', 'json'], capture_output=True, text=True, check=False)
    report = json.loads(joined.stdout)
    filled, holes = report['filled']['closed'], report['holes']['closed']
    return [*rows, [f'`aggregate`, {cut}', f'{filled} of {holes} closed holes of the joined mesh', *[''] * 9]]


def part_wang(a, folder):
    if not scene_tools.folder():
        return None
    text = []
    for layout, (name, printed, han) in PRINTED.items():
        rows = [['printed: holes, all filled by the method', *printed, ''], ['printed: filled by the Han method', *han, '']]
        rows += [row for cut in ('clipped', 'ragged') for row in wang_rows(a, layout, cut, folder)]
        text.append(f'{name}; filled of found\n\n' + measure.table(['', 'closed', *(f'{k} {t}' for k, t in TYPES[1:]), '`check_fill.py`'], rows))
    return ('Scenes with as many holes of each type stand in for the reconstruction of Dongying. Joining makes one closed hole of the open ones of type I '
            'that belong together, so that holes of the joined mesh are fewer; those of type II stay open.\n\n' + '\n\n'.join(text))


def part_efficiency(a, folder):
    if not scene_tools.folder():
        return None
    rows, points = [], []
    for cells in a.areas:
        area, minutes, han_minutes, memory, han_memory = AREAS[cells]
        scene = os.path.join(folder, f'area{cells}')
        scene_tools.run('make_scene.py', scene, '--cols', 4, '--rows', cells // 4, '--cell', 250, '--spacing', a.spacing, '--no-truth')
        runs = {s: measure.Run([program(a), 'run', scene, '--out', f'{scene}-{s}', '--surface', s], accept=(0, 100)) for s in ('wang', 'thin-plate')}
        joined = measure.Run([program(a), 'aggregate', scene, '--out', f'{scene}.ply', '--longest-loop', '20000'], accept=(0, 100))
        wang = runs['wang']
        points.append((area, joined.wall / wang.wall, joined.peak / wang.peak, han_minutes / minutes, han_memory / memory))
        rows.append([f'{area} km²', *(measure.up(r.wall, 1) for r in (wang, runs['thin-plate'], joined)), f'{points[-1][1]:.1f}', f'{points[-1][3]:.1f}',
                     *(measure.megabytes(r.peak) for r in (wang, runs['thin-plate'], joined)), f'{points[-1][2]:.1f}', f'{points[-1][4]:.1f}'])
    plot_ratios(points)
    heads = ['', '`wang`, s', '`thin-plate`, s', '`aggregate`, s', 'ratio', 'printed', '`wang`, MB', '`thin-plate`, MB', '`aggregate`, MB', 'ratio', 'printed']
    return (f'Made terrain in cells of 250 m, vertices {a.spacing:g} m apart. Ratios are of `aggregate` to `wang`; the printed ones are of tables 6 and 7 (the Han '
            'method to the paper\'s). `aggregate` triangulates every loop at once (`--longest-loop 20000`).\n\n' + measure.table(heads, rows) +
            '\n\n![ratios of time and memory](images/papers_efficiency.png)\n\nThe run on 28 km² (printed: 230 min, 3.2 GB) is not part of this page.')


def axes_of(name, draw, size=(7, 3)):
    import matplotlib
    matplotlib.use('Agg')
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, 2, figsize=size)
    draw(axes)
    figure.tight_layout()
    figure.savefig(os.path.join(IMAGES, name), dpi=100, metadata={'Software': None})
    plt.close(figure)


def plot_ratios(points):
    def draw(axes):
        area = [p[0] for p in points]
        for k, (ours, printed, title) in enumerate(((1, 3, 'time'), (2, 4, 'memory'))):
            axes[k].plot(area, [p[ours] for p in points], 'o-', label='here')
            axes[k].plot(area, [p[printed] for p in points], 's--', label='printed')
            axes[k].set(title=f'{title}: joined over by cells', xlabel='km²', ylim=(0, None))
            axes[k].legend()
    axes_of('papers_efficiency.png', draw)


def part_sun(a, folder):
    rows, histograms = [], []
    for name, rim, vertices, triangles, seconds in SUN:
        made = filler_bench.make('curved', rim)
        result = filler_bench.run(a, 'advancing-front-normal', 'curved', rim, made, folder)
        if not result['filled']:
            rows.append([name, result['rim'], vertices, triangles, f'{seconds}', *['not filled'] * 5])
            continue
        new = (result['triangles'] - result['rim'] + 2) // 2
        histograms.append((name, result['histogram']))
        rows.append([name, result['rim'], vertices, triangles, f'{seconds}', new, result['triangles'], measure.up(result['seconds'], 3),
                     measure.down(result['quality'], 3), measure.down(result['least'], 3)])

    def draw(axes):
        x = np.arange(20) / 20 + .025
        for (name, values), k in zip(histograms, (0, 0, 0, 1, 1)):
            axes[k].plot(x, np.array(values) / max(1, sum(values)), label=name)
        for k in (0, 1):
            axes[k].set(xlabel='quality 2 r / R', ylabel='share of triangles')
            axes[k].legend()
    axes_of('papers_sun.png', draw)
    heads = ['stand-in for', 'rim', 'printed: new vertices', 'triangles', 's', 'here: new vertices', 'triangles', 's, whole process', 'mean quality', 'least']
    return ('Curved sheets with holes whose rims have 22, 41, 60, 126 and 62 vertices stand in for the scanned plants; T - 2 V + 2 of the printed counts; the printed holes have fewer vertices inside, so that they are narrower than ours. '
            'The paper\'s mean qualities are above 0.85.\n\n' + measure.table(heads, rows) +
            '\n\n![quality of the new triangles](images/papers_sun.png)')


def part_xu(a, folder):
    """A hole in a sphere with a ripple: the analytic surface is known."""
    rows = [['printed: reference 17', 28, 69, '0.05', '0.00150', ''], ['printed: the paper', 31, 75, '0.042', '0.00142', '']]
    made = filler_bench.make('curved', 22)
    for filler in ('advancing-front-poisson', 'svm-laplacian'):
        r = filler_bench.run(a, filler, 'curved', 22, made, folder)
        if not r['filled']:
            rows.append([f'`{filler}`', *['not filled'] * 5])
            continue
        distance = r['error'] * made[3]
        corners = made[0][made[1][made[2]]]
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
        rows.append([f'`{filler}`', (r['triangles'] - r['rim'] + 2) // 2, r['triangles'], f'{distance:.4f}', f'{distance / np.sqrt(area):.5f}',
                     measure.up(1000 * r['seconds'], 1)])
    return ('A curved sheet with a hole of 22 edges stands in for the head. The error is the mean distance over the square root of the area; the paper takes '
            'the area of its whole analytic surface, which it does not print, so that only the two methods compare with each other. Printed times: 26.3 and 26.3 ms '
            '(front and equation).\n\n' + measure.table(['', 'new vertices', 'triangles', 'mean distance', 'error', 'ms, whole process'], rows))


def grid_sheet(inside, n=24):
    x, y = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
    points = np.stack([x.ravel(), y.ravel(), .2 * np.sin(x.ravel() * .4)], 1).astype(float)
    i, j = (k.ravel() for k in np.meshgrid(np.arange(n), np.arange(n)))
    keep = ~inside(i + .5, j + .5)
    v = (j * (n + 1) + i)[keep]
    return points, np.concatenate([np.stack([v, v + 1, v + n + 2], 1), np.stack([v, v + n + 2, v + n + 1], 1)])


def slit(shift, n=24):
    """A sheet torn along a line; its far side is shifted."""
    points, triangles = grid_sheet(lambda x, y: np.zeros(len(x), bool), n)
    at = 12 * (n + 1) + np.arange(5, n - 4)
    number = np.arange(len(points))
    number[at] = len(points) + np.arange(len(at))
    far = points[triangles].mean(1)[:, 1] > 12
    triangles[far] = number[triangles[far]]
    return np.vstack([points, points[at] + shift]), triangles


def part_zhang(a, folder):
    """Holes of the kinds of table 2."""
    def disc(x, y, r, u=12, v=12):
        return np.hypot(x - u, y - v) < r
    kinds = {'simple': lambda x, y: disc(x, y, 4), 'island': lambda x, y: disc(x, y, 7) & ~disc(x + 2, y, 1.6),
             'annular': lambda x, y: disc(x, y, 7) & ~disc(x, y, 5), 'continuous': lambda x, y: ((x > 8) & (x < 12) & (y > 8) & (y < 12)) | ((x > 12) & (x < 16) & (y > 12) & (y < 16))}
    meshes = {name: grid_sheet(inside) for name, inside in kinds.items()}
    meshes |= {'crack': slit([0, .1, 0]), 'dislocation': slit([0, .02, .15])}
    rows = []
    for name, mesh in meshes.items():
        path, out = os.path.join(folder, f'{name}.off'), os.path.join(folder, f'{name}_out.off')
        surfaces.write_off(path, *mesh)
        done = subprocess.run([program(a), 'fill', path, '--out', out, '--overwrite', '-o', 'json'], capture_output=True, text=True, check=False)
        report = json.loads(done.stdout)
        found = ', '.join(f'{k} {n}' for k, n in report['single'].items() if n)
        rows.append([name, found, report['continuous'], f"{report['filled']['closed']}/{report['holes']['closed']}", filler_bench.crossings(program(a), out)])
    return ('Made sheets with one hole of each kind stand in for the scanned models, which cannot be had. The paper\'s method identifies and repairs all kinds that '
            'its models have; Geomagic fails at continuous, crack, dislocation and annular holes.\n\n' +
            measure.table(['made', 'found as', 'continuous', 'filled', 'crossings'], rows))


def ahead_of_default(results):
    """Where a filler's mean error is below the default's on the holes that both filled."""
    default = {(r['kind'], r['rim']): r['error'] for r in results if r['filler'] == 'auto' and r['filled']}
    found = []
    for filler, kind in dict.fromkeys((r['filler'], r['kind']) for r in results):
        both = [(r['error'], default[kind, r['rim']]) for r in results
                if (r['filler'], r['kind']) == (filler, kind) and r['filled'] and (kind, r['rim']) in default]
        own, its = np.mean(both, 0) if both else (np.inf, 0)
        if filler != 'auto' and own < its:
            found.append(f'`{filler}` on {kind} ({own:.4f} to {its:.4f})')
    return 'The default is not ahead of: ' + '; '.join(found) + '.' if found else 'The default is ahead of each on each kind.'


def part_fillers(a, folder):
    every = argparse.Namespace(bin=a.bin, only=list(filler_bench.KINDS), rims=filler_bench.RIMS, fillers=filler_bench.FILLERS, json='')
    if a.json:
        with open(a.json, encoding='utf-8') as file:
            results = json.load(file)
    else:
        results = filler_bench.measured(every, folder)
    return ('`tests/bench/filler_bench.py`: the same 40 made holes, ten each on nearly flat ground, a curved surface, a folded sheet and the wall of a tube, with 10 to '
            '400 boundary vertices. An error is the mean distance from what was removed to the patch, over the radius of the hole. '
            'A fill of more than 30 s counts as not filled.\n\n' + filler_bench.table(results) + '\n\n' + ahead_of_default(results) +
            ' Nearly flat ground is even but for 0.02 edges that no filler can know: there the default presumably goes on with slopes of the rim that mean nothing, '
            'and fillers that do not are nearer. The curved sheet turns evenly, which harmonic normals presumably foretell.')


PARTS = {'wang': ('Wang 2021, tables 1 to 3: holes by type', part_wang), 'efficiency': ('Wang 2021, tables 6 and 7: time and memory', part_efficiency),
         'sun': ('Sun 2012, table 1 and figure 6', part_sun), 'xu': ('Xu 2014, tables 1 and 2', part_xu),
         'zhang': ('Zhang 2022, table 2: kinds of holes', part_zhang), 'fillers': ('All fillers on the same holes', part_fillers)}
HEAD = ('# The papers\' experiments again\n\n`scripts/reproduce.sh` runs them and writes this page, with the scene tools in `TILEMEND_SHARED_TOOLS`. '
        '[Wang](decisions/2026-11-22-wang-as-printed.md) and [the fillers](decisions/2026-11-22-published-fillers.md) say what was chosen where the papers say nothing.\n')


def kept(page):
    """The sections that a page has, by name."""
    if not os.path.exists(page):
        return {}
    with open(page, encoding='utf-8') as file:
        return {m[1]: m[2].strip() for m in re.finditer(r'<!-- (\w+) -->\n(.*?)(?=<!-- \w+ -->|\Z)', file.read(), re.DOTALL)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--only', type=filler_bench.words, default=list(PARTS))
    parser.add_argument('--areas', type=lambda t: [int(n) for n in filler_bench.words(t)], default=list(AREAS))
    parser.add_argument('--spacing', type=float, default=2)
    parser.add_argument('--page', default=os.path.join(measure.ROOT, 'docs', 'papers.md'))
    parser.add_argument('--json', default='', help='results that filler_bench.py has written, instead of its run')
    a = parser.parse_args()
    sections = kept(a.page)
    for name in a.only:
        print(name, file=sys.stderr)
        with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
            text = PARTS[name][1](a, folder)
        if text is None:
            print(f'SKIPPED {name}: set TILEMEND_SHARED_TOOLS to the folder of the scene tools', file=sys.stderr)
            continue
        sections[name] = f'## {PARTS[name][0]}\n\n{text}\n\nMeasured on: {measure.machine()}.'
        with open(a.page, 'w', encoding='utf-8') as file:
            file.write(HEAD + '\n' + '\n\n'.join(f'<!-- {n} -->\n{sections[n]}' for n in PARTS if n in sections) + '\n')


if __name__ == '__main__':
    main()
