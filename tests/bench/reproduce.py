#!/usr/bin/python3
"""Repeats the experiments of the papers behind tilemend and writes docs/papers.md: our figures beside the printed ones.

The page has short tables (papers_short.py). Full tables and pictures go to the measurements of the program, below --work.

TILEMEND_SHARED_TOOLS names the folder of the scene tools, which are not part of this project; parts that need them are left out where
it is not set, and keep what the page has. The papers' own models and photographs cannot be had: made ones stand in, as the page says of
each. Every measurement is kept below --work by the program it was made with: a run that was interrupted goes on where it was. Parts that
are not run keep what the page has of them, and name the program they were measured with.
"""
import argparse
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import filler_bench
import measure
import papers_accuracy
import papers_fillers
import papers_plots
import papers_short
import papers_wang
import scene_tools
import steps

# Name -> title, what makes the text in a folder, whether it needs the scene tools.
PARTS = {'tables': ('Wang 2021, tables 1 to 5: holes by type', papers_wang.part_tables, True),
         'efficiency': ('Wang 2021, tables 6 and 7: time and memory', papers_wang.part_efficiency, True),
         'large': ('Wang 2021, tables 6 and 7: 28 km²', papers_wang.part_large, True),
         'accuracy': ('Wang 2021, figures 14 to 17: accuracy', papers_accuracy.part_accuracy, True),
         'surface': ('`wang` beside `thin-plate`', papers_wang.part_surface, True),
         'sun': ('Sun 2012, table 1 and figure 6', papers_fillers.part_sun, False),
         'xu': ('Xu 2014, tables 1 and 2', papers_fillers.part_xu, False),
         'curvature': ('The repair by curvature', papers_fillers.part_curvature, False),
         'zhang': ('Zhang 2022, table 2: kinds of holes', papers_fillers.part_zhang, False),
         'fillers': ('All fillers on the same holes', papers_fillers.part_fillers, False)}
HEAD = ('# The papers\' experiments again\n\nExperiments of the papers on made stand-ins for their data; `scripts/reproduce.sh` measures and writes this page. '
        '[Choices where the papers say nothing](decisions/2026-11-22-published-fillers.md).\n\n')
EQUATIONS = '## Equations in the code\n\n'
VERDICTS = '\n\n## Experiments\n\nWhat is printed, the stand-in, the verdict, what is found here:\n\n'
EPILOGUE = ('Examples:\n'
            '  scripts/reproduce.sh                        everything, an hour or more, 12 GB of disk and 4 GB of memory\n'
            '  scripts/reproduce.sh --quick                the small ones of everything, 10 to 20 minutes; the page is WORK/quick.md\n'
            '  scripts/reproduce.sh --only sun,xu          these parts; the others stay as the page has them\n'
            '  scripts/reproduce.sh --carry ID --again xu  measured again where the name has "xu"; else taken from the program ID\n\n'
            'Needs a build (scripts/install.sh), and Debian\'s python3-numpy, python3-scipy and python3-matplotlib.\n'
            'Exit codes: 0 the page is written, 1 a program failed, 2 usage.')


def page_text(sections):
    """`sections`: name -> lines of the table of verdicts (measure.verdict), text."""
    present = [(name, *sections[name]) for name in PARTS if name in sections]
    texts, stamp = with_one_stamp([text for _, _, text in present])
    present = [(name, lines, text) for (name, lines, _), text in zip(present, texts)]
    rows = [item(line, anchor(text)) for _, lines, text in present for line in lines.splitlines()]
    return HEAD + (f'Measured on {stamp}.\n\n' if stamp else '') + EQUATIONS + papers_short.sources_list() + VERDICTS + '\n'.join(rows) + '\n\n' + '\n\n'.join(f'<!--{name}-->\n{text}' for name, _, text in present) + '\n'


STAMP = re.compile(r'\n\n([^\n]*), load ([^\n;]*)(; program [^\n]*)\.\Z')  # machine, load, program: the end of a section


def with_one_stamp(texts):
    """The sections without their stamps, and one stamp for all; unchanged, and none, if more than the load differs."""
    stamps = [STAMP.search(text) for text in texts]
    if not all(stamps) or len({(s[1], s[3]) for s in stamps}) != 1:
        return texts, ''
    loads = sorted((load for s in stamps for load in s[2].split(' to ')), key=float)
    load = loads[0] if loads[0] == loads[-1] else f'{loads[0]} to {loads[-1]}'
    return [STAMP.sub('', text) for text in texts], f'{stamps[0][1]}, load {load}{stamps[0][3]}'


def anchor(section):
    """As Markdown makes it from the section's title."""
    title = section.split('\n', 1)[0].lstrip('# ').lower()
    return re.sub(r'[^\w\- ]|²', '', title).replace(' ', '-')


def item(line, target):
    printed, stand_in, outcome, ours = line.split(' | ')
    return f'- [{printed}](#{target}) ({stand_in}): **{outcome}**; {ours}'.rstrip('; ')


def kept(page):
    """The sections that a page has, as page_text takes them."""
    if not os.path.exists(page):
        return {}
    with open(page, encoding='utf-8') as file:
        text = file.read()
    rows = re.findall(r'^- \[(.*?)\]\(#([^)]*)\) \((.*)\): \*\*(.*?)\*\*(?:; (.*))?$', text, re.MULTILINE)
    sections = {m[1]: m[2].strip() for m in re.finditer(r'<!--(\w+)-->\n(.*?)(?=<!--\w+-->\n|\Z)', text, re.DOTALL)}
    if stamp := re.search(r'^Measured on (.*)\.$', text, re.MULTILINE):
        sections = {name: f'{section}\n\n{stamp[1]}.' for name, section in sections.items()}
    return {name: (''.join(f'{printed} | {" | ".join(rest)}\n' for printed, target, *rest in rows if target == anchor(section)), section) for name, section in sections.items()}


def numbers(kind):
    return lambda text: [kind(n) for n in filler_bench.words(text)]


def arguments():
    parser = argparse.ArgumentParser(prog='scripts/reproduce.sh', description=__doc__, epilog=EPILOGUE, formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add('--only', type=filler_bench.words, default=list(PARTS), metavar='PART,...',
        help='the parts to run: ' + '; '.join(f'{name} ({title})' for name, (title, _, _) in PARTS.items()).replace('`', '') + ' (default: all)')
    add('--quick', action='store_true', help='fewer and smaller scenes; the page is not docs/papers.md but WORK/quick.md')
    add('--bin', default=measure.BIN, metavar='DIR', help='folder of the program (default: build/release/bin)')
    add('--work', default=os.path.join(measure.ROOT, 'build', 'papers'), metavar='DIR', help='where measurements and scenes are kept (default: build/papers)')
    add('--page', metavar='FILE', help='page to write (default: docs/papers.md)')
    add('--peer-source', default='', metavar='FILE', help='driver of CGAL, cgal_fill.cpp, which is not part of this project (default: none, CGAL is left out)')
    add('--spacings', type=numbers(float), metavar='M,...', help='of efficiency: metres between vertices (default: 2.5,1,0.5; quick: 2.5,1)')
    add('--areas', type=numbers(int), metavar='CELLS,...', help=f'of efficiency: cells, some of {", ".join(map(str, papers_wang.AREAS))} (default: all; quick: 8,16)')
    add('--large-spacing', type=float, default=.5, metavar='M', help='of large: metres between vertices (default: 0.5)')
    add('--carry', default='', metavar='ID', help='take what is not measured yet from the measurements of that program below WORK; the page says so (default: measure it)')
    add('--again', default='', metavar='REGEX', help='of --carry: measure again what has such a name (default: nothing)')
    a = parser.parse_args()
    unknown = [name for name in a.only if name not in PARTS]
    if unknown:
        parser.error(f'--only: {", ".join(unknown)}: no such part; expected some of {", ".join(PARTS)}')
    if not os.access(os.path.join(a.bin, 'tilemend'), os.X_OK):
        parser.error(f'{a.bin}: no tilemend there; build it, or name its folder with --bin')
    a.spacings = a.spacings or ([2.5, 1] if a.quick else [2.5, 1, .5])
    a.areas = a.areas or ([8, 16] if a.quick else list(papers_wang.AREAS))
    a.page = a.page or (os.path.join(a.work, 'quick.md') if a.quick else os.path.join(measure.ROOT, 'docs', 'papers.md'))
    work = os.path.join(a.work, 'quick') if a.quick else a.work
    if a.carry and not os.path.isdir(os.path.join(work, a.carry)):
        parser.error(f'--carry {a.carry}: no measurements of that program in {work}')
    a.steps = steps.Steps(work, os.path.join(a.bin, 'tilemend'), a.carry, a.again)
    return a


def main():
    a = arguments()
    papers_plots.images = os.path.join(a.steps.folder, 'images')
    sections = kept(a.page)
    for name in a.only:
        title, part, needs_tools = PARTS[name]
        if needs_tools and not scene_tools.folder():
            print(f'SKIPPED {name}: set TILEMEND_SHARED_TOOLS to the folder of the scene tools', file=sys.stderr)
            continue
        print(name, file=sys.stderr)
        folder = os.path.join(a.steps.folder, 'scenes', name)  # stays where a run is interrupted: scenes that are whole are used again
        os.makedirs(folder, exist_ok=True)
        found = part(a, folder)
        shutil.rmtree(folder)
        if found is None:
            continue
        verdicts, text = found
        sections[name] = (verdicts, f'## {title}\n\n{text}\n\n{a.steps.told(measure.machine())}.')
        with open(a.page, 'w', encoding='utf-8') as file:
            file.write(page_text(sections))
        print(f'{name}: written to {a.page}', file=sys.stderr)


if __name__ == '__main__':
    try:
        main()
    except KeyboardInterrupt:
        sys.exit('stopped; the same command goes on from here')
