#!/usr/bin/env python3
"""Runs examples/python with the package: examples_test.py BIN PACKAGE"""
import os
import shutil
import subprocess
import sys
import tempfile

BIN, PACKAGE = sys.argv[1:]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXAMPLES = os.path.join(ROOT, 'examples', 'python')


def run(name, *arguments):
    done = subprocess.run([sys.executable, os.path.join(EXAMPLES, name), *arguments], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, env=dict(os.environ, PYTHONPATH=PACKAGE), timeout=300)
    if done.returncode:
        raise SystemExit(f'FAILED: {name} ends with {done.returncode}\n{done.stdout}\n{done.stderr}')
    return done.stdout


def check_usage(name):
    """Without arguments an example says how it is called."""
    done = subprocess.run([sys.executable, os.path.join(EXAMPLES, name)], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, env=dict(os.environ, PYTHONPATH=PACKAGE), timeout=300)
    if done.returncode != 2 or not done.stderr.startswith(f'Usage: {name} ') or done.stderr.count('\n') != 1:
        raise SystemExit(f'FAILED: {name} without arguments ends with {done.returncode}\n{done.stderr}')


def expect(text, part, of):
    if part not in text:
        raise SystemExit(f'FAILED: {of} does not print {part!r}:\n{text}')


def start(words, awaited):
    program = subprocess.Popen(words + ['--log', 'text'], stderr=subprocess.PIPE, text=True)
    for line in program.stderr:
        if awaited in line:
            return program, line.split(awaited)[1].strip()
    raise SystemExit(f'FAILED: {words[0]} ended')


def fill_file(folder):
    from importlib.util import find_spec
    if find_spec('meshio') is None:
        print('SKIPPED: fill_file.py: there is no meshio (Debian: python3-meshio)')
        return
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    from meshes import ply_bytes, sphere
    mesh, out = f'{folder}/mesh.ply', f'{folder}/filled.ply'
    vertices, faces = sphere()
    with open(mesh, 'wb') as file:
        file.write(ply_bytes(vertices, faces))
    run('fill_file.py', mesh, out)
    check_usage('fill_file.py')
    lines = subprocess.run([f'{BIN}/tilemend', 'inspect', out], text=True, stdout=subprocess.PIPE, check=True).stdout
    expect(lines, 'holes: 0 closed', 'tilemend inspect of what fill_file.py wrote')


def fill_scene(folder):
    subprocess.run([f'{BIN}/tilemend-make-scene', f'{folder}/scene', '--cols', '3', '--rows', '2', '--spacing', '5'],
                   check=True, stdout=subprocess.DEVNULL)
    coordinator, address = start([f'{BIN}/tilemend-coordinator', '--work', f'{folder}/work', '--listen', '127.0.0.1:0'],
                                 'listening address=')
    worker, _ = start([f'{BIN}/tilemend-worker', '--coordinator', address], 'info connected')
    try:
        expect(run('fill_scene.py', address, f'{folder}/scene', f'{folder}/out'), 'left open', 'fill_scene.py')
    finally:
        worker.terminate()
        coordinator.terminate()


def main():
    folder = tempfile.mkdtemp(prefix='tilemend-examples-')
    try:
        expect(run('fill_arrays.py'), 'filled', 'fill_arrays.py')
        fill_file(folder)
        fill_scene(folder)
        check_usage('fill_scene.py')
    finally:
        shutil.rmtree(folder)
    print('all examples of Python ran')


if __name__ == '__main__':
    main()
