"""The short tables of docs/benchmarks.md, made of the full tables of the benchmarks. Needs Python's own library only.

A summary never chooses the better figure: of several rows it gives the least and the largest one, the worst one, or all.
"""
import measure


def cells_of(table):
    """The cells of a Markdown table, its heads first, and the text below it."""
    lines = table.split('\n')
    end = next((k for k, line in enumerate(lines) if not line.startswith('|')), len(lines))
    rows = [[cell.strip() for cell in line.strip('|').split('|')] for line in lines[:end]]
    return [rows[0], *rows[2:]], '\n'.join(lines[end:]).strip()


def number(cell):
    return float(cell.replace(',', '').replace('%', ''))


def smallest(rows, column):
    return min((row[column] for row in rows), key=number)


def largest(rows, column):
    return max((row[column] for row in rows), key=number)


def span(rows, column):
    low, high = smallest(rows, column), largest(rows, column)
    return low if low == high else f'{low} to {high}'


def average(rows, column):
    """Of rounded cells; rounded up, to two places."""
    return measure.up(sum(number(row[column]) for row in rows) / len(rows), 2)


def grouped(rows, key):
    groups = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups


def survey(table):
    (_, *rows), _ = cells_of(table)
    short = []
    for own, sorting, ratio in zip(rows[::3], rows[1::3], rows[2::3]):
        short.append([own[0].removeprefix('survey, triangles '), own[1], f'{own[3]} ({own[4]})', f'{sorting[3]} ({sorting[4]})', ratio[3]])
    return measure.table(['order', 'triangles', 'survey, s', 'sorting, s', 'ratio'], short)


def scene(table):
    (_, *rows), _ = cells_of(table)
    short = []
    for cells, of_scene in grouped(rows, lambda row: row[0]).items():
        shown = [row for row in of_scene if row[3] in ('1', '2')]
        times = [f'{row[4]} ({row[5]})' for row in shown]
        short.append([cells, of_scene[0][1], of_scene[0][2], *times, largest(shown, 6), largest(shown, 7)])
    return measure.table(['cells', 'triangles', 'holes filled', '1 worker, s', '2 workers, s', 'CPU, s', 'peak, MB'], short)


def partition(table):
    (_, *rows), _ = cells_of(table)
    short = [[f'{name} ({len(of)})', largest(of, 7), largest(of, 8), span(of, 11)] for name, of in grouped(rows, lambda row: row[0].rsplit(', ', 1)[0]).items()]
    return measure.table(['scenes', 'apart', 'worst hole', 'error cut / whole'], short)


def street(table):
    (_, *rows), _ = cells_of(table)
    short = [[level, len(of), largest(of, 4), largest([row for row in of if row[6] != '-'], 6), largest(of, 7), span(of, 8), average(of, 8), span(of, 9), average(of, 9),
              span(of, 10), span(of, 11), span(of, 12)] for level, of in grouped(rows, lambda row: row[0]).items()]
    heads = ['level', 'cuts', 'no surface', 'step, m', 'two fills', 'error mean, m', 'its average', 'error 95 %, m', 'its average', 'open edges', 'crossings',
             'new triangles']
    return measure.table(heads, short)


def surface(table):
    """Of thin-plate alone; the errors of both surfaces are in docs/papers.md."""
    (_, *rows), _ = cells_of(table)
    short = [[f'{name} ({len(of)})', largest(of, 8), largest(of, 10), sum(row[12] != 'all kept' for row in of)] for name, of in grouped(rows, lambda row: row[0].rsplit(', ', 2)[0]).items()]
    return measure.table(['scenes', 'border / inside', 'rim / input', 'promises broken'], short)


def hole(table):
    """Memory and error are the larger one of both runs, with --uniform and without."""
    (_, *rows), below = cells_of(table)
    short = []
    for name, of in grouped(rows, lambda row: row[0].removesuffix(' --uniform')).items():
        plain, uniform = (next(row for row in of if row[0].endswith('--uniform') == asked) for asked in (False, True))
        short.append([name, plain[3], uniform[3], plain[4], largest(of, 8), plain[9], largest(of, 11), plain[12]])
    heads = ['', 's', '`--uniform`, s', 'CGAL, s', 'MB', 'CGAL, MB', 'error, m', 'CGAL, m']
    return f'{measure.table(heads, short)}\n\nCrossings: {largest(rows, 17)}. Faces lost: {largest(rows, 18)}. {below}'


SHORT = {f.__name__: f for f in (survey, scene, partition, street, surface, hole)}  # of the benchmarks that the page shows
