#!/usr/bin/env python3
"""Runs scenes part by part into one output, and holds that to a run over all cells.

    parts_test.py BIN MAKE_SCENE OSGB_SAMPLE TILESET_SAMPLE

Scenes of PLY and OBJ tiles, OSGB trees, 3D Tiles, and OSGB written as 3D Tiles. Each is run with --cells for its parts,
in an order of its own, without --overwrite; one run is killed (SIGKILL) in between and given again. At the end every
file is that of a run over all cells, and no part has touched a tile of an earlier one. Runs of other options, of cells
that are there, and into an output whose tile was changed are refused, and change nothing. Exit code 1 if anything is
not so.
"""
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

VOLATILE = ('report.json', 'report.html')
COUNTS = ('cells', 'clusters', 'holes', 'filled', 'left', 'levels', 'water', 'quality', 'per_hole')


def require(condition, what):
    if not condition:
        sys.exit(f'FAILED: {what}')


def files_of(out):
    found = {}
    for folder, names, files in os.walk(out):
        names[:] = [name for name in names if not name.startswith('.tilemend-')]
        for name in files:
            path = os.path.join(folder, name)
            if not name.startswith('.tilemend-'):
                found[os.path.relpath(path, out)] = path
    return found


def stamps_of(out):
    return {name: (os.stat(path).st_mtime_ns, os.stat(path).st_ino) for name, path in files_of(out).items()}


def read(path):
    with open(path, 'rb') as file:
        return file.read()


def report_of(out):
    return json.loads(read(os.path.join(out, 'report.json')))


def as_obj(scene):
    """Makes OBJ tiles of the PLY ones; all name one material file, which the first tile of a run carries."""
    with open(os.path.join(scene, 'scene.json')) as file:
        layout = json.load(file)
    with open(os.path.join(scene, 'tiles/ground.mtl'), 'w') as file:
        file.write('newmtl ground\nKd 0.4 0.5 0.3\n')
    for tile in layout['tiles']:
        if not tile['path']:
            continue
        path = os.path.join(scene, tile['path'])
        head, body = read(path).split(b'end_header\n', 1)
        lines = head.decode().split('\n')
        vertices, faces = (int(next(line for line in lines if line.startswith('element ' + kind)).split()[2])
                           for kind in ('vertex', 'face'))
        form = '<3d' if ' double x' in head.decode().replace('property', '') else '<3f'
        size = struct.calcsize(form)
        text = ['mtllib ground.mtl', 'usemtl ground']
        text += ['v %r %r %r' % struct.unpack_from(form, body, v * size) for v in range(vertices)]
        text += ['f %d %d %d' % tuple(c + 1 for c in struct.unpack_from('<3i', body, vertices * size + 13 * f + 1))
                 for f in range(faces)]
        tile['path'] = tile['path'].replace('.ply', '.obj')
        with open(os.path.join(scene, tile['path']), 'w') as file:
            file.write('\n'.join(text) + '\n')
        os.remove(path)
    with open(os.path.join(scene, 'scene.json'), 'w') as file:
        json.dump(layout, file)


class Scene:
    def __init__(self, program, name, scene, options=()):
        self.program, self.name, self.scene, self.options = program, name, scene, options
        self.out, self.whole = scene + '_parts', scene + '_whole'

    def command(self, out, *words):
        return [self.program, 'run', self.scene, '--out', out, *self.options, *words]

    def run(self, *words, out=None, codes=(0, 100)):
        done = subprocess.run(self.command(out or self.out, *words), capture_output=True, text=True, timeout=120)
        require(done.returncode in codes, f'{self.name} {words}: exit code {done.returncode}: {done.stderr}')
        return done.stderr

    def run_whole(self):
        self.run(out=self.whole)

    def kill(self, cells, seconds):
        """Whether the run was killed before its end."""
        run = subprocess.Popen(self.command(self.out, '--cells', cells), stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
        time.sleep(seconds)
        run.send_signal(signal.SIGKILL)
        return run.wait() == -signal.SIGKILL

    def require_whole(self):
        parts, whole = files_of(self.out), files_of(self.whole)
        require(set(parts) == set(whole), f'{self.name}: other files: {sorted(set(parts) ^ set(whole))}')
        for name, path in parts.items():
            if name not in VOLATILE:
                require(read(path) == read(whole[name]), f'{self.name}: {name} is not that of a run over all cells')
        a, b = report_of(self.out), report_of(self.whole)
        for count in COUNTS:
            require(a[count] == b[count], f'{self.name}: {count}: {a[count]} in parts, {b[count]} in one run')


def add_parts(scene, parts, killed):
    """Runs the parts; the one with the number `killed` is killed first, again and again until it is done."""
    for number, cells in enumerate(parts):
        before = stamps_of(scene.out) if os.path.isdir(scene.out) else {}
        seconds, times = 0.02, 0
        while number == killed and scene.kill(cells, seconds):
            seconds, times = 1.5 * seconds, times + 1
        done = number == killed and os.path.exists(os.path.join(scene.out, 'report.json')) \
            and scene_has(scene, cells)
        if not done:
            scene.run('--cells', cells)
        after = stamps_of(scene.out)
        for name, stamp in before.items():
            if os.path.dirname(name) and not name.endswith('tileset.json'):
                require(after[name] == stamp, f'{scene.name}: --cells {cells} touched {name}')
        if number == killed:
            print(f'{scene.name}: --cells {cells} was killed {times} times')


def scene_has(scene, cells):
    return cells in report_of(scene.out)['options'].get('cells', '')


def check_refusals(scene, parts):
    before = {name: read(path) for name, path in files_of(scene.out).items()}
    for words, says in ((('--cells', parts[0]), 'complete'), ((), 'complete'),
                        (('--gradation', '1.7'), '--gradation'), (('--texture', 'flat'), '--texture')):
        text = scene.run(*words, codes=(4, 6))
        require(says in text and 'exists already' in text, f'{scene.name} {words}: {text}')
    require(before == {name: read(path) for name, path in files_of(scene.out).items()},
            f'{scene.name}: a run that was refused changed the output')


def check_changed_tile(scene, parts, tile):
    """A tile that somebody has changed is not written again."""
    shutil.rmtree(scene.out)
    scene.run('--cells', parts[0])
    path = os.path.join(scene.out, tile)
    with open(path, 'ab') as file:
        file.write(b'\n')
    changed = read(path)
    text = scene.run('--cells', parts[1], codes=(4, 6))
    require(os.path.basename(tile) in text and '--overwrite' in text, f'{scene.name}: {text}')
    require(read(path) == changed, f'{scene.name}: a changed tile was written over')


def main():
    program, make_scene, osgb, tileset = (os.path.abspath(word) for word in sys.argv[1:5])
    program = os.path.join(program, 'tilemend')
    with tempfile.TemporaryDirectory() as folder:
        made = [(name, os.path.join(folder, name)) for name in ('ply', 'obj', 'osgb', 'delivery', 'tiles')]
        for name, scene in made:
            words = {'ply': [make_scene, scene, '--cols', '4', '--rows', '3', '--cell', '40', '--spacing', '1.5'],
                     'obj': [make_scene, scene, '--cols', '4', '--rows', '3', '--cell', '40', '--spacing', '1.5'],
                     'osgb': [osgb, scene], 'delivery': [osgb, scene], 'tiles': [tileset, scene, 'of-tiles']}[name]
            done = subprocess.run(words, capture_output=True, text=True)
            require(done.returncode == 0, f'{words}: {done.stderr}')
            if name == 'obj':
                as_obj(scene)
        for name, path in made:
            scene = Scene(program, name, path, ('--output-format', '3dtiles') if name == 'delivery' else ())
            large = name in ('ply', 'obj')
            parts = ['2,1-3,2', '0,0', '1,0-3,0 0,1-1,2'] if large else ['1,0', '0,0']
            scene.run_whole()
            add_parts(scene, parts, killed=1)
            scene.require_whole()
            check_refusals(scene, parts)
            print(f'{name}: {len(parts)} parts are the whole')
            if name == 'ply':
                check_changed_tile(scene, parts, 'tiles/' + sorted(
                    os.path.basename(file) for file in files_of(scene.out) if file.startswith('tiles/'))[-1])


if __name__ == '__main__':
    main()
