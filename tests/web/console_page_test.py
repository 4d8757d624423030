#!/usr/bin/env python3
"""Starts a coordinator with its page, three jobs and a worker, and uses the page in Chromium.

    console_page_test.py FOLDER BIN

FOLDER is that of report_page_test.py, which installs the packages. BIN has the programs. Exit code 77 (skipped, and says
so) without npm, its registry or Chromium.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

from console_cluster import Cluster
from report_page_test import HERE, SIDE, fail, install, skip

LARGE = 100  # cells along a side
WIDE = 500, 200


def tile(column, row):
    """A tile of a slope with a lake in every second cell."""
    points, faces = [], []
    for y in range(row * SIDE, (row + 1) * SIDE + 1):
        for x in range(column * SIDE, (column + 1) * SIDE + 1):
            points.append(f'v {x} {y} {0.2 * x + 0.1 * y}')
    for y in range(SIDE):
        for x in range(SIDE):
            if (column + row) % 2 == 0 and 4 <= x < 8 and 5 <= y < 8 or column % 3 == 1 and (x, y) in ((2, 2), (3, 2)):
                continue
            a = y * (SIDE + 1) + x + 1
            faces += [f'f {a} {a + 1} {a + SIDE + 2}', f'f {a} {a + SIDE + 2} {a + SIDE + 1}']
    return '\n'.join(points + faces) + '\n'


def make_scene(folder, columns, rows, text_of):
    os.makedirs(folder)
    tiles = []
    for row in range(rows):
        for column in range(columns):
            path = f't{column}_{row}.obj'
            with open(os.path.join(folder, path), 'w') as file:
                file.write(text_of(column, row))
            tiles.append({'col': column, 'row': row, 'path': path})
    with open(os.path.join(folder, 'scene.json'), 'w') as file:
        json.dump({'cell_size': SIDE, 'cols': columns, 'rows': rows, 'tiles': tiles}, file)
    return folder


def square(column, row):
    x, y = column * SIDE, row * SIDE
    return f'v {x} {y} 0\nv {x + SIDE} {y} 0\nv {x + SIDE} {y + SIDE} 0\nv {x} {y + SIDE} 0\nf 1 2 3\nf 1 3 4\n'


def drive(cluster, folder, chromium, job):
    """Runs the script, and does what it asks for. `job`: of the scene `lakes`."""
    scene, out = cluster.path('lakes'), cluster.path('out_lakes')

    def run_again():
        done = subprocess.run([cluster.program('tilemend'), 'run', scene, '--out', out, '--overwrite'],
                              capture_output=True, text=True, timeout=120)
        if done.returncode:
            fail(done.stderr)

    def submit_again():
        cluster.submit(scene, '--overwrite', '--wait')

    actions = {'kill': cluster.kill, 'start': cluster.start, 'run_again': run_again, 'submit_again': submit_again}
    script = subprocess.Popen(['node', 'open_console.mjs', f'http://{cluster.web}', chromium, folder, job], cwd=folder,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    said = []
    for line in script.stdout:
        if line.startswith('DO '):
            actions[line.split()[1]]()
            script.stdin.write('\n')
            script.stdin.flush()
        else:
            said.append(line)
    if script.wait():
        fail(''.join(said))
    print(''.join(said), end='')


def ask(web, path):
    """The answer, or its status if it is an error."""
    request = urllib.request.Request(f'http://{web}/v1/{path}', headers={'Authorization': 'Bearer eve'})
    try:
        return urllib.request.urlopen(request, timeout=30).read()
    except urllib.error.HTTPError as error:
        error.close()
        return error.code


def check_times(web, job, what):
    """All that the page asks for, from the job's beginning on, without what a browser keeps: seconds of each request."""
    took = []
    for _ in range(40):
        for path in ('me', 'jobs?pageSize=200', 'workers', job, f'{job}/cells', f'{job}/holes', f'{job}/log'):
            begin = time.time()
            ask(web, path)
            took.append(time.time() - begin)
    took.sort()
    median, most = took[len(took) // 2], took[len(took) * 95 // 100]
    print(f'{what}: median {median:.3f} s, 95 % within {most:.3f} s, longest {took[-1]:.3f} s')
    if most > 0.1:
        fail('95 % of the requests take more than 0.1 s')


def pause_at_the_plan(cluster, job):
    """Pauses the job once its holes are planned, before they are filled."""
    end = time.time() + 60
    while time.time() < end:
        answer = ask(cluster.web, f'{job}/holes')
        if isinstance(answer, bytes) and json.loads(answer)['planned']:
            cluster.client('pause', job)
            return
        time.sleep(0.02)
    fail('no hole is shown while the job runs')


def broken(column, row):
    return tile(column, row) if column == 0 else 'v 0 0 0\nf 1 2 x\n'


def mostly_empty(folder, columns, rows):
    """A scene of very many cells, of which those of the first row have a tile."""
    make_scene(folder, columns, 1, square)
    with open(os.path.join(folder, 'scene.json')) as file:
        scene = json.load(file)
    scene['rows'] = rows
    scene['tiles'] += [{'col': column, 'row': row, 'path': None} for row in range(1, rows) for column in range(columns)]
    with open(os.path.join(folder, 'scene.json'), 'w') as file:
        json.dump(scene, file)
    return folder


def main():
    folder, programs = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    if not shutil.which('npm') or not shutil.which('node'):
        skip('there is no npm')
    chromium = shutil.which('chromium') or shutil.which('google-chrome')
    if not chromium:
        skip('there is no Chromium')
    install(folder)
    for name in ('console_tab.mjs', 'open_console.mjs'):
        shutil.copy(os.path.join(HERE, name), folder)
    with tempfile.TemporaryDirectory() as temporary:
        cluster = Cluster(temporary, programs)
        try:
            cluster.start()
            cluster.start_worker()
            first = cluster.submit(make_scene(cluster.path('lakes'), 4, 3, tile), '--wait')
            cluster.submit(make_scene(cluster.path('<img src=x onerror=alert(1)>'), 2, 1, tile), '--wait')
            cluster.submit(make_scene(cluster.path('broken'), 2, 1, broken), '--wait')
            planned = cluster.submit(make_scene(cluster.path('planned'), 12, 12, tile))
            pause_at_the_plan(cluster, planned['name'])
            wide = cluster.submit(mostly_empty(cluster.path('wide'), *WIDE))
            cluster.client('pause', wide['name'])
            check_times(cluster.web, wide['name'], 'requests on 100,000 cells')
            large = cluster.submit(make_scene(cluster.path('large'), LARGE, LARGE, square))
            cluster.client('pause', large['name'])
            drive(cluster, folder, chromium, first['name'])
        finally:
            cluster.close()
    print('the page works')


if __name__ == '__main__':
    main()
