#!/usr/bin/env python3
"""Holds every tileset that is written to the schema of 3D Tiles 1.0 and 1.1.

    tileset_schema_test.py FOLDER BIN OSGB_SAMPLE TILESET_SAMPLE

The fields are those of the types that Cesium publishes with 3d-tiles-tools: the TypeScript compiler knows no field that
the schema has not. The ranges of values are here, as types have none. OSGB tiles are written as 3D Tiles, and 3D Tiles
of every layout are filled. Before that, faults are put into copies, and each must be found. FOLDER gets the packages of
tileset_schema/package-lock.json and keeps them. Exit code 77 (skipped, and says so) without npm or its registry.
"""
import copy
import json
import os
import re
import sys
import tempfile

from npm_packages import fail, install, run

HERE = os.path.dirname(os.path.abspath(__file__))
TYPES = '3d-tiles-tools/build/src/structure/structure/Tileset'
VOLUMES = {'box': 12, 'region': 6, 'sphere': 4}


def field_faults(folder, tilesets):
    """By name, what the compiler says of the fields of tilesets; '' if nothing."""
    with tempfile.TemporaryDirectory(dir=folder) as inner:
        for name, tileset in tilesets.items():
            with open(os.path.join(inner, name + '.ts'), 'w') as file:
                file.write(f"import type {{Tileset}} from '{TYPES}';\nexport const it: Tileset = {json.dumps(tileset)};\n")
        done = run('node', os.path.join(folder, 'node_modules/typescript/bin/tsc'), '--strict', '--noEmit', '--module', 'commonjs',
                   '--moduleResolution', 'node', *(name + '.ts' for name in tilesets), cwd=inner)
    faults = {name: '\n'.join(re.findall(rf'^{name}\.ts.*', done.stdout, re.M)) for name in tilesets}
    if done.returncode and not any(faults.values()):
        fail(f'the compiler: {done.stdout}')
    return faults


def volume_faults(volume):
    if not any(kind in volume for kind in VOLUMES):
        yield 'no box, region or sphere'
    for kind, count in VOLUMES.items():
        if kind in volume and len(volume[kind]) != count:
            yield f'{kind}: {len(volume[kind])} numbers, not {count}'


def tile_faults(tile, path, folder, error):
    """Of a tile and those below it; `error` is the geometric error above it."""
    yield from (f'{path}: {fault}' for fault in volume_faults(tile['boundingVolume']))
    if not 0 <= tile['geometricError'] <= error:
        yield f'{path}: geometricError {tile["geometricError"]} is not from 0 to {error}'
    if tile.get('refine', 'REPLACE') not in ('ADD', 'REPLACE'):
        yield f'{path}: refine {tile["refine"]}'
    if 'transform' in tile and len(tile['transform']) != 16:
        yield f'{path}: transform of {len(tile["transform"])} numbers'
    if 'content' in tile and 'contents' in tile:
        yield f'{path}: content and contents'
    for content in [tile['content']] if 'content' in tile else tile.get('contents', []):
        if not os.path.isfile(os.path.join(folder, content['uri'])):
            yield f'{path}: {content["uri"]} is not there'
    if tile.get('children') == []:
        yield f'{path}: children is empty'
    for i, child in enumerate(tile.get('children', [])):
        yield from tile_faults(child, f'{path}/children/{i}', folder, tile['geometricError'])


def value_faults(tileset, folder):
    if tileset['asset']['version'] not in ('1.0', '1.1'):
        yield f'version {tileset["asset"]["version"]}'
    if 'refine' not in tileset['root']:
        yield 'root without refine'
    if not set(tileset.get('extensionsRequired', [])) <= set(tileset.get('extensionsUsed', [])):
        yield 'an extension that is required, and not used'
    yield from tile_faults(tileset['root'], 'root', folder, tileset['geometricError'])


def spoilt(tileset):
    """(what was done, tileset) with one fault each."""
    def changed(change):
        copied = copy.deepcopy(tileset)
        change(copied)
        return copied

    yield 'a field that there is not', changed(lambda t: t['root'].update(geometricErrors=1))
    yield 'no version', changed(lambda t: t['asset'].pop('version'))
    yield 'a word for a number', changed(lambda t: t['root'].update(geometricError='8'))
    yield 'no volume', changed(lambda t: t['root'].pop('boundingVolume'))
    yield 'an empty volume', changed(lambda t: t['root']['boundingVolume'].clear())
    yield 'a box of 11 numbers', changed(lambda t: t['root']['boundingVolume'].update(box=[0] * 11))
    yield 'an error below 0', changed(lambda t: t['root'].update(geometricError=-1))
    yield 'an error above its parent', changed(lambda t: t['root'].update(geometricError=2 * t['geometricError'] + 1))
    yield 'a file that is not there', changed(lambda t: t['root'].update(content={'uri': 'no.glb'}))
    yield 'no refine', changed(lambda t: t['root'].pop('refine'))
    yield 'no tiles among children', changed(lambda t: t['root'].update(children=[]))


def tilesets_in(out):
    found = {}
    for folder, _, names in os.walk(out):
        for name in names:
            if not name.endswith('.json'):
                continue
            with open(os.path.join(folder, name)) as file:
                content = json.load(file)
            if 'asset' in content:
                found[os.path.join(folder, name)] = content
    return found


def written(program, samples, folder):
    """All tilesets of outputs, by their files."""
    osgb, tiles = samples
    for name, words, options in (('osgb', [osgb], ['--output-format', '3dtiles']), ('one', [tiles], []),
                                 ('of-tiles', [tiles], []), ('on-earth', [tiles], []), ('earth-centred', [tiles], [])):
        scene, out = os.path.join(folder, name), os.path.join(folder, name + '_out')
        done = run(*words, scene, *([name] if words == [tiles] else []))
        if done.returncode:
            fail(done.stdout)
        done = run(program, 'run', scene, '--out', out, *options)
        if done.returncode:
            fail(f'{name}: {done.stdout}')
        found = tilesets_in(out)
        if not found:
            fail(f'{name}: no tileset was written')
        yield from found.items()


def main():
    folder = os.path.abspath(sys.argv[1])
    program = os.path.join(os.path.abspath(sys.argv[2]), 'tilemend')
    install(folder, os.path.join(HERE, 'tileset_schema'))
    with tempfile.TemporaryDirectory() as temporary:
        outputs = dict(written(program, [os.path.abspath(sample) for sample in sys.argv[3:5]], temporary))
        numbered = {f'tileset{i}': file for i, file in enumerate(outputs)}
        cases = {f'fault{i}': case for i, case in enumerate(spoilt(next(iter(outputs.values()))))}
        faults = field_faults(folder, {**{name: outputs[file] for name, file in numbered.items()},
                                       **{name: tileset for name, (_, tileset) in cases.items()}})
        for name, file in numbered.items():
            found = [faults[name]] if faults[name] else list(value_faults(outputs[file], os.path.dirname(file)))
            if found:
                fail(f'{os.path.relpath(file, temporary)}: ' + '\n'.join(found))
        home = os.path.dirname(next(iter(outputs)))
        missed = [what for name, (what, tileset) in cases.items() if not faults[name] and not any(value_faults(tileset, home))]
        if missed:
            fail(f'not found: {missed}')
    print(f'{len(outputs)} tilesets: passed, {len(cases)} faults found')


if __name__ == '__main__':
    main()
