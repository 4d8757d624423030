#!/usr/bin/env python3
"""Has Khronos' glTF validator judge the files that the glTF codec writes.

    gltf_validator_test.py FOLDER GLTF_CHANGED SHARED_DATA

FOLDER gets the packages of web/package-lock.json and keeps them. GLTF_CHANGED is the program that writes the files. The
b3dm files of SHARED_DATA/mars_tiles are changed as well, if they are there. Without npm or its registry the test is
skipped (exit code 77).
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), *['..'] * 3, 'web'))
import npm_packages  # noqa: E402

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


def validate(folder, modules):
    run = subprocess.run(['node', '-e', SCRIPT, folder], capture_output=True, text=True, check=True,
                         env={**os.environ, 'NODE_PATH': modules})
    return json.loads(run.stdout)


def main():
    packages, program, shared_data = sys.argv[1:4]
    npm_packages.install(os.path.abspath(packages))
    modules = os.path.join(os.path.abspath(packages), 'node_modules')
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
