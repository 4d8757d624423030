#!/usr/bin/env python3
"""Has Khronos' glTF validator judge the files that the glTF codec writes.

    gltf_validator_test.py GLTF_CHANGED SHARED_DATA

GLTF_CHANGED is the program that writes them. The b3dm files of SHARED_DATA/mars_tiles are changed as well, if they are
there. Needs node and the npm package gltf-validator, in the folder that the environment variable TILEMEND_NODE_MODULES
names or among the global packages of npm; without them the test is skipped (exit code 77).
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
# Prints {file: [[severity, code, pointer], ...]}; severity 0 is an error, 1 a warning.
SCRIPT = """
const fs = require('fs'), validator = require('gltf-validator');
(async () => {
  const report = {};
  for (const file of fs.readdirSync(process.argv[1])) {
    const bytes = new Uint8Array(fs.readFileSync(process.argv[1] + '/' + file));
    const result = await validator.validateBytes(bytes, {maxIssues: 1000});
    report[file] = result.issues.messages.map(m => [m.severity, m.code, m.pointer]);
  }
  console.log(JSON.stringify(report));
})();
"""


def skip(reason):
    print(f'SKIPPED: {reason}: no glTF file is validated')
    sys.exit(SKIPPED)


def node_modules():
    named = os.environ.get('TILEMEND_NODE_MODULES')
    if named:
        return named
    try:
        return subprocess.run(['npm', 'root', '-g'], capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        skip('npm is missing')


def validate(folder, modules):
    try:
        run = subprocess.run(['node', '-e', SCRIPT, folder], capture_output=True, text=True, check=True,
                             env={**os.environ, 'NODE_PATH': modules})
    except OSError:
        skip('node is missing')
    return json.loads(run.stdout)


def main():
    program, shared_data = sys.argv[1:3]
    modules = node_modules()
    if not os.path.isdir(os.path.join(modules, 'gltf-validator')):
        skip(f'the npm package gltf-validator is not in {modules}')
    tiles = sorted(glob.glob(os.path.join(shared_data, 'mars_tiles', '*.b3dm')))
    if not tiles:
        print('NO 3D TILES: only samples are validated; set TILEMEND_SHARED_DATA')
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, folder, *tiles], check=True)
        report = validate(folder, modules)
    if len(report) < 21:
        sys.exit(f'expected at least 21 files, found {len(report)}')
    given = {os.path.basename(tile) for tile in tiles}
    wrong = 0
    for file, issues in sorted(report.items()):
        source = file.split('_', 1)[1]
        known = set()
        if source.removesuffix('.glb') in given:  # faults that the given file has already
            known = {(severity, code) for severity, code, _ in report['original_' + source]}
        for severity, code, pointer in issues:
            if severity <= 1 and (severity, code) not in known:
                print(file, severity, code, pointer)
                wrong += 1
    print(f'{len(report)} files validated, {wrong} new errors and warnings')
    sys.exit(1 if wrong else 0)


if __name__ == '__main__':
    main()
