#!/usr/bin/python3
"""Repeats the experiments of the papers behind tilemend and writes docs/papers.md: our figures beside the printed ones.

    TILEMEND_SHARED_TOOLS=DIR reproduce.py [--quick] [--bin DIR] [--only tables,efficiency,sun] [--peer-source cgal_fill.cpp] [--work DIR]
                                           [--spacings 2.5,1,0.5] [--areas 8,16,24,32] [--large-spacing 0.5] [--page FILE]

DIR holds the scene tools, which are not part of this project; without it what needs them is left out, and the page says so. The
papers' own models and photographs cannot be had: made ones stand in, as the page says of each. --peer-source names the driver of the
peer, which is no part either. Every measurement is kept below --work by the program it was made with: a run that was interrupted goes on
where it was. Parts that are not run keep what the page has of them. --quick takes the small ones of everything, about ten minutes, and writes
its page below --work; the whole takes hours, 12 GB of disk and 4 GB of memory. Needs numpy, scipy and matplotlib.
"""
import argparse
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import filler_bench
import measure
import papers_fillers
import papers_plots
import papers_wang
import scene_tools
import steps

# Name -> title, what makes the text in a folder, whether it needs the scene tools.
PARTS = {'tables': ('Wang 2021, tables 1 to 5: holes by type', papers_wang.part_tables, True),
         'efficiency': ('Wang 2021, tables 6 and 7: time and memory', papers_wang.part_efficiency, True),
         'large': ('Wang 2021, tables 6 and 7: 28 km²', papers_wang.part_large, True),
         'accuracy': ('Wang 2021, figures 14 to 17: accuracy', papers_wang.part_accuracy, True),
         'surface': ('The true `wang` beside what it was and `thin-plate`', papers_wang.part_surface, True),
         'sun': ('Sun 2012, table 1 and figure 6', papers_fillers.part_sun, False),
         'xu': ('Xu 2014, tables 1 and 2', papers_fillers.part_xu, False),
         'zhang': ('Zhang 2022, table 2: kinds of holes', papers_fillers.part_zhang, False),
         'fillers': ('All fillers on the same holes', papers_fillers.part_fillers, False)}
HEAD = ('# The papers\' experiments again\n\n`scripts/reproduce.sh` runs them and writes this page, with the scene tools in `TILEMEND_SHARED_TOOLS`; '
        'it goes on where it was interrupted, and `--quick` takes the small ones. A program is named by the start of its SHA-256. '
        '[Wang](decisions/2026-11-22-wang-as-printed.md) and [the fillers](decisions/2026-11-22-published-fillers.md) say what was chosen where the papers say nothing.\n')


def kept(page):
    """The sections that a page has, by name."""
    if not os.path.exists(page):
        return {}
    with open(page, encoding='utf-8') as file:
        return {m[1]: m[2].strip() for m in re.finditer(r'<!-- (\w+) -->\n(.*?)(?=<!-- \w+ -->|\Z)', file.read(), re.DOTALL)}


def numbers(kind):
    return lambda text: [kind(n) for n in filler_bench.words(text)]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--quick', action='store_true')
    parser.add_argument('--bin', default=measure.BIN)
    parser.add_argument('--only', type=filler_bench.words, default=list(PARTS))
    parser.add_argument('--work', default=os.path.join(measure.ROOT, 'build', 'papers'))
    parser.add_argument('--peer-source', default='')
    parser.add_argument('--spacings', type=numbers(float))
    parser.add_argument('--areas', type=numbers(int))
    parser.add_argument('--large-spacing', type=float, default=.5)
    parser.add_argument('--page')
    a = parser.parse_args()
    unknown = [name for name in a.only if name not in PARTS]
    if unknown:
        parser.error(f'--only: {", ".join(unknown)}: no such part; expected some of {", ".join(PARTS)}')
    if not os.access(os.path.join(a.bin, 'tilemend'), os.X_OK):
        parser.error(f'{a.bin}: no tilemend there; build it, or name its folder with --bin')
    a.spacings = a.spacings or ([2.5, 1] if a.quick else [2.5, 1, .5])
    a.areas = a.areas or ([8, 16] if a.quick else list(papers_wang.AREAS))
    a.page = a.page or (os.path.join(a.work, 'quick.md') if a.quick else os.path.join(measure.ROOT, 'docs', 'papers.md'))
    a.steps = steps.Steps(os.path.join(a.work, 'quick') if a.quick else a.work, os.path.join(a.bin, 'tilemend'))
    return a


def main():
    a = arguments()
    papers_plots.images = os.path.join(os.path.dirname(a.page), 'images')
    sections = kept(a.page)
    for name in a.only:
        title, part, needs_tools = PARTS[name]
        if needs_tools and not scene_tools.folder():
            print(f'SKIPPED {name}: set TILEMEND_SHARED_TOOLS to the folder of the scene tools', file=sys.stderr)
            continue
        print(name, file=sys.stderr)
        folder = os.path.join(a.steps.folder, 'scenes', name)  # stays where a run is interrupted: scenes that are whole are used again
        os.makedirs(folder, exist_ok=True)
        text = part(a, folder)
        shutil.rmtree(folder)
        if text is None:
            continue
        sections[name] = f'## {title}\n\n{text}\n\nMeasured on: {measure.machine()}; program {os.path.basename(a.steps.folder)}.'
        with open(a.page, 'w', encoding='utf-8') as file:
            file.write(HEAD + '\n' + '\n\n'.join(f'<!-- {n} -->\n{sections[n]}' for n in PARTS if n in sections) + '\n')
        print(f'{name}: written to {a.page}', file=sys.stderr)


if __name__ == '__main__':
    try:
        main()
    except KeyboardInterrupt:
        sys.exit('stopped; the same command goes on from here')
