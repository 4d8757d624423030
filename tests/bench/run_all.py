#!/usr/bin/python3
"""Runs all benchmarks and writes their tables into docs/benchmarks.md, each between its two markers.

    run_all.py [--bin DIR] [--runs 5] [--only survey,scene,figure14,peer] [--peer-source cgal_fill.cpp] [--dry-run]

TILEMEND_SHARED_TOOLS names the folder of the scene tools for figure14; --peer-source the driver for the peer. A benchmark without
what it needs is skipped with a message and its table stays as it is. --dry-run prints and writes nothing.
"""
import argparse
import datetime
import json
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import figure14_bench
import measure
import scene_bench

PAGE = os.path.join(measure.ROOT, 'docs', 'benchmarks.md')


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


def figure14(a):
    tools = os.environ.get('TILEMEND_SHARED_TOOLS')
    if not tools:
        return 'TILEMEND_SHARED_TOOLS is not set'
    return figure14_bench.tables(a.bin, tools, [1, 2, 3, 4, 5])


def peer(a):
    if not a.peer_source or not os.path.exists(a.peer_source):
        return f'--peer-source: no such file: {a.peer_source}'
    if not os.path.isdir('/usr/include/CGAL'):
        return 'CGAL is not installed (Debian: libcgal-dev)'
    import peer_bench  # needs numpy
    return peer_bench.tables(a.bin, a.peer_source, a.runs)


BENCHES = {'survey': survey, 'tile': tile, 'scene': scene, 'figure14': figure14, 'peer': peer}


def runs(name, a):
    if name == 'survey':
        return f'{rounds(a)} rounds'
    return 'one run a seed' if name == 'figure14' else f'{a.runs} runs'


def put(page, name, text):
    """The page with `text` between the markers of `name`."""
    begin, end = f'<!-- {name} begin -->', f'<!-- {name} end -->'
    if begin not in page or end not in page:
        raise SystemExit(f'{PAGE}: no markers for {name}')
    return re.sub(re.escape(begin) + '.*?' + re.escape(end), lambda _: f'{begin}\n{text}\n{end}', page, flags=re.DOTALL)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--runs', type=int, default=5)
    parser.add_argument('--only', type=lambda t: t.split(','), default=list(BENCHES))
    parser.add_argument('--peer-source')
    parser.add_argument('--dry-run', action='store_true')
    a = parser.parse_args()
    if set(a.only) - set(BENCHES):
        parser.error(f'--only: some of {",".join(BENCHES)}')
    for name in a.only:
        before = measure.machine()
        text = BENCHES[name](a)
        if not text.startswith('|'):
            print(f'SKIPPED {name}: {text}', file=sys.stderr)
            continue
        load = os.getloadavg()[0]
        note = f'{datetime.date.today()}; {before} at the start, {load:.1f} at the end; {runs(name, a)}.'
        print(f'{name}: {note}\n{text}\n', flush=True)
        if a.dry_run:
            continue
        with open(PAGE, encoding='utf-8') as file:
            page = file.read()
        with open(PAGE, 'w', encoding='utf-8') as file:
            file.write(put(page, name, f'{text}\n\n{note}'))


if __name__ == '__main__':
    main()
