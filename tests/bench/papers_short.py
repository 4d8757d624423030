"""The tables of docs/papers.md, made of the full tables of the experiments, and where the papers' equations are in the sources."""
import measure
from summaries import cells_of

SPANS = {'closed': slice(1, 2), 'I': slice(2, 6), 'II': slice(6, 10)}  # columns of the tables of holes by type


def columns(table, wanted, keep=lambda row: True):
    """Some columns, by number, of some rows."""
    (heads, *rows), _ = cells_of(table)
    return measure.table([heads[k] for k in wanted], [[row[k] for k in wanted] for row in rows if keep(row)])


def filled(rows, start, span, end=None):
    """Of the rows whose name begins so, the one with the fewest holes filled: their sum over the columns."""
    chosen = [row for row in rows if row[0].startswith(start) and (end is None or row[0].endswith(end))]
    return min(sum(int(cell.split('/')[0]) if cell != '–' else 0 for cell in row[span]) for row in chosen)


def counts(tables):
    """Filled holes by type, of the worse cut. `tables`: full ones by name."""
    short = []
    for name, table in tables.items():
        (_, *rows), _ = cells_of(table)
        han = next(row for row in rows if row[0] == 'printed: filled by the Han method')
        joined = [cut for cut in ('clipped', 'ragged') if any(row[0] == f'`aggregate`, {cut}' for row in rows)]
        ways = [[filled(rows, start, span) for span in SPANS.values()] for start in ('printed: holes', '`wang`', '`thin-plate`')]
        ways += [[min(filled(rows, '`aggregate`', span, cut) for cut in joined) for span in SPANS.values()], [filled(rows, '`aggregate`', span, '400`') for span in SPANS.values()]]
        ways = [', '.join(map(str, way)) for way in ways]
        short.append([name, *ways[:3], 'fails' if han[1] == '–' else ', '.join(str(filled([han], '', span)) for span in SPANS.values()), *ways[3:]])
    return measure.table(['tables', 'holes, printed', '`wang`', '`thin-plate`', 'Han, printed', '`aggregate`', '`--longest-loop 400`'], short)


def accuracy(table):
    return columns(table, (1, 3, 4, 5, 6, 7, 8), lambda row: row[0] in ('', 'mean'))


def sun(table):
    return columns(table, (0, 1, 3, 6, 9, 10))


def xu(tables):
    """Of both ways to place new vertices. `tables`: full ones by name."""
    rows = {'printed: reference 17 (Zhao)': ['0.05'], 'printed: the paper': ['0.042', '', '']}
    for table in tables.values():
        (_, *own), _ = cells_of(table)
        for row in own:
            rows.setdefault(row[0], []).extend([row[4], row[6], row[7]])
    heads = [f'{name}: {head}' if k == 0 else head for name in tables for k, head in enumerate(('distance', 'over Zhao\'s', 'ahead'))]
    return measure.table(['', *heads], [[name, *cells, *[''] * (len(heads) - len(cells))] for name, cells in rows.items()])


def curvature(table):
    return columns(table, (0, 1, 4, 5, 6, 7, 8))


def fillers(table):
    return columns(table, (0, 2, 3, 4, 6, 8, 9), lambda row: row[1] == 'all')


WANG, FRONT, HOLE, SEAM = 'worker/papers/wang', 'worker/papers/front', 'coordinator/plan/hole', 'coordinator/plan/seam'
SOURCES = (  # paper; section or equation; files
    ('Wang 2021', '2.1 (Han 2019)', 'client/aggregate.h'),
    ('Wang 2021', '3.1', 'worker/survey/survey.h'),
    ('Wang 2021', '3.1, figure 5', f'{HOLE}/hole_types.h'),
    ('Wang 2021', '3.2', f'{HOLE}/layers.h'),
    ('Wang 2021', '3.3, figure 7', f'{SEAM}/seam_layout.h {WANG}/closure_buffers.h'),
    ('Wang 2021', '3.3, figure 8', f'{SEAM}/projected_places.h worker/fill/seam/sample_heights.h'),
    ('Wang 2021', 'eq. 1', f'{WANG}/adjust_patch.h'),
    ('Wang 2021', 'eq. 2 to 4', f'{WANG}/fair_patch.h'),
    ('Wang 2021', 'eq. 5, 6', 'worker/fill/seam/smooth_seam.h'),
    ('Liepa 2003', '3', f'{WANG}/minimum_area.h worker/fill/space/minimum_weight.h'),
    ('Liepa 2003', '4', 'worker/fill/shape/refine_patch.h'),
    ('Sun 2012', 'eq. 1', f'{FRONT}/advancing_front.h'),
    ('Sun 2012', 'eq. 2, 4 to 6', f'{FRONT}/front_rules.h'),
    ('Taubin 1995', 'eq. 3', f'{FRONT}/front_rules.h'),
    ('Zhao 2007', 'Xu 2014, 2.3', f'{FRONT}/poisson_patch.h'),
    ('Xu 2014', '3.1', f'{FRONT}/split_rim.h'),
    ('Xu 2014', '3.2', f'{FRONT}/advancing_front.h {FRONT}/front_sight.h'),
    ('Xu 2014', '3.3; eq. 1, 2, 4', f'{FRONT}/surface_rings.h'),
    ('Xu 2014', 'eq. 3', f'{FRONT}/cotangent_system.h'),
    ('Xu 2014', 'eq. 11, 14, 15', f'{FRONT}/least_squares_svm.h'),
    ('Xu 2014', '3.4; eq. 9 to 15, 18, 19', f'{FRONT}/svm_patch.h'),
    ('repair by curvature', '4', f'{FRONT}/curvature_patch.h'),
    ('Zhang 2022', '3.2', 'coordinator/plan/mesh/mesh_loops.h'),
    ('Zhang 2022', '4.1', f'coordinator/plan/mesh/loop_kinds.h {HOLE}/hole_types.h'),
    ('Pingel 2013', 'SMRF', 'worker/ground/ground_filter.h'))


def sources_list():
    """An item for each paper: sections or equations, and their files."""
    items = {}
    for paper, part, paths in SOURCES:
        files = ', '.join(f'[{path.rsplit("/", 1)[1]}](../{path})' for path in paths.split())
        items.setdefault(paper, []).append(f'{part}: {files}')
    return '\n'.join(f'- **{paper}** ' + '; '.join(parts) for paper, parts in items.items())
