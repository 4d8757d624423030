"""The experiments of Wang et al. 2021 on made scenes: a part of reproduce.py for each of their tables and figures."""
import json
import os
import subprocess
import tempfile

import numpy as np

import measure
import peer
import scene_tools
import surface_bench
import surfaces
from papers_plots import axes_of, draw_fills

TYPES = [('closed', None), *(('I', t) for t in 'ABCD'), *(('II', t) for t in 'ABCD')]
SURFACES = ('wang', 'thin-plate')
HERE = os.path.dirname(os.path.abspath(__file__))
LAYOUTS = os.path.join(HERE, 'layouts')
HAN_LEFT = ['–'] * 9
PRINTED = {  # holes by TYPES; what the Han method filled
    'table1': ('Tables 1 and 2', [16, 4, 17, 0, 1, 0, 2, 0, 0], [16, 1, 9, 0, 1, 0, 0, 0, 0]),
    'table3': ('Table 3 (its type II: as in table 2)', [20, 5, 20, 4, 4, 0, 2, 0, 0], [20, 2, 12, 4, 4, 0, 0, 0, 0]),
    'table4': ('Tables 4 and 5, 449 cells', [56, 17, 43, 4, 3, 0, 5, 0, 1], HAN_LEFT),
}
SPACING = {'table1': 2.5, 'table3': 2.5, 'table4': 5}  # metres between vertices
# Cells -> km2, minutes and GB of the method and of Han's, tables 6 and 7.
AREAS = {8: (0.5, 3.9, 17.2, 0.8, 5.5), 16: (1.0, 6.7, 32.8, 0.8, 11.4), 24: (1.5, 11.6, 46.5, 1.0, 17.6), 32: (2.0, 15.2, 68.2, 1.2, 24.7)}
OF_OUTLINE = ('open edges off the rim', 'area covered too much, m2')  # what a zigzag at the rim of the area breaks
LONGEST_LOOP = 2000  # of aggregate: what it does if not told
MOST_MEMORY = '8000'  # MB of address space that it is given for 28 km2
LARGEST_PEER_MESH = 5e6  # triangles that the peer is given
FIGURE14 = {'cols': 2, 'rows': 2, 'closed': 0, 'relief': 2.45,
            'holes': [{'kind': 'disc', 'at': [0.98, 0.8, 0.5, 0.52]}, {'kind': 'disc', 'at': [1.0, 2.0, 0.62, 0.42]}]}
BETWEEN = 1.45 * 250  # a line of constant y between its closed and its unclosed hole


def program(a):
    return os.path.join(a.bin, 'tilemend')


def layout_path(name):
    own = os.path.join(LAYOUTS, f'{name}.json')
    return own if os.path.exists(own) else os.path.join(scene_tools.folder(), '..', 'scenes', f'{name}.json')


def made(folder, name, layout, *flags):
    """A scene of that layout, a path or what would be in it; made once a folder."""
    scene = os.path.join(folder, name)
    if not os.path.exists(os.path.join(scene, 'expected.json')):
        if isinstance(layout, dict):
            path = scene + '_layout.json'
            with open(path, 'w', encoding='utf-8') as file:
                json.dump(layout, file)
            layout = path
        scene_tools.run('make_table_scene.py', scene, layout, *flags)
    return scene


def aggregate_report(a, scene, out, *flags):
    done = subprocess.run([program(a), 'aggregate', scene, '--out', out, '-o', 'json', '--overwrite', *flags], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 100):
        raise SystemExit(f'aggregate: exit code {done.returncode}\n{done.stderr}')
    return json.loads(done.stdout)


def count(report, name, kind, letter):
    return report[name]['closed'] if kind == 'closed' else report[name][kind][letter]


def table_scene(folder, layout, cut):
    return made(folder, f'{layout}-{cut}', layout_path(layout), '--cut', cut, '--spacing', SPACING[layout])


def outline_of(a, layout, folder):
    """What the check says of the same ragged area with one closed hole, filled: what its outline breaks by itself."""
    with open(layout_path(layout), encoding='utf-8') as file:
        whole = json.load(file) | {'holes': [], 'closed': 1}
    scene = made(folder, f'{layout}-outline', whole, '--cut', 'ragged', '--spacing', SPACING[layout])
    scene_tools.fill(a.bin, scene, f'{scene}-filled', '--overwrite')
    checked = scene_tools.check(scene, f'{scene}-filled')
    return {k: checked[k] for k in OF_OUTLINE}


def promises(a, layout, cut, checked, folder):
    if cut == 'ragged' and checked['broken'] and len(checked['broken']) <= len(OF_OUTLINE):
        outline = a.steps.get(f'{layout}-outline', outline_of, a, layout, folder)
        if all(checked[k] == outline[k] for k in OF_OUTLINE):
            return f"all kept but what the outline breaks by itself: {outline[OF_OUTLINE[0]]} open edges, {outline[OF_OUTLINE[1]]:.2f} m²"
    return scene_tools.promises(checked)


def filled_row(a, layout, cut, surface, folder):
    scene = table_scene(folder, layout, cut)
    report = scene_tools.fill(a.bin, scene, f'{scene}-{surface}', '--surface', surface, '--overwrite')
    checked = scene_tools.check(scene, f'{scene}-{surface}')
    counts = (f"{count(report, 'filled', *t)}/{count(report, 'holes', *t)}" for t in TYPES)
    return [f'`{surface}`, {cut}', *counts, promises(a, layout, cut, checked, folder)]


def joined_row(a, layout, cut, folder):
    scene = table_scene(folder, layout, cut)
    report = aggregate_report(a, scene, f'{scene}.ply')
    return [f'`aggregate`, {cut}', f"{report['filled']['closed']} of {report['holes']['closed']} closed holes of the joined mesh", *[''] * 9]


def counts_table(a, layout, folder):
    name, printed, han = PRINTED[layout]
    rows = [['printed: holes, all filled by the method', *printed, ''], ['printed: filled by the Han method', *han, '']]
    for cut in ('clipped',) if a.quick else ('clipped', 'ragged'):
        rows += [a.steps.get(f'{layout}-{cut}-{s}', filled_row, a, layout, cut, s, folder) for s in SURFACES]
        rows.append(a.steps.get(f'{layout}-{cut}-aggregate', joined_row, a, layout, cut, folder))
    return f'{name}; filled of found\n\n' + measure.table(['', 'closed', *(f'{k} {t}' for k, t in TYPES[1:]), '`check_fill.py`'], rows)


def part_tables(a, folder):
    return ('Scenes with as many holes of each type stand in for the reconstruction of Dongying: cells of 250 m, vertices 2.5 m apart, in the 449 cells 5 m. Joining makes one '
            'closed hole of the open ones of type I that belong together, so that holes of the joined mesh are fewer; those of type II stay open. '
            'In print the Han method fails at tables 4 and 5 for the size of the input.\n\n' +
            '\n\n'.join(counts_table(a, layout, folder) for layout in PRINTED if not (a.quick and layout == 'table4')) + ('' if a.quick else ZIGZAG))


ZIGZAG = ('\n\nOn the ragged cut of tables 4 and 5 the surface ends in a zigzag where there are cells outside the area. That is no hole. The check counts its edges as open, and '
          'takes for what is to be covered the area of the cells less that of the tiles, of which the zigzag lies outside the cells on balance. So it finds the same '
          'edges and area in the same area with one closed hole, which is filled, and no other; with `--border-zone 8` the open edges are gone.')


def area_layout(cells):
    """Blocks of 4 x 2 cells, each with a lake over four of them, a pond at the rim and four closed holes."""
    blocks = cells // 8
    discs = [d for b in range(blocks) for d in ([2, 2 * b + 1, .38, .38], [4, 2 * b + .5, .15, .17])]
    return {'cols': 4, 'rows': 2 * blocks, 'closed': 4 * blocks, 'relief': 12, 'holes': [{'kind': 'disc', 'at': d} for d in discs]}


def figures_of(run):
    return {'wall': run.wall, 'cpu': run.cpu, 'peak': run.peak, 'code': run.code}


def surface_run(a, scene, surface):
    return figures_of(measure.Run([program(a), 'run', scene, '--out', f'{scene}-{surface}', '--surface', surface, '--overwrite'], accept=(0, 100)))


def joined_run(a, scene, *flags):
    """Exit code 5 or 6: out of the memory that it may take."""
    return figures_of(measure.Run([program(a), 'aggregate', scene, '--out', f'{scene}.ply', '--overwrite', *flags], accept=(0, 5, 6, 100)))


def triangle_count(cells, spacing):
    return 2 * (250 / spacing) ** 2 * cells


def peer_run(a, scene, folder):
    points, originals = surfaces.close_rim(*surfaces.merged(scene))
    mesh, out = f'{scene}.off', f'{scene}-peer.off'
    surfaces.write_off(mesh, points, originals)
    return figures_of(peer.fill(driver(a, folder), 'cdt', mesh, out)[0])


def driver(a, folder):
    path = os.path.join(folder, 'peer')
    return path if os.path.exists(path) else peer.build(a.peer_source, folder)


def has_peer(a):
    return not peer.missing(a.peer_source)


def efficiency_row(a, cells, spacing, folder):
    scene = made(folder, f'area{cells}-{spacing}', area_layout(cells), '--spacing', spacing)
    result = {s: surface_run(a, scene, s) for s in SURFACES} | {'aggregate': joined_run(a, scene)}
    if has_peer(a):
        result['peer'] = peer_run(a, scene, folder) if triangle_count(cells, spacing) <= LARGEST_PEER_MESH else None
    subprocess.run(['rm', '-rf', scene, *(f'{scene}{end}' for end in ('-wang', '-thin-plate', '.ply', '.off', '-peer.off'))], check=True)
    return result


def ratio(r, key):
    return r['aggregate'][key] / r['wang'][key]


def part_efficiency(a, folder):
    rows, points = [], {}
    for spacing in a.spacings:
        for cells in a.areas:
            area, minutes, han_minutes, memory, han_memory = AREAS[cells]
            r = a.steps.get(f'efficiency-{cells}-{spacing:g}', efficiency_row, a, cells, spacing, folder)
            printed = han_minutes / minutes, han_memory / memory
            points.setdefault(spacing, []).append((area, ratio(r, 'wall'), ratio(r, 'peak'), *printed))
            runs = [r['wang'], r['thin-plate'], r['aggregate'], r.get('peer')]
            rows.append([f'{area} km², {spacing:g} m', f'{triangle_count(cells, spacing) / 1e6:.2f}',
                         *('–' if k is None else f"{measure.up(k['wall'], 1)} ({measure.up(k['cpu'], 1)})" for k in runs), f"{ratio(r, 'wall'):.1f} ({ratio(r, 'cpu'):.1f})",
                         f'{printed[0]:.1f}', *('–' if k is None else measure.megabytes(k['peak']) for k in runs), f"{ratio(r, 'peak'):.1f}", f'{printed[1]:.1f}'])
    plot_ratios(points)
    names = ['`wang`', '`thin-plate`', '`aggregate`', 'CGAL']
    heads = ['', 'million triangles', *(f'{n}, s (CPU)' for n in names), 'ratio', 'printed', *(f'{n}, MB' for n in names), 'ratio', 'printed']
    return (f'Cells of 250 m with the vertices as far apart as the first column says; in each 0.5 km² a lake over four cells, a pond at the rim and four closed holes. '
            'Ratios are of `aggregate` to `wang`; the printed ones are of tables 6 and 7 (the Han method to the paper\'s). `aggregate` leaves holes of more than '
            f'{LONGEST_LOOP} boundary vertices open, as it does if not told otherwise. CGAL fills the welded mesh by constrained Delaunay triangles; it reads and writes text files, and '
            f'was not given more than {LARGEST_PEER_MESH / 1e6:.0f} million triangles.\n\n' + measure.table(heads, rows) +
            '\n\n![ratios of time and memory](images/papers_efficiency.png)\n\n' + EFFICIENCY_WHY)


EFFICIENCY_WHY = (
    'What decides is how large the tiles are. With vertices 2.5 m apart a tile has 20,000 triangles: the joined mesh is small, `aggregate` reads, joins, fills and writes it in one '
    'process in half a CPU second, and what layers, tasks and the seam pass cost does not pay; the printed method takes 234 s for the smallest area, Han\'s 1,032 s. The paper\'s '
    'tiles have millions of triangles (its section 2.2). With tiles like that the joined mesh has to be built, held and written as a whole, while a cell is read, '
    'surveyed and copied on its own. So the ratio of time grows with the tiles, and that of memory with the area: `wang` holds the tiles in flight, `aggregate` everything. Of the '
    'peak of `wang` 28 MB are the program itself. With vertices 0.5 m apart the triangulation of least area adds to that: it takes n³ steps. In the row '
    'of 0.5 km² one lake with 1,429 boundary vertices takes 37 % of the CPU seconds of `aggregate`. `wang` cuts such boundaries. Seconds were taken on a machine with other work to '
    'do, both ways one after the other: ratios of CPU seconds are the better measure.')


def plot_ratios(points):
    def draw(axes):
        for k, (ours, printed, title) in enumerate(((1, 3, 'time'), (2, 4, 'memory'))):
            for spacing, of_spacing in points.items():
                axes[k].plot([p[0] for p in of_spacing], [p[ours] for p in of_spacing], 'o-', label=f'here, {spacing:g} m')
            any_spacing = next(iter(points.values()))
            axes[k].plot([p[0] for p in any_spacing], [p[printed] for p in any_spacing], 'ks--', label='printed')
            axes[k].set(title=f'{title}: joined over by cells', xlabel='km²', ylim=(0, None))
            axes[k].legend(fontsize=8)
    axes_of('papers_efficiency.png', draw)


def large_row(a, way, folder):
    scene = made(folder, 'large', layout_path('table4'), '--spacing', a.large_spacing)
    if way == 'aggregate':
        return joined_run(a, scene, '--memory', MOST_MEMORY)
    result = surface_run(a, scene, way)
    subprocess.run(['rm', '-rf', f'{scene}-{way}'], check=True)
    return result


def part_large(a, folder):
    if a.quick:
        return None
    rows = [['printed: the method', '', '230 min', '', '3,200'], ['printed: the Han method', '', 'fails', '', '']]
    million = triangle_count(449, a.large_spacing) / 1e6
    for way in (*SURFACES, 'aggregate'):
        r = a.steps.get(f'large-{a.large_spacing:g}-{way}', large_row, a, way, folder)
        rows.append([f'`{way}`', f'{million:.0f}', f"{measure.up(r['wall'], 0)} s" if r['code'] in (0, 100) else f'out of {MOST_MEMORY} MB', f"{measure.up(r['cpu'], 0)} s", f"{r['peak'] / 1e6:,.0f}"])
    return ('The 449 cells of tables 4 and 5, 28 km², with vertices ' + f'{a.large_spacing:g} m apart. The paper\'s figures are of its own tiles, whose triangles it does not count, and of '
            'another computer; what can be compared is that memory stays far below the size of the scene, and that joining does not fit into the 8000 MB that it is given.\n\n' +
            measure.table(['', 'million triangles', 'time', 'CPU', 'peak, MB'], rows))


def accuracy_of(corners, truth, points):
    """Figures of figure 17 at all removed vertices of the closed hole, and signed differences at `points` of them."""
    difference = surfaces.over(corners, truth)[1] - truth[:, 2]
    closed = truth[:, 1] < BETWEEN

    def figures(d):
        d = d[~np.isnan(d)]
        return [float(np.abs(d).mean()), float(np.abs(d).max()), float(d.std())] if len(d) else None
    return {'points': figures(difference[points]), 'closed': figures(difference[closed]), 'unclosed': figures(difference[~closed]),
            'at': difference[points].tolist(), 'share': float(1 - np.isnan(difference[~closed]).mean())}


def spread_points(truth, n=34):
    """That many of the closed hole's removed vertices, evenly spread, from the rim inward."""
    inside = np.flatnonzero(truth[:, 1] < BETWEEN)
    chosen = [inside[0]]
    distance = np.full(len(inside), np.inf)
    for _ in range(n):
        distance = np.minimum(distance, np.hypot(*(truth[inside, :2] - truth[chosen[-1], :2]).T))
        chosen.append(inside[distance.argmax()])
    chosen = np.array(chosen[1:])
    middle = truth[inside, :2].mean(0)
    return chosen[np.argsort(-np.hypot(*(truth[chosen, :2] - middle).T))]


def accuracy_step(a, seed, folder):
    scene = made(folder, f'figure14-{seed}', FIGURE14, '--spacing', 1, '--seed', seed)
    truth = surfaces.truth_of(scene)
    points = spread_points(truth)
    result = {'relief': float(np.ptp(truth[truth[:, 1] < BETWEEN, 2]))}
    for surface in SURFACES:
        scene_tools.fill(a.bin, scene, f'{scene}-{surface}', '--surface', surface, '--overwrite')
        result[surface] = accuracy_of(surfaces.filled(f'{scene}-{surface}'), truth, points)
    aggregate_report(a, scene, f'{scene}-aggregate.ply')
    result['aggregate'] = accuracy_of(surfaces.filled(f'{scene}-aggregate.ply'), truth, points)
    if has_peer(a):
        peer_points, originals = surfaces.close_rim(*surfaces.merged(scene))
        surfaces.write_off(f'{scene}.off', peer_points, originals)
        peer.fill(driver(a, folder), 'cdt', f'{scene}.off', f'{scene}-peer.off')
        peer_points, triangles = surfaces.read_off(f'{scene}-peer.off')
        result['CGAL'] = accuracy_of(peer_points[triangles[len(originals):]], truth, points)
    if seed == 1:
        draw_fills(scene, {'figure 15: joined, then filled': f'{scene}-aggregate.ply', 'figure 16: wang': f'{scene}-wang', 'thin-plate': f'{scene}-thin-plate'})
    return result


def three(figures):
    return [measure.up(f, 2) for f in figures] if figures else ['not filled', '', '']


def part_accuracy(a, folder):
    rows = [['', 'printed: the Han method', '2.02', '0.16', '0.36', '0.18', '', 'not filled', ''], ['', 'printed: the method', '2.02', '0.10', '0.23', '0.11', '', '', '']]
    results = {}
    for seed in (1,) if a.quick else (1, 2, 3, 4, 5):
        r = results[seed] = a.steps.get(f'accuracy-{seed}', accuracy_step, a, seed, folder)
        for way in (w for w in ('aggregate', 'CGAL', *SURFACES) if w in r):
            rows.append([seed, way if way == 'CGAL' else f'`{way}`', f"{r['relief']:.2f}", *three(r[way]['points']), three(r[way]['closed'])[0], *three(r[way]['unclosed'])[:2]])
    plot_accuracy(results[1])
    heads = ['seed', '', 'relief, m', 'at 34 points: mean, m', 'max, m', 'std, m', 'closed hole, everywhere: mean, m', 'unclosed: mean, m', 'max, m']
    return ('The layout of figure 14 on made ground: a closed and an unclosed hole, 76,000 m², which four cells divide into four open holes of type I and two of type II. '
            'Differences to the surface that was removed at 34 points that are spread evenly over the closed hole, as in the paper, and everywhere. `aggregate` refines, adjusts and '
            'fairs what it has triangulated, as `wang` does.\n\n' + measure.table(heads, rows) +
            '\n\n![figures 14 to 16: the holes and three fills](images/papers_figure14.png)\n\n![figure 17: differences at 34 points](images/papers_figure17.png)')


def plot_accuracy(result):
    def draw(axes):
        for k, ways in enumerate((('aggregate', 'wang'), ('CGAL', 'thin-plate'))):
            for way in (w for w in ways if w in result):
                axes[k].plot(range(1, 35), result[way]['at'], 'o-', markersize=3, label=way)
            axes[k].axhline(0, color='0.6', linewidth=.8)
            axes[k].set(xlabel='point, from the rim inward', ylabel='fill - truth, m')
            axes[k].legend(fontsize=8)
    axes_of('papers_figure17.png', draw, (9, 3))


def surface_step(a, make, seed, arguments, folder):
    with tempfile.TemporaryDirectory(dir=folder) as own:
        return surface_bench.errors(a.bin, make(own, seed, *arguments))


def part_surface(a, folder):
    with open(os.path.join(HERE, 'wang_variant.json'), encoding='utf-8') as file:
        before = json.load(file)
    groups = {}
    for name, (make, *arguments) in surface_bench.makers().items():
        for seed in (2,) if a.quick else (1, 2, 3):
            r = a.steps.get(f'surface-{name.replace(" ", "_").replace("/", "-")}-{seed}', surface_step, a, make, seed, arguments, folder)
            if r:
                groups.setdefault(name.rsplit(', ', 1)[0], []).append((before.get(f'{name}, seed {seed}', np.nan), r['wang'], r['thin-plate'], r['broken']))
    every = [r for of_name in groups.values() for r in of_name]
    rows = [surface_row(name, of_name) for name, of_name in (*groups.items(), ('all', every))]
    return (f'The {len(every)} scenes of `surface_bench.py` with two layers or more, clipped and ragged, three seeds; mean errors at all removed vertices in metres, and the means of the '
            'scenes\' ratios. *Before* is the height-field variant of `wang` that was here until 2026-11-22.\n\n' +
            measure.table(['', 'scenes', '`wang` before', '`wang`', '`thin-plate`', '`wang` / before', '`thin-plate` / `wang`', 'broken promises'], rows))


def surface_row(name, results):
    figures = np.array([r[:3] for r in results], float)
    now, plate = figures[:, 1] / figures[:, 0], figures[:, 2] / figures[:, 1]
    return [name, len(results), *(f'{m:.3f}' for m in np.nanmean(figures, 0)), f'{np.nanmean(now):.2f}', f'{plate.mean():.2f}', sum(bool(r[3]) for r in results)]
