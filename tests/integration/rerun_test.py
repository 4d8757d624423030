#!/usr/bin/env python3
"""Changes a scene or its output between runs, and kills runs, and holds what comes of it to runs from scratch.

    rerun_test.py BIN [--cols 6] [--rows 4] [--cell 60] [--spacing 1.5] [--changes 12] [--kills 8] [--seed 1]

BIN has tilemend and tilemend-make-scene. A made scene is run; then, again and again, something is changed and the scene
is run into the same folder with --overwrite: a tile is written anew as it was, a vertex of a tile is moved (with the
file's size and time left as they were), triangles are taken out of a tile, a tile of the output is changed, cut short or
removed. Then runs into a new folder are killed (SIGKILL) at random moments, and the same command is given until it comes
to its end. Every file of each output must be that of a run from scratch. A run where nothing was changed must take over
every task, and one where one tile was changed most of them. Prints what was taken over and how long it took. Exit code 1
if anything was not so.
"""
import argparse
import json
import os
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import time

from cluster_harness import LIMIT, Failure, check_output, require


class Tile:
    """A binary PLY of x, y, z and triangles, as tilemend-make-scene writes them."""

    def __init__(self, path):
        self.path = path
        with open(path, 'rb') as file:
            data = file.read()
        end = data.index(b'end_header\n') + len(b'end_header\n')
        lines = data[:end].decode().split('\n')
        self.number = next(line for line in lines if line.endswith(' x')).split()[1]
        self.vertices, self.faces = (int(next(line for line in lines if line.startswith('element ' + kind)).split()[2])
                                     for kind in ('vertex', 'face'))
        self.size = 24 if self.number == 'double' else 12
        self.lines = lines
        self.points = bytearray(data[end:end + self.vertices * self.size])
        self.triangles = data[end + len(self.points):]
        require(len(self.triangles) == 13 * self.faces, f'{path}: not as tilemend-make-scene writes it')

    def write(self):
        lines = [f'element face {len(self.triangles) // 13}' if line.startswith('element face') else line
                 for line in self.lines]
        with open(self.path, 'wb') as file:
            file.write('\n'.join(lines).encode() + self.points + self.triangles)

    def lift(self, vertex):
        form = '<d' if self.number == 'double' else '<f'
        at = vertex * self.size + self.size * 2 // 3
        height = struct.unpack_from(form, self.points, at)[0]
        struct.pack_into(form, self.points, at, height + 0.25)

    def open_at(self, vertex):
        """Takes out the triangles around a vertex."""
        kept = [self.triangles[i:i + 13] for i in range(0, len(self.triangles), 13)]
        self.triangles = b''.join(t for t in kept if vertex not in struct.unpack('<3i', t[1:]))


class Bench:
    def __init__(self, arguments, folder, dice):
        self.bin, self.dice = arguments.bin, dice
        self.scene = os.path.join(folder, 'scene')
        self.out, self.fresh = os.path.join(folder, 'out'), os.path.join(folder, 'fresh')
        subprocess.run([os.path.join(self.bin, 'tilemend-make-scene'), self.scene, '--cols', str(arguments.cols), '--rows',
                        str(arguments.rows), '--cell', str(arguments.cell), '--spacing', str(arguments.spacing),
                        '--seed', str(arguments.seed)], check=True, stdout=subprocess.DEVNULL)
        self.tiles = sorted(os.listdir(os.path.join(self.scene, 'tiles')))

    def command(self, out, *flags):
        return [os.path.join(self.bin, 'tilemend'), 'run', self.scene, '--out', out, '--workers', '2', '-o', 'json', *flags]

    def run(self, out, *flags):
        start = time.time()
        run = subprocess.run(self.command(out, *flags), capture_output=True, text=True, timeout=LIMIT)
        require(run.returncode in (0, 100), f'exit code {run.returncode}: {run.stderr}')
        seconds = time.time() - start
        with open(os.path.join(out, 'report.json')) as file:
            return json.load(file)['tasks'], seconds

    def run_from_scratch(self):
        shutil.rmtree(self.fresh, ignore_errors=True)
        return self.run(self.fresh)

    def pick(self, folder):
        return os.path.join(folder, 'tiles', self.dice.choice(self.tiles))


def rewrite(path):
    with open(path, 'rb') as file:
        data = file.read()
    with open(path, 'wb') as file:
        file.write(data)


def change(bench, what):
    """Gives whether the scene is another one."""
    path = bench.pick(bench.out if what.startswith('output') else bench.scene)
    if what == 'tile written anew':
        rewrite(path)
    elif what == 'vertex moved':
        before = os.stat(path)
        tile = Tile(path)
        tile.lift(bench.dice.randrange(tile.vertices))
        tile.write()
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    elif what == 'triangles taken out':
        tile = Tile(path)
        tile.open_at(bench.dice.randrange(tile.vertices))
        tile.write()
    elif what == 'output removed':
        os.remove(path)
    elif what == 'output changed':
        with open(path, 'r+b') as file:
            file.seek(os.path.getsize(path) // 2)
            byte = file.read(1)
            file.seek(-1, 1)
            file.write(bytes([byte[0] ^ 1]))
    elif what == 'output cut short':
        os.truncate(path, os.path.getsize(path) // 2)
    return what in ('vertex moved', 'triangles taken out')


CHANGES = ['nothing', 'vertex moved', 'triangles taken out', 'tile written anew', 'output removed', 'output changed',
           'output cut short']


def rerun(bench, changes):
    _, full = bench.run_from_scratch()
    bench.run(bench.out)
    print(f'from scratch: {full:.2f} s')
    for number in range(changes):
        what = CHANGES[number % len(CHANGES)]
        if change(bench, what):
            _, full = bench.run_from_scratch()
        tasks, seconds = bench.run(bench.out, '--overwrite')
        check_output(bench.fresh, bench.out)
        again = tasks['all'] - tasks['taken_over']
        print(f'{what}: {again} of {tasks["all"]} tasks again, {seconds:.2f} s; from scratch {full:.2f} s')
        require(again > 0 or what in ('nothing', 'tile written anew'), 'a change was missed')
        require(again == 0 or what not in ('nothing', 'tile written anew'), 'what was not changed was done again')
        require(again <= 1 or not what.startswith('output'), 'more was done again than the tile that was changed')
        require(again <= tasks['all'] / 2, 'most was done again')


def kill(bench, kills):
    _, full = bench.run_from_scratch()
    taken_over, runs, left = 0, 0, kills
    while left > 0:
        shutil.rmtree(bench.out)
        while left > 0:
            run = subprocess.Popen(bench.command(bench.out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(bench.dice.uniform(0, full))
            if run.poll() is not None:
                break
            run.kill()
            run.wait()
            left -= 1
        done = os.path.exists(os.path.join(bench.out, 'report.json'))
        tasks, _ = bench.run(bench.out, *(['--overwrite'] if done else []))
        taken_over += tasks['taken_over']
        runs += 1
        check_output(bench.fresh, bench.out)
    print(f'{kills} kills over {runs} outputs: {taken_over} of {runs * tasks["all"]} tasks taken over in the last runs')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('bin')
    for name, default in (('cols', 6), ('rows', 4), ('changes', 12), ('kills', 8), ('seed', 1)):
        parser.add_argument('--' + name, type=int, default=default)
    parser.add_argument('--cell', type=float, default=60)
    parser.add_argument('--spacing', type=float, default=1.5)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder, random.Random(arguments.seed))
        try:
            rerun(bench, arguments.changes)
            kill(bench, arguments.kills)
        except Failure as failure:
            print(f'FAILED: {failure}', file=sys.stderr)
            return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
