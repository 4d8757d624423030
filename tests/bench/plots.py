"""The pictures of the benchmarks. Needs numpy, scipy and matplotlib (Debian: python3-matplotlib)."""
import os
import re
import tempfile

import matplotlib
import numpy as np

import measure
import scene_tools
import surfaces

matplotlib.use('Agg')
import matplotlib.pyplot as plt

IMAGES = os.path.join(measure.ROOT, 'docs', 'images')
CELL, SPACING = 100, 2.5
# One lake of 500 m by 440 m over 6 x 6 cells.
LAKE = ('--cols', 6, '--rows', 6, '--cell', CELL, '--spacing', SPACING, '--seed', 2, '--relief', 20, '--hurst', 1.0, '--holes',
        'none', '--ellipse', '300,300,250,220')


def save(figure, folder, name):
    figure.savefig(os.path.join(folder, name), dpi=110, metadata={'Software': None})
    plt.close(figure)


def draw_map(axes, truth, errors, limit):
    """Signed errors on a raster of the vertices' spacing, the grid's lines over it."""
    column, row = np.round(truth[:, :2] / SPACING).astype(int).T  # the scene maker moves a vertex by less than half a step
    sums, counts = (np.zeros((row.max() + 1, column.max() + 1)) for _ in range(2))
    np.add.at(sums, (row, column), errors)
    np.add.at(counts, (row, column), 1)
    with np.errstate(invalid='ignore'):
        image = axes.imshow(sums / counts, cmap='RdBu_r', vmin=-limit, vmax=limit, origin='lower', interpolation='nearest',
                            extent=(0, sums.shape[1] * SPACING, 0, sums.shape[0] * SPACING))
    lo, hi = truth[:, :2].min(0) - 10, truth[:, :2].max(0) + 10
    for x in range(0, 7 * CELL, CELL):
        axes.axvline(x, color='0.6', linewidth=0.6)
        axes.axhline(x, color='0.6', linewidth=0.6)
    axes.set(xlim=(lo[0], hi[0]), ylim=(lo[1], hi[1]), xlabel='m')
    return image


def error_map(bin_folder, images):
    """Draws error_map.png in `images`: the errors of both surfaces over one lake on one scale. Returns their figures as a table."""
    with tempfile.TemporaryDirectory(prefix='tilemend-bench-') as folder:
        scene = os.path.join(folder, 'scene')
        scene_tools.run('make_scene.py', scene, *LAKE)
        truth, errors = surfaces.truth_of(scene), {}
        for surface in ('wang', 'thin-plate'):
            scene_tools.fill(bin_folder, scene, f'{scene}-{surface}', '--surface', surface)
            errors[surface] = surfaces.over(surfaces.filled(f'{scene}-{surface}'), truth)[1] - truth[:, 2]
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8), sharey=True, layout='constrained')
    limit = np.nanmax(np.abs(list(errors.values())))
    for side, (surface, e) in zip(axes, errors.items()):
        image = draw_map(side, truth, e, limit)
        side.set_title(f'{surface}: mean |error| {np.nanmean(np.abs(e)):.2f} m', fontsize=10)
    axes[0].set_ylabel('m')
    figure.colorbar(image, ax=axes, label='fill - truth, m', shrink=0.9)
    save(figure, images, 'error_map.png')
    return measure.table(['surface', 'points', 'relief, m', 'mean error, m', 'max error, m'],
                         [[f'`{s}`', f'{len(truth):,}', measure.down(np.ptp(truth[:, 2]), 1),
                           measure.up(np.nanmean(np.abs(e)), 3), measure.up(np.nanmax(np.abs(e)), 2)]
                          for s, e in errors.items()])


def growth_series(table):
    """Of the table of hole_bench.py: name of a series -> [(new vertices, seconds)] of its river meshes, r1000 and up."""
    series = {}
    for line in table.splitlines():
        cells = [c.strip() for c in line.strip('|').split('|')]
        name = re.fullmatch(r'r\d+( --uniform)?', cells[0])
        if not name:
            continue
        ours, peers, seconds, peer_seconds = (float(c.replace(',', '')) for c in cells[1:5])
        series.setdefault(f'tilemend{name.group(1) or ""}', []).append((ours, seconds))
        if not name.group(1):
            series.setdefault('CGAL', []).append((peers, peer_seconds))
    return series


def growth(table):
    """Draws docs/images/growth.png: seconds over new vertices, with the exponents of the lines fitted to their logarithms."""
    figure, axes = plt.subplots(figsize=(6, 4), layout='constrained')
    for (name, points), marker in zip(growth_series(table).items(), 'osv'):
        vertices, seconds = np.array(sorted(points)).T
        slope, offset = np.polyfit(np.log(vertices), np.log(seconds), 1)
        line = axes.loglog(vertices, seconds, marker, label=f'{name}: exponent {measure.up(slope, 2)}')[0]
        axes.loglog(vertices, np.exp(offset) * vertices ** slope, color=line.get_color(), linewidth=1)
    axes.set(xlabel='new vertices', ylabel='seconds')
    axes.grid(True, which='both', linewidth=0.3)
    axes.legend()
    save(figure, IMAGES, 'growth.png')
