"""The experiments of the papers about single holes: a part of reproduce.py for each."""
import argparse
import itertools
import json
import os
import subprocess

import numpy as np

import filler_bench
import measure
import papers_short
import stand_ins
import surfaces
from papers_plots import axes_of

SUN = (('green pepper', 22, 15, 50, 4.234), ('leaf of maize', 41, 18, 75, 5.485), ('cucumber', 60, 68, 194, 8.922),
       ('ginger', 126, 116, 356, 15.781), ('mustard', 62, 65, 190, 8.813))

PRINTED_STEPS = ('--front-steps', 'printed')  # new vertices where the papers put them


def program(a):
    return os.path.join(a.bin, 'tilemend')


def sun_step(a, rim, vertices, folder):
    made = stand_ins.leaf(rim, vertices)
    runs = [filler_bench.run(a, 'advancing-front-normal', 'leaf', rim, made, folder, *flags) for flags in ((), PRINTED_STEPS)]
    return [int(stand_ins.boundary_of(made[1], made[2])), int(stand_ins.inside_of(made[1], made[2])), *runs]


def sun_row(model, rim, inside, result, printed):
    name, _, vertices, triangles, seconds = model
    as_printed = measure.down(printed['quality'], 3) if printed['filled'] else 'not filled'
    first = [name, rim, inside, vertices, triangles, f'{seconds}']
    if not result['filled']:
        return [*first, *['not filled'] * 5, as_printed]
    return [*first, (result['triangles'] - rim + 2) // 2, result['triangles'], measure.up(result['seconds'], 3),
            measure.down(result['quality'], 3), measure.down(result['least'], 3), as_printed]


def part_sun(a, folder):
    results = [a.steps.get(f'sun-{model[1]}', sun_step, a, model[1], model[2], folder) for model in SUN]
    rows = [sun_row(model, *result) for model, result in zip(SUN, results)]
    filled = [r[2] for r in results if r[2]['filled']]
    worst = min((r['quality'] for r in filled), default=0)
    as_printed = [r[3] for r in results if r[3]['filled']]

    def draw(axes):
        x = np.arange(20) / 20 + .025
        for (model, result), k in zip(zip(SUN, results), (0, 0, 0, 1, 1)):
            if result[2]['filled']:
                axes[k].plot(x, np.array(result[2]['histogram']) / max(1, sum(result[2]['histogram'])), label=model[0])
        for k in (0, 1):
            axes[k].set(xlabel='quality 2 r / R', ylabel='share of triangles')
            axes[k].legend()
    axes_of('papers_sun.png', draw)
    heads = ['stand-in for', 'rim', 'vertices removed', 'printed: new vertices', 'triangles', 's', 'here: new vertices', 'triangles', 's, whole process', 'mean quality', 'least', 'mean quality with `--front-steps printed`']
    good = len(filled) == len(SUN) and worst > .85
    table = a.steps.write_table('sun', measure.table(heads, rows))
    return (measure.verdict('Sun, table 1 and figure 6', 'curved sheets with the printed rims', 'reproduced' if good else 'in part',
                            f'quality {measure.down(worst, 2)} and more, 0.85 in print; with printed steps {len(as_printed)} of {len(SUN)} filled'),
            papers_short.sun(table))


XU_WAYS = {'`advancing-front-poisson`': ('advancing-front-poisson',), '`svm-laplacian`': ('svm-laplacian',), '`svm-laplacian` `--svm-laplacian mean`': ('svm-laplacian', '--svm-laplacian', 'mean'),
           '`auto`': ('auto',)}
XU_STEPS = {'steady': (), 'printed': PRINTED_STEPS}
XU_RIM, XU_SEEDS, XU_VERTICES = 15, 6, (600, 1500)


def xu_run(a, kind, vertices, seed, folder):
    """For each way, and each kind of its front's steps: new vertices, triangles, mean distance of the new vertices, seconds."""
    points, triangles, removed, _ = stand_ins.head(kind, vertices, seed, XU_RIM)
    path, out = (os.path.join(folder, f'head{end}.off') for end in ('', '_filled'))
    surfaces.write_off(path, points, triangles[~removed])
    result = {'area': stand_ins.area_of(points, triangles), 'removed': stand_ins.area_of(points, triangles[removed])}
    for (way, (filler, *flags)), (steps, more) in itertools.product(XU_WAYS.items(), XU_STEPS.items()):
        if filler == 'auto' and more:
            continue
        run = measure.Run([program(a), 'fill', path, '--out', out, '--overwrite', '--filler', filler, *flags, *more], accept=(0, 100))
        filled, faces = surfaces.read_off(out)
        new = filled[len(points):]
        result[f'{way} {steps}'] = [len(new), len(faces) - int((~removed).sum()), float(stand_ins.to_head(kind, new).mean()), run.wall] if len(new) else None
    return result


def xu_row(results, key, base):
    """Of one way over all heads; `base` is what it is held against."""
    good = [r[key] for r in results if r[key] and r[base]]
    distance, held = (np.array([r[k][2] for r in results if r[key] and r[base]]) for k in (key, base))
    area = np.sqrt([r['area'] for r in results if r[key] and r[base]])
    return [key.rsplit(' ', 1)[0], f'{len(good)}/{len(results)}', f'{np.mean([g[0] for g in good]):.1f}', f'{np.mean([g[1] for g in good]):.1f}', f'{distance.mean():.3f}',
            f'{(distance / area).mean():.5f}', '–' if key == base else f'{np.exp(np.log(distance / held).mean()):.2f}', '–' if key == base else f'{(distance < held).sum()}/{len(good)}',
            measure.up(1000 * np.mean([g[3] for g in good]), 1)], float(np.exp(np.log(distance / held).mean())), int((distance < held).sum()), len(good)


def part_xu(a, folder):
    """Closed surfaces of which the analytic form is known, with holes of 15 edges."""
    results = {kind: [a.steps.get(f'xu-{kind}-{vertices}-{seed}', xu_run, a, kind, vertices, seed, folder)
                      for vertices in XU_VERTICES for seed in range(2 if a.quick else XU_SEEDS)] for kind in stand_ins.HEADS}
    every = [r for of_kind in results.values() for r in of_kind]
    heads = ['', 'filled', 'new vertices', 'triangles', 'mean distance', 'error', 'over Zhao\'s, geometric mean', 'ahead of Zhao\'s', 'ms, whole process']
    tables, found = {}, {}
    for steps in XU_STEPS:
        base = f'`advancing-front-poisson` {steps}'
        keys = [f'{way} {steps}' for way in XU_WAYS if way != '`auto`'] + (['`auto` steady'] if steps == 'steady' else [])
        rows = [xu_row(every, key, base) for key in keys]
        found[steps] = {key.rsplit(' ', 1)[0]: row[1:] for key, row in zip(keys, rows)}
        tables[steps] = a.steps.write_table(f'xu-{steps}', measure.table(heads, [row[0] for row in rows]))
    kinds = [[kind, *(f"{xu_row(of_kind, f'`svm-laplacian` {steps}', f'`advancing-front-poisson` {steps}')[1]:.2f}" for steps in XU_STEPS),
              *(f"{xu_row(of_kind, f'`svm-laplacian` `--svm-laplacian mean` {steps}', f'`advancing-front-poisson` {steps}')[1]:.2f}" for steps in XU_STEPS)] for kind, of_kind in results.items()]
    a.steps.write_table('xu-surfaces', measure.table(['', 'eq. 4, steady', 'eq. 4, printed', 'eq. 2, steady', 'eq. 2, printed'], kinds))
    worst = max(float(cell) for row in kinds for cell in row[1:3])
    ratio, ahead, count = found['printed']['`svm-laplacian`']
    steady_ratio, steady_ahead, _ = found['steady']['`svm-laplacian`']
    return (measure.verdict('Xu, table 1', f'closed heads, rim of {XU_RIM}', 'reproduced' if worst < 1 else 'in part' if min(ratio, steady_ratio) < 1 else 'not',
                            f'{ratio:.2f} and {steady_ratio:.2f} times Zhao\'s distance, 0.84 in print; only {ahead} and {steady_ahead} of {count} heads are nearer') +
            measure.verdict('Xu, table 2', 'the same', 'not', 'single steps are not timed'),
            'New vertices: mean distance to the surface, over Zhao\'s (geometric mean), heads where it is smaller.\n\n' + papers_short.xu(tables))


def curvature_step(a, kind, rim, folder):
    made = filler_bench.make(kind, rim)
    return [filler_bench.run(a, 'advancing-front-curvature', kind, rim, made, folder, '--halvings', halvings) for halvings in ('0', '2')]


def part_curvature(a, folder):
    """The paper prints no figures; what it claims is measured: refinement where the surface is curved, and there alone."""
    rows, share, closed, asked = [], {}, 0, 0
    for kind in ('plane', *filler_bench.FORTY, 'bump'):
        pairs = [a.steps.get(f'curvature-{kind}-{rim}', curvature_step, a, kind, rim, folder) for rim in (16, 24, 36, 54, 80)]
        both = [p for p in pairs if p[0]['filled'] and p[1]['filled']]
        closed, asked = closed + len(both), asked + len(pairs)
        new = [np.mean([(r['triangles'] - r['rim'] + 2) // 2 for r in side]) for side in zip(*both)]
        share[kind] = new[1] / new[0]
        rows.append([kind, f'{len(both)}/{len(pairs)}', *(f'{n:.0f}' for n in new), f'{share[kind]:.2f}', *(f"{np.mean([p[k]['error'] for p in both]):.5f}" for k in (0, 1)),
                     *(measure.down(np.mean([p[k]['quality'] for p in both]), 3) for k in (0, 1)), sum(p[1]['crossings'] for p in both)])
    more = share['plane'] < 1.1 < share['bump']
    heads = ['', 'filled', 'new vertices before', 'after refinement', 'ratio', 'error before', 'after', 'quality before', 'after', 'crossings']
    table = a.steps.write_table('curvature', measure.table(heads, rows))
    return (measure.verdict('repair by curvature (no table)', 'made holes of 16 to 80 edges', 'in part',
                            f'{closed} of {asked} closed, "any shape" in print; a plane is {"not refined, as in print" if more else "refined as well"}'),
            'Before and after refinement; *ratio* is that of new vertices.\n\n' + papers_short.curvature(table))


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
    meshes |= {'crack': slit([0, .02, 0]), 'dislocation': slit([0, .02, .15])}
    rows = []
    for name, mesh in meshes.items():
        path, out = os.path.join(folder, f'{name}.off'), os.path.join(folder, f'{name}_out.off')
        surfaces.write_off(path, *mesh)
        done = subprocess.run([program(a), 'fill', path, '--out', out, '--overwrite', '-o', 'json'], capture_output=True, text=True, check=False)
        report = json.loads(done.stdout)
        found = ', '.join(f'{k} {n}' for k, n in report['single'].items() if n)
        rows.append([name, found, report['continuous'], f"{report['filled']['closed']}/{report['holes']['closed']}", filler_bench.crossings(program(a), out)])
    right = sum(row[1].startswith(row[0]) or row[0] == 'continuous' and row[2] > 0 for row in rows)
    filled = sum(row[3].split('/')[0] == row[3].split('/')[1] and row[4] == 0 for row in rows)
    a.steps.write_table('zhang', measure.table(['made', 'found as', 'continuous', 'filled', 'crossings'], rows))
    return (measure.verdict('Zhang, table 2', 'one made sheet of each kind', 'in part', f'{right} of {len(rows)} kinds told, {filled} filled without crossings; all in print'),
            f'One hole each: {", ".join(meshes)}.')


def ahead_of_default(results):
    """Where a filler's mean error is below the default's on the holes that both filled."""
    default = {(r['kind'], r['rim']): r['error'] for r in results if r['filler'] == 'auto' and r['filled']}
    found = []
    for filler, kind in dict.fromkeys((r['filler'], r['kind']) for r in results):
        both = [(r['error'], default[kind, r['rim']]) for r in results
                if (r['filler'], r['kind']) == (filler, kind) and r['filled'] and (kind, r['rim']) in default]
        own, its = np.mean(both, 0) if both else (np.inf, 0)
        if filler != 'auto' and own < its:
            found.append(f'`{filler}` on {kind} ({own:.5f} to {its:.5f})')
    return 'The default is not ahead of: ' + '; '.join(found) + '.' if found else 'The default is ahead of each on each kind.'


def by_filler(a, name, fillers, kind, rim, folder, *flags):
    """What became of one hole with each filler, each a measurement of its own."""
    results = []
    for filler in fillers.fillers:
        one = argparse.Namespace(bin=fillers.bin, fillers=(filler,))
        results += a.steps.get(f'{name}-{filler}', filler_bench.of_hole, one, kind, rim, folder, *flags)
    return results


def other_curved(a, folder):
    """The default beside the one filler that is ahead of it on the curved sheet, on surfaces that are curved in other ways."""
    two = argparse.Namespace(bin=a.bin, fillers=('auto', 'advancing-front-poisson'))
    rows = []
    for kind in ('curved', *filler_bench.CURVED):
        results = []
        for rim in (16, 36, 80, 120):
            results += a.steps.get(f'curved-{kind}-{rim}', filler_bench.of_hole, two, kind, rim, folder)
        errors = {(r['filler'], r['rim']): r['error'] for r in results if r['filled']}
        both = [(errors[two.fillers[0], rim], errors[two.fillers[1], rim]) for rim in dict.fromkeys(r['rim'] for r in results)
                if all((filler, rim) in errors for filler in two.fillers)]
        rows.append([kind, len(both), *(f'{error:.5f}' for error in np.mean(both, 0))])
    return measure.table(['', 'holes that both fill', *(f'`{filler}`' for filler in two.fillers)], rows)


def as_printed(a, results, folder):
    """The fronts with new vertices where the papers put them, beside those that are steady, on the same holes."""
    fronts = argparse.Namespace(bin=a.bin, fillers=[f for f in filler_bench.FILLERS if f not in ('auto', 'minimum-area')])
    steady = {(r['filler'], r['kind'], r['rim']): r for r in results}
    rows = []
    for merge in ('0.6', '0.8'):
        printed = []
        for kind in filler_bench.FORTY:
            for rim in filler_bench.RIMS[:7] if a.quick else filler_bench.RIMS:
                printed += by_filler(a, f'printed-{merge}-{kind}-{rim}', fronts, kind, rim, folder, *PRINTED_STEPS, '--front-merge', merge)
        for filler in fronts.fillers:
            own = [r for r in printed if r['filler'] == filler]
            good = [r for r in own if r['filled']]
            both = [(r['error'], steady[filler, r['kind'], r['rim']]['error']) for r in good if steady[filler, r['kind'], r['rim']]['filled']]
            rows.append([f'`{filler}`', merge, f'{len(good)}/{len(own)}', max((r['rim'] for r in good), default='–'), min((r['rim'] for r in own if not r['filled']), default='–'),
                         measure.down(filler_bench.mean_of(good, 'quality'), 3), sum(r['crossings'] for r in good), *(f'{error:.5f}' for error in np.mean(both, 0))])
    return measure.table(['', '`--front-merge`', 'filled', 'longest rim filled', 'shortest left open', 'mean quality', 'crossings', 'mean error', 'steady, same holes'], rows)


def part_fillers(a, folder):
    every = argparse.Namespace(bin=a.bin, fillers=filler_bench.FILLERS)
    results = []
    for kind in filler_bench.FORTY:
        for rim in filler_bench.RIMS[:7] if a.quick else filler_bench.RIMS:
            results += by_filler(a, f'fillers-{kind}-{rim}', every, kind, rim, folder)
    full = a.steps.write_table('fillers', filler_bench.table(results))
    a.steps.write_table('fillers-printed', as_printed(a, results, folder))
    a.steps.write_table('fillers-curved', other_curved(a, folder))
    return (measure.verdict('each filler on the same holes', f'{len(results) // len(filler_bench.FILLERS)} made holes', 'compared', ''),
            'Ten holes each on four surfaces, 10 to 403 edges. Error: distance over the hole\'s radius.\n\n' + papers_short.fillers(full) +
            '\n\n' + ahead_of_default(results))
