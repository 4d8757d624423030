#!/usr/bin/env python3
"""Writes OSGB tiles as 3D Tiles, has gltf-validator judge each model, and draws them with three.js in Chromium.

    tileset_view_test.py FOLDER BIN OSGB_SAMPLE

FOLDER gets the packages of web/package-lock.json and keeps them; BIN has tilemend; OSGB_SAMPLE is the program that
writes a made scene of OSGB tiles. Exit code 77 (skipped, and says so) without npm, its registry or Chromium.
"""
import json
import os
import shutil
import sys
import tempfile

from npm_packages import chromium, fail, install, run, skip

HERE = os.path.dirname(os.path.abspath(__file__))
# Prints [[file, severity, code, pointer], ...]; severity 0 is an error, 1 a warning.
VALIDATE = """
const fs = require('fs'), path = require('path'), validator = require('gltf-validator');
(async () => {
  const found = [];
  for (const file of fs.readdirSync(process.argv[1], {recursive: true}).filter(f => f.endsWith('.glb'))) {
    const bytes = new Uint8Array(fs.readFileSync(path.join(process.argv[1], file)));
    const result = await validator.validateBytes(bytes, {maxIssues: 1000});
    found.push([file, result.issues.messages.filter(m => m.severity <= 1).map(m => [m.code, m.pointer])]);
  }
  console.log(JSON.stringify(found));
})();
"""


def deliver(temporary, program, sample):
    scene, out = os.path.join(temporary, 'scene'), os.path.join(temporary, 'out')
    done = run(sample, scene)
    if done.returncode:
        fail(done.stdout)
    done = run(program, 'run', scene, '--out', out, '--output-format', '3dtiles')
    if done.returncode:
        fail(done.stdout)
    return out


def validate(folder, out):
    """Every model is without an error and a warning."""
    env = {**os.environ, 'NODE_PATH': os.path.join(folder, 'node_modules')}
    done = run('node', '-e', VALIDATE, out, env=env)
    if done.returncode:
        fail(done.stdout)
    found = json.loads(done.stdout)
    for file, issues in found:
        if issues:
            fail(f'{file}: {issues}')
    if len(found) < 18:
        fail(f'expected 18 models or more, found {len(found)}')
    print(f'gltf-validator: {len(found)} models without an error or a warning')


def draw(folder, out, program, query, page='tileset_page.js'):
    """What the script `page` drew, with the picture in FOLDER."""
    for name in (page, 'view_tileset.mjs'):
        shutil.copy(os.path.join(HERE, name), folder)
    picture = os.path.join(folder, f'{page.split("_")[0]}_{query.replace("=", "_").replace("&", "_")}.png')
    done = run('node', 'view_tileset.mjs', page, out, program, picture, query, cwd=folder)
    if done.returncode:
        fail(done.stdout)
    return json.loads(done.stdout.splitlines()[-1])


def main():
    folder, program = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[2]), 'tilemend')
    install(folder)
    with tempfile.TemporaryDirectory() as temporary:
        out = deliver(temporary, program, os.path.abspath(sys.argv[3]))
        validate(folder, out)
        browser = chromium()
        if not browser:
            skip('there is no Chromium; the models are valid')
        coarse, fine = (draw(folder, out, browser, f'error={error}') for error in (300, 0.01))
    print(f'coarse: {coarse}, fine: {fine}')
    for result in (coarse, fine):
        if result['faults']:
            fail(result['faults'])
        if result['drawn'] < 0.1:
            fail('the picture shows background alone')
    # Two tiles: one model each at the coarsest level, four at the finest.
    if coarse['models'] != 2 or fine['models'] != 8 or fine['triangles'] < 8 * coarse['triangles']:
        fail('the levels of detail are not those of the tiles')
    print('the tileset is drawn at its coarsest and finest level')


if __name__ == '__main__':
    main()
