"""The experiments of the papers about single holes: a part of reproduce.py for each."""
import argparse
import itertools
import json
import os
import subprocess

import numpy as np

import filler_bench
import measure
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
    return (measure.verdict('Sun, table 1 and figure 6', 'curved sheets with the printed rims', 'reproduced' if good else 'in part',
                            f'{len(filled)} of {len(SUN)} filled; mean quality {measure.down(worst, 2)} and more beside "larger than 0.85"; new vertices {sum(r[6] for r in rows if isinstance(r[6], int))} beside {sum(m[2] for m in SUN)}; '
                            f'with the steps to the letter {len(as_printed)} of {len(SUN)}') +
            'Curved sheets stand in for the scanned plants, which cannot be had. Sun prints no rims; a patch of T triangles with V new vertices has a rim of T - 2 V + 2 edges, which makes '
            f'{", ".join(str(m[1]) for m in SUN)}. The holes have exactly these rims, and are as long and narrow as it takes for about as many vertices to have been removed as were put in in print. '
            'The paper\'s mean qualities are above 0.85; its seconds are of a computer of 2011 or before. With `--front-steps printed` new vertices go where eq. 4 to 6 say to the letter, with η of half an edge; larger fronts do '
            'not always close so (see [all fillers](#all-fillers-on-the-same-holes)).\n\n' + measure.table(heads, rows) +
            '\n\n![quality of the new triangles](images/papers_sun.png)')


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
    tables, found = [], {}
    for steps in XU_STEPS:
        base = f'`advancing-front-poisson` {steps}'
        keys = [f'{way} {steps}' for way in XU_WAYS if way != '`auto`'] + (['`auto` steady'] if steps == 'steady' else [])
        rows = [xu_row(every, key, base) for key in keys]
        found[steps] = {key.rsplit(' ', 1)[0]: row[1:] for key, row in zip(keys, rows)}
        tables.append(f'New vertices {"where the front is steady (default)" if steps == "steady" else "as in the papers (`--front-steps printed`)"}:\n\n' + measure.table(heads, [row[0] for row in rows]))
    kinds = [[kind, *(f"{xu_row(of_kind, f'`svm-laplacian` {steps}', f'`advancing-front-poisson` {steps}')[1]:.2f}" for steps in XU_STEPS),
              *(f"{xu_row(of_kind, f'`svm-laplacian` `--svm-laplacian mean` {steps}', f'`advancing-front-poisson` {steps}')[1]:.2f}" for steps in XU_STEPS)] for kind, of_kind in results.items()]
    worst = max(float(cell) for row in kinds for cell in row[1:3])
    ratio, ahead, count = found['printed']['`svm-laplacian`']
    steady_ratio, steady_ahead, _ = found['steady']['`svm-laplacian`']
    return (measure.verdict('Xu, table 1', f'closed heads, rim of {XU_RIM}', 'reproduced' if worst < 1 else 'in part' if min(ratio, steady_ratio) < 1 else 'not',
                            f'the learnt Laplacians over Zhao\'s distance: {ratio:.2f} with the front to the letter, {steady_ratio:.2f} with the steady one; 0.84 (0.042 over 0.05) in print; ahead on {ahead} and {steady_ahead} of {count} heads: the smooth ones, not those with details, which print claims') +
            measure.verdict('Xu, table 2', 'the same', 'not', 'times of the single steps are not taken: the whole process with its files takes what the two steps take in print') +
            f'Closed surfaces of radius 100 stand in for the head, which cannot be had: a sphere, an ellipsoid, and two with ripples and bumps; {" and ".join(map(str, XU_VERTICES))} vertices, '
            f'{len(every)} holes. Patches of 69 triangles with 28 new vertices and of 75 with 31 have rims of {XU_RIM} edges; so have these holes. In print about twice as many vertices go in as even '
            'triangles of the rim\'s size have room for: that hole is deeper, or its front made smaller triangles, than here. The distance is that of the new vertices to the analytic surface, and the error is it over the root '
            'of the surface\'s area, as in print; the printed pairs 0.05 and 0.0015, 0.042 and 0.00142 belong to areas of 1,111 and 875, so that they are rounded or of two surfaces.\n\n' +
            measure.table(['', 'mean distance', 'error'], [['printed: reference 17 (Zhao)', '0.05', '0.00150'], ['printed: the paper', '0.042', '0.00142']]) + '\n\n' + '\n\n'.join(tables) +
            '\n\nBy surface, the distance of `svm-laplacian` over that of Zhao\'s Poisson equation (geometric means; below 1 it is ahead):\n\n' +
            measure.table(['', 'eq. 4, steady', 'eq. 4, printed', 'eq. 2, steady', 'eq. 2, printed'], kinds) + '\n\n' + XU_WHY)


XU_WHY = ('What decides is which Laplacian is learnt. Section 2.1 prints two: eq. 1 to 3, the weighted mean of the neighbours less the vertex, which grows with the square of the edges, and eq. 4, the same sum over the '
          'Voronoi area, of which the paper says that it is the mean curvature and what describes details. Learnt by eq. 2 the Laplacians of the surface are too large for the front\'s shorter edges: the patch bulges, and is '
          'behind Zhao\'s. By eq. 4 (`--svm-laplacian area`, the default) it is ahead where the paper\'s function from one coordinate to one component can say what the surface does: on a sphere '
          'and an ellipsoid. On heads with ripples and bumps one coordinate does not tell the curvature, and it stays behind: that it restores details, as on the hair of figure 8, is not had again. The number of rings (3), γ (10) and the width of the kernel (10 edges) are not printed; rings of 1 to 8, γ of 10 to 10⁵ and widths of 2 '
          'to 30 edges change little beside that. Zhao\'s paper is not at hand; the baseline is as Xu and others tell it ([choices](decisions/2026-11-22-published-fillers.md)).')


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
    order = ', '.join(f'{kind} {s:.1f}' for kind, s in sorted(share.items(), key=lambda k: k[1]))
    more = share['plane'] < 1.1 < share['bump']
    return (measure.verdict('advancing front with curvature, claims of sections 3 to 5 (no table printed)', 'the made holes of 16 to 80 edges', 'in part',
                            f'closed {closed} of {asked} holes beside "any shape"; vertices after over before refinement: {order}' + ('; none on a plane' if more else '; a plane is refined as well')) +
            'The paper prints no table and no figures to be had again. It says that the front closes holes of any shape, that edges are halved where |Gaussian curvature| is above the mean of the rim, so that flat '
            'areas are not refined, and that flips and weighted centroids then give even triangles. Here `--halvings 0` is the front with flips and centroids alone, beside the default of 2, on made holes of 16, 24, 36, 54 and 80 edges:\n\n' +
            measure.table(['', 'filled', 'new vertices before', 'after refinement', 'ratio', 'error before', 'after', 'mean quality before', 'after', 'crossings'], rows) + '\n\n' + CURVATURE_WHY +
            ' The same filler beside the others is in [all fillers](#all-fillers-on-the-same-holes).')


CURVATURE_WHY = ('On a plane nothing is refined, as the paper says. Beyond that Gaussian curvature is no measure of bending: it is nought on a cylinder and on the sides of a crease, and noise of 0.02 edges has as much of it as '
                 'the surfaces here. The threshold is the mean over the rim, so that about as many edges are halved on nearly flat ground as on a bump: on the bump and the crease refinement takes the error down, elsewhere it does not. What is '
                 'refined has more vertices with four neighbours, which costs quality.')


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
    return (measure.verdict('Zhang, table 2', 'one made sheet of each kind', 'in part', f'{right} of {len(rows)} kinds told and {filled} filled without crossings, all in print; the scanned models and Geomagic are not at hand') +
            'Made sheets with one hole of each kind stand in for the scanned models, which cannot be had: the crack is 0.02 edges wide, the dislocation 0.15 high. The paper\'s method identifies and repairs all kinds that '
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
    return ('`--front-steps printed` puts new vertices on the plane of the front\'s two edges, as far off as these are long in the mean (Sun\'s eq. 4 and 6 to the letter; Xu 3.2). '
            'Rounding and noise then grow with every row, and edges get shorter: large holes stay open. The papers do not print how near a vertex has to be to be merged (Xu 3.2, step 4); '
            'more is closed where it may be further off, by worse triangles.\n\n' +
            measure.table(['', '`--front-merge`', 'filled', 'longest rim filled', 'shortest left open', 'mean quality', 'crossings', 'mean error', 'steady, same holes'], rows))


def part_fillers(a, folder):
    every = argparse.Namespace(bin=a.bin, fillers=filler_bench.FILLERS)
    results = []
    for kind in filler_bench.FORTY:
        for rim in filler_bench.RIMS[:7] if a.quick else filler_bench.RIMS:
            results += by_filler(a, f'fillers-{kind}-{rim}', every, kind, rim, folder)
    counts = '; '.join(f"`{f}` {sum(r['filled'] for r in results if r['filler'] == f)}" for f in filler_bench.FILLERS)
    return (measure.verdict('no table: each filler on the same holes', '40 made holes', 'compared', f'filled of {len(results) // len(filler_bench.FILLERS)}: {counts}') +
            '`tests/bench/filler_bench.py`: the same 40 made holes, ten each on nearly flat ground, a curved surface, a folded sheet and the wall of a tube, with 10 to '
            '403 boundary vertices. An error is the mean distance from what was removed to the triangles of the patch, over the radius of the hole. '
            'A fill of more than 30 s counts as not filled.\n\n' + filler_bench.table(results) + '\n\n' + ahead_of_default(results) +
            ' The nearly flat ground is even but for 0.02 edges that no filler can know. The default sees at rims of 20 edges and more that their heights are nothing but noise, '
            'and goes on with none of their slopes; smaller ones it takes at their word. The curved sheet turns most in the middle of its holes, which no boundary tells. The equation of Poisson raises every '
            'curved surface, also those that bend evenly: on that sheet and on the bump below this falls the right way, on the others the default is ahead. Four holes on each surface, of 16 to 120 edges, mean errors:\n\n' + other_curved(a, folder) +
            '\n\n' + as_printed(a, results, folder))
