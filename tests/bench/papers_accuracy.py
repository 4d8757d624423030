"""The experiment of Wang et al. 2021, figures 14 to 17, on made ground: a part of reproduce.py."""
import numpy as np

import measure
import papers_short
import peer
import scene_tools
import surfaces
from papers_plots import axes_of, draw_fills
from papers_wang import SURFACES, aggregate_report, driver, has_peer, made

FIGURE14 = {'cols': 2, 'rows': 2, 'closed': 0, 'relief': 2.45,
            'holes': [{'kind': 'disc', 'at': [0.98, 0.8, 0.5, 0.52]}, {'kind': 'disc', 'at': [1.0, 2.0, 0.62, 0.42]}]}
BETWEEN = 1.45 * 250  # a line of constant y between its closed and its unclosed hole


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
    return [measure.up(f, 3) for f in figures] if figures else ['not filled', '', '']


def accuracy_row(label, relief, name, points, closed, unclosed):
    return [label, name, f'{relief:.2f}', *three(points), three(closed)[0], *three(unclosed)[:2]]


def mean_accuracy(results, way):
    """Over the seeds: what accuracy_of has, without the points."""
    return {part: None if results[0][way][part] is None else np.mean([r[way][part] for r in results], 0).tolist() for part in ('points', 'closed', 'unclosed')}


def part_accuracy(a, folder):
    rows = [['', 'printed: the Han method', '2.02', '0.16', '0.36', '0.18', '', 'not filled', ''], ['', 'printed: the method', '2.02', '0.10', '0.23', '0.11', '', '', '']]
    seeds = (1,) if a.quick else (1, 2, 3, 4, 5)
    results = [a.steps.get(f'accuracy-{seed}', accuracy_step, a, seed, folder) for seed in seeds]
    ways = [w for w in ('aggregate', 'CGAL', *SURFACES) if w in results[0]]
    names = {w: w if w == 'CGAL' else f'`{w}`' for w in ways}
    means = {way: mean_accuracy(results, way) for way in ways}
    relief = np.mean([r['relief'] for r in results])
    rows += [accuracy_row('mean', relief, f'**{names[way]}**', means[way]['points'], means[way]['closed'], means[way]['unclosed']) for way in ways]
    rows += [accuracy_row(seed, r['relief'], names[way], r[way]['points'], r[way]['closed'], r[way]['unclosed']) for seed, r in zip(seeds, results) for way in ways]
    plot_accuracy(results[0])
    heads = ['seed', '', 'relief, m', 'at 34 points: mean, m', 'max, m', 'std, m', 'closed hole, everywhere: mean, m', 'unclosed: mean, m', 'max, m']
    gain = 100 * (1 - means['wang']['points'][0] / means['aggregate']['points'][0])
    table = a.steps.write_table('accuracy', measure.table(heads, rows))
    return (measure.verdict('Wang, figures 14 to 17: accuracy', f'made ground, {len(seeds)} seeds', 'in part',
                            f'`wang` is {gain:.0f} % below joined tiles at 34 points; 37.5 % in print'),
            'Means over the seeds, at 34 points and everywhere.\n\n' + papers_short.accuracy(table))


def plot_accuracy(result):
    def draw(axes):
        for k, ways in enumerate((('aggregate', 'wang'), ('CGAL', 'thin-plate'))):
            for way in (w for w in ways if w in result):
                axes[k].plot(range(1, 35), result[way]['at'], 'o-', markersize=3, label=way)
            axes[k].axhline(0, color='0.6', linewidth=.8)
            axes[k].set(xlabel='point, from the rim inward', ylabel='fill - truth, m')
            axes[k].legend(fontsize=8)
    axes_of('papers_figure17.png', draw, (9, 3))
