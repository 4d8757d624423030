#!/usr/bin/env python3
"""Builds the script of report.html anew and holds it to web/dist, and uses a page in Chromium.

    report_page_test.py FOLDER BIN

FOLDER gets the packages of web/package-lock.json and keeps them; BIN has tilemend. Exit code 77 (skipped, and says so)
without npm, its registry or Chromium.
"""
import filecmp
import gzip
import json
import os
import shutil
import sys
import tempfile

from npm_packages import WEB, chromium as find_chromium, fail, install, run, skip

HERE = os.path.dirname(os.path.abspath(__file__))
SIDE = 12  # squares of a tile


def copy_sources(folder):
    shutil.copytree(os.path.join(WEB, 'src'), os.path.join(folder, 'src'), dirs_exist_ok=True)
    for name in ('tsconfig.json', 'build.mjs'):
        shutil.copy(os.path.join(WEB, name), folder)


def check_bundle(folder):
    """web/dist is what the sources give."""
    types = run('node', 'node_modules/typescript/bin/tsc', '--noEmit', '-p', '.', cwd=folder)
    if types.returncode:
        fail(types.stdout)
    built = run('node', 'build.mjs', 'built', cwd=folder)
    if built.returncode:
        fail(built.stdout)
    for name in ('report.js', 'report.css', 'console.js', 'console.css', 'draco_decoder.js'):
        if not filecmp.cmp(os.path.join(folder, 'built', name), os.path.join(WEB, 'dist', name), shallow=False):
            fail(f'web/dist/{name} is not what web/src gives: run `npm ci && npm run build` in web')
    size = sum(len(gzip.compress(open(os.path.join(WEB, 'dist', name), 'rb').read(), 9))
               for name in ('console.js', 'console.css', 'draco_decoder.js'))
    if size > 400_000:
        fail(f'the page of the coordinator has {size} bytes compressed, more than 400,000')


def tile(column):
    """A tile of a slope: a lake over the border of both, and a square of its own that is missing."""
    points, faces = [], []
    for y in range(SIDE + 1):
        for x in range(column * SIDE, (column + 1) * SIDE + 1):
            points.append(f'v {x} {y} {0.2 * x + 0.1 * y}')
    for y in range(SIDE):
        for x in range(SIDE):
            if column == 0 and 5 <= x < 8 and 5 <= y < 8 or column == 1 and (x, y) in ((5, 8), (6, 8)):
                continue
            a = y * (SIDE + 1) + x + 1
            faces += [f'f {a} {a + 1} {a + SIDE + 2}', f'f {a} {a + SIDE + 2} {a + SIDE + 1}']
    return '\n'.join(points + faces) + '\n'


def review_item(hole):
    """A row of the review queue; holes as small as these are not judged."""
    return {'hole': hole['id'], 'holes': [hole['id']], 'cell': hole['cell'], 'centre': [0, 0], 'area_m2': 9,
            'taken_for': 'ground', 'reason': '<b>markup</b>', 'doubt_m': 0.5, 'doubt_m3': 4.5}


def check_decisions(program, folder, path):
    """What was marked in the page is what the next run does."""
    with open(path) as file:
        marks = {f['properties']['hole']: f['properties'] for f in json.load(file)['features']}
    if sorted((m['decision'], m['level_m']) for m in marks.values()) != [('open', None), ('water', 1.25)]:
        fail(f'the page wrote {marks}')
    scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
    done = run(program, 'run', scene, '--out', out, '--decisions', path)
    if done.returncode != 0:  # what a decision leaves open is no failure
        fail(f'exit code {done.returncode}: {done.stdout}')
    with open(os.path.join(out, 'report.json')) as file:
        found = {row['id']: row for row in json.load(file)['per_hole']}
    for hole, mark in marks.items():
        row = found[hole]
        if row['decision'] != mark['decision'] or row.get('level_m') != mark['level_m']:
            fail(f'{mark} gave {row}')


def check_second_round(program, folder, chromium, temporary):
    """A file of a second round has the decisions of the first, so that a run with it does not undo them."""
    out = os.path.join(temporary, 'out')
    path = os.path.join(out, 'report.json')
    with open(path) as file:
        report = json.load(file)
    first = {row['id']: row for row in report['per_hole']}
    again = next(row for row in report['per_hole'] if row['decision'] == 'open')
    report['review'] = [review_item(again)]
    with open(path, 'w') as file:
        json.dump(report, file)
    shutil.copy(os.path.join(HERE, 'mark_fill.mjs'), folder)
    marks = os.path.join(folder, 'second.geojson')
    for command in ((program, 'report', out, '--html'), ('node', 'mark_fill.mjs', os.path.join(out, 'report.html'), chromium, marks),
                    (program, 'run', os.path.join(temporary, 'scene'), '--out', out, '--decisions', marks)):
        done = run(*command, cwd=folder)
        if done.returncode:
            fail(done.stdout)
    with open(path) as file:
        second = {row['id']: row for row in json.load(file)['per_hole']}
    if second[again['id']]['decision'] != 'accept':
        fail(f"the mark of the second round gave {second[again['id']]}")
    kept = [row for row in first.values() if row['id'] != again['id']]
    if not kept or any((second[r['id']]['decision'], second[r['id']].get('level_m')) != (r['decision'], r.get('level_m')) for r in kept):
        fail(f'the second round changed what the first decided: {first}, {second}')


def page_without_outline(program, out, hole):
    """The page as it is if holes.geojson has no outline of the hole."""
    path = os.path.join(out, 'holes.geojson')
    with open(path) as file:
        whole = file.read()
    cut = json.loads(whole)
    cut['features'] = [f for f in cut['features'] if f['properties'].get('hole') != hole]
    with open(path, 'w') as file:
        json.dump(cut, file)
    done = run(program, 'report', out, '--html')
    if done.returncode:
        fail(done.stdout)
    with open(path, 'w') as file:
        file.write(whole)


def check_other_fill(program, folder, chromium, temporary):
    """A hole with a fill that is not in the queue is decided on from the table of holes, where its crossings are. A hole
    without an outline is not."""
    scene, out = os.path.join(temporary, 'scene'), os.path.join(temporary, 'other')
    done = run(program, 'run', scene, '--out', out)
    if done.returncode:
        fail(done.stdout)
    path = os.path.join(out, 'report.json')
    with open(path) as file:
        report = json.load(file)
    row = report['per_hole'][-1]
    row |= {'crossings': 5, 'doubt_m3': 0.04,
            'water': {'taken_for': 'lake', 'level_m': 1.25, 'sigma_m': 0.125, 'reason': 'its rim is level'}}
    other = report['per_hole'][0]['id']  # all are closed, and so in no cluster
    report['review'] = []
    with open(path, 'w') as file:
        json.dump(report, file)
    page_without_outline(program, out, other)
    shutil.copy(os.path.join(HERE, 'decide_hole.mjs'), folder)
    marks = os.path.join(folder, 'other.geojson')
    for command in (('node', 'decide_hole.mjs', os.path.join(out, 'report.html'), chromium, marks, str(row['id']), str(other)),
                    (program, 'run', scene, '--out', out, '--decisions', marks)):
        done = run(*command, cwd=folder)
        if done.returncode:
            fail(done.stdout)
    with open(marks) as file:
        if json.load(file)['tilemend_scene']['name'] != 'scene':
            fail('the file of the page does not say which scene it is of')
    with open(path) as file:
        decided = {r['id']: r['decision'] for r in json.load(file)['per_hole'] if 'decision' in r}
    if decided != {row['id']: 'open'}:
        fail(f"the mark on hole {row['id']} gave {decided}")


def check_not_judged(program, folder, chromium, temporary):
    """A hole that was not judged is ground in the queue, as its method says, and is not the method."""
    scene, out = os.path.join(temporary, 'scene'), os.path.join(temporary, 'not_judged')
    path = os.path.join(out, 'report.json')
    done = run(program, 'run', scene, '--out', out)
    if done.returncode:
        fail(done.stdout)
    with open(path) as file:
        report = json.load(file)
    row = report['per_hole'][0]
    row.pop('water', None)
    row['method'] = 'over the ground, folds cut off'
    report['review'] = []
    with open(path, 'w') as file:
        json.dump(report, file)
    shutil.copy(os.path.join(HERE, 'add_row.mjs'), folder)
    for command in ((program, 'report', out, '--html'),
                    ('node', 'add_row.mjs', os.path.join(out, 'report.html'), chromium, str(row['id']), 'ground')):
        done = run(*command, cwd=folder)
        if done.returncode:
            fail(done.stdout)


def make_page(folder, program):
    """The page of an output whose report has texts with markup in it."""
    scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
    os.makedirs(scene)
    tiles = []
    for column in (0, 1):
        with open(os.path.join(scene, f't{column}.obj'), 'w') as file:
            file.write(tile(column))
        tiles.append({'col': column, 'row': 0, 'path': f't{column}.obj'})
    with open(os.path.join(scene, 'scene.json'), 'w') as file:
        json.dump({'cell_size': SIDE, 'cols': 2, 'rows': 1, 'tiles': tiles}, file)
    done = run(program, 'run', scene, '--out', out)
    if done.returncode:
        fail(done.stdout)
    path = os.path.join(out, 'report.json')
    with open(path) as file:
        report = json.load(file)
    report['warnings'] = ['<img src=x onerror=alert(1)>', '</script><script>alert(2)</script>']
    report['per_hole'][0]['reason'] = '"><svg onload=alert(3)>'
    report['review'] = [review_item(row) for row in report['per_hole']]
    report['water'] = [{'body': 0, 'kind': 'lake', 'level_m': 1, 'sigma_m': 0.1, 'area_m2': area, 'cells': 1,
                        'decided_by': 'rim'} for area in (12.34, 0.00001, 0)]
    with open(path, 'w') as file:
        json.dump(report, file)
    done = run(program, 'report', out, '--html')
    if done.returncode:
        fail(done.stdout)
    return os.path.join(out, 'report.html')


def check_printed(chromium, page, folder):
    """A browser without a window prints the page as soon as it is loaded: both pictures are there, before and after."""
    path = os.path.join(folder, 'printed.pdf')
    done = run(chromium, '--headless', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
               '--enable-unsafe-swiftshader', f'--user-data-dir={os.path.join(folder, "profile")}',
               f'--print-to-pdf={path}', f'file://{page}')
    if done.returncode or not os.path.exists(path):
        fail(f'the page was not printed: {done.stdout}')
    with open(path, 'rb') as file:
        images = file.read().count(b'/Width 1120')  # and each has a mask
    if images < 4:
        fail(f'a PDF that was printed at once has {images} images, not 4')


def main():
    folder, program = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[2]), 'tilemend')
    install(folder)
    copy_sources(folder)
    check_bundle(folder)
    chromium = find_chromium()
    if not chromium:
        skip('there is no Chromium; web/dist is what the sources give')
    with tempfile.TemporaryDirectory() as temporary:
        page = make_page(temporary, program)
        size = os.path.getsize(page)
        if size > 1_200_000:
            fail(f'a page with two small pictures has {size} bytes')
        check_printed(chromium, page, temporary)
        shutil.copy(os.path.join(HERE, 'open_page.mjs'), folder)
        done = run('node', 'open_page.mjs', page, chromium, folder, cwd=folder)
        if done.returncode:
            fail(done.stdout)
        check_decisions(program, temporary, os.path.join(folder, 'decisions.geojson'))
        check_second_round(program, folder, chromium, temporary)
        check_other_fill(program, folder, chromium, temporary)
        check_not_judged(program, folder, chromium, temporary)
    print('the page works')


if __name__ == '__main__':
    main()
