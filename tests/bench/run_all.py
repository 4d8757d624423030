#!/usr/bin/python3
"""Runs all benchmarks. Writes full tables to a folder, and summaries into docs/benchmarks.md, each between its two markers.

    run_all.py [--bin DIR] [--runs 5] [--only survey,scene,partition,...] [--peers DIR] [--build DIR] [--tables DIR] [--dry-run]

Full tables go to --tables (build/benchmarks), one file each. The page has summaries (summaries.py) of some.
TILEMEND_SHARED_TOOLS names the folder of the scene tools for partition, surface, street, map and figure14; --peers that of the peer's
drivers and of hole_bench.py's meshes, for peer and hole; figure14 prints the peer beside the rest when it is there. A benchmark
without what it needs is skipped with a message and its summary stays as it is. --dry-run prints, and writes no file but pictures.
"""
import argparse
import datetime
import importlib.util
import json
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hole_bench
import measure
import scene_bench
import summaries

PAGE = os.path.join(measure.ROOT, 'docs', 'benchmarks.md')
TABLES = os.path.join(measure.ROOT, 'build', 'benchmarks')


def rounds(a):
    return 4 * a.runs + 1


def survey(a):
    rows = []
    for name, flags in (('in rows', []), ('shuffled', ['--shuffle'])):
        text = subprocess.run([os.path.join(a.bin, 'survey_bench'), '--json', '--rounds', str(rounds(a)), *flags],
                              check=True, capture_output=True, text=True).stdout
        r = json.loads(text)
        for what, label in (('survey, reading included', 'survey'), ('sorting, reading included', 'sorting all edges')):
            rows.append([f'{label}, triangles {name}', f"{r['triangles']:,}",
                         *(measure.up(r[what][k], 3) for k in ('cpu', 'best', 'median', 'first'))])
        ratios = [r['sorting, reading included'][k] / r['survey, reading included'][k] for k in ('cpu', 'best', 'median', 'first')]
        rows.append(['ratio', '', *(measure.down(x, 1) for x in ratios)])
    return measure.table(['', 'triangles', 'least CPU, s', 'best, s', 'median, s', 'first round, s'], rows)


def scene(a):
    return scene_bench.tables(a.bin, [6, 24, 96, 384], [1, 2, 4], a.runs)


def tile(a):
    return scene_bench.big_tile(a.bin, a.runs)


def absent(*modules):
    """Which of the modules Python lacks, as a message, or None."""
    names = [m for m in modules if not importlib.util.find_spec(m)]
    return f'{sys.executable} has no module {" and ".join(names)}' if names else None


def missing(*modules):
    """Why scenes with known truth cannot be made and judged, or None."""
    if not os.environ.get('TILEMEND_SHARED_TOOLS'):
        return 'TILEMEND_SHARED_TOOLS is not set'
    return absent('numpy', 'scipy', *modules)


def with_truth(bench, *modules):
    """The benchmark, or where there are no scenes for it, why."""
    return lambda a: missing(*modules) or bench(a)


def peer_source(a):
    return os.path.join(a.peers, 'cgal_fill.cpp') if a.peers else None


def partition(a):
    import partition_bench
    return partition_bench.tables(a.bin, [1, 2])


def surface(a):
    import surface_bench
    return surface_bench.tables(a.bin, [1, 2, 3])


def street(a):
    import street_bench
    return street_bench.tables(a.bin, [91, 92, 93, 94, 95, 96])


def error_map(a):
    import plots
    return plots.error_map(a.bin, a.tables)


def figure14(a):
    import figure14_bench
    import peer as driver
    without = driver.missing(peer_source(a))
    if without:
        print(f'figure14: without the peer: {without}', file=sys.stderr)
    return figure14_bench.tables(a.bin, [1, 2, 3, 4, 5], None if without else peer_source(a))


def peer(a):
    import peer as driver
    reason = absent('numpy', 'scipy') or driver.missing(peer_source(a))
    if reason:
        return reason
    import peer_bench
    return peer_bench.tables(a.bin, peer_source(a), a.runs)


def hole(a):
    if not a.peers:
        return '--peers is not given'
    return hole_bench.missing(a.peers) or hole_bench.tables(a.bin, a.peers, a.build, a.runs)


def growth(table):
    """The picture of a table that is on the page."""
    reason = absent('numpy', 'matplotlib')
    if reason:
        print(f'SKIPPED growth.png: {reason}', file=sys.stderr)
        return
    import plots
    plots.growth(table)


BENCHES = {'survey': survey, 'tile': tile, 'scene': scene, 'partition': with_truth(partition),
           'surface': with_truth(surface), 'street': with_truth(street), 'map': with_truth(error_map, 'matplotlib'), 'figure14': with_truth(figure14),
           'peer': peer, 'hole': hole}
PICTURES = {'hole': growth}
ROUNDS = {'partition': 'one run a row', 'surface': 'one run a row', 'street': 'one run a row', 'map': 'one run', 'figure14': 'one run a row'}


def runs(name, a):
    if name == 'survey':
        return f'{rounds(a)} rounds'
    return ROUNDS.get(name, f'{a.runs} runs')


def put(page, name, text):
    """The page with `text` between the markers of `name`."""
    begin, end = f'<!--{name}-begin-->', f'<!--{name}-end-->'
    if begin not in page or end not in page:
        raise SystemExit(f'{PAGE}: no markers for {name}')
    return re.sub(re.escape(begin) + '.*?' + re.escape(end), lambda _: f'{begin}\n{text}\n{end}', page, flags=re.DOTALL)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--runs', type=int, default=5)
    parser.add_argument('--only', type=lambda t: t.split(','), default=list(BENCHES))
    parser.add_argument('--peers')
    parser.add_argument('--build', default=hole_bench.BUILD)
    parser.add_argument('--tables', default=TABLES)
    parser.add_argument('--dry-run', action='store_true')
    a = parser.parse_args()
    if set(a.only) - set(BENCHES):
        parser.error(f'--only: some of {",".join(BENCHES)}')
    return a


def write(path, text):
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


def main():
    a = arguments()
    os.makedirs(a.tables, exist_ok=True)
    for name in a.only:
        before = measure.machine()
        text = BENCHES[name](a)
        if not text.startswith('|'):
            print(f'SKIPPED {name}: {text}', file=sys.stderr)
            continue
        note = f'{datetime.date.today()}; {before} to {os.getloadavg()[0]:.1f}; {runs(name, a)}.'
        print(f'{name}: {note}\n{text}\n', flush=True)
        if a.dry_run:
            continue
        write(os.path.join(a.tables, f'{name}.md'), f'{text}\n\n{note}\n')
        if name in PICTURES:
            PICTURES[name](text)
        if name in summaries.SHORT:
            with open(PAGE, encoding='utf-8') as file:
                page = file.read()
            write(PAGE, put(page, name, f'{summaries.SHORT[name](text)}\n\n{note}'))


if __name__ == '__main__':
    main()
