#!/usr/bin/python3
"""Runs `tilemend run` on a tileset whose leaves overlap and are cut along turned axes, with holes that are known.

    pieces_test.py TILEMEND DATA TOOLS

DATA has the leaves as PLY files, named by their places in the tree; TOOLS has check_fill.py, which reads them.
Exits 77 (skipped) without the data, the tools or numpy.
"""
import glob
import json
import os
import struct
import subprocess
import sys
import tempfile

SKIPPED = 77
# Where a view from above shows the ground beneath: x, y, m2.
HOLES = [(78, 150, 544), (75, 65, 413), (24, 107, 132), (74, 108, 112), (43, 38, 75), (36, 76, 74), (38, 61, 68), (73, 26, 47)]


def skip(why):
    print('SKIPPED:', why)
    sys.exit(SKIPPED)


def glb(vertices, triangles):
    """A model of the triangles alone; glTF has y up."""
    import numpy as np
    points = np.column_stack([vertices[:, 0], vertices[:, 2], -vertices[:, 1]]).astype('<f4')
    corners = triangles.astype('<u4')
    data = points.tobytes() + corners.tobytes()
    views = [{'buffer': 0, 'byteOffset': 0, 'byteLength': points.nbytes},
             {'buffer': 0, 'byteOffset': points.nbytes, 'byteLength': corners.nbytes}]
    accessors = [{'bufferView': 0, 'componentType': 5126, 'count': len(points), 'type': 'VEC3',
                  'min': points.min(0).tolist(), 'max': points.max(0).tolist()},
                 {'bufferView': 1, 'componentType': 5125, 'count': int(corners.size), 'type': 'SCALAR'}]
    text = json.dumps({'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
                       'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
                       'accessors': accessors, 'bufferViews': views, 'buffers': [{'byteLength': len(data)}]}).encode()
    text += b' ' * (-len(text) % 4)
    return (struct.pack('<4sII', b'glTF', 2, 28 + len(text) + len(data)) + struct.pack('<I4s', len(text), b'JSON') + text
            + struct.pack('<I4s', len(data), b'BIN\0') + data)


def node(boxes, prefix):
    """The tile of the tree whose name is the prefix, with its children."""
    import numpy as np
    names = [name for name in boxes if name.startswith(prefix)]
    low, high = (f([boxes[name][k] for name in names], axis=0) for k, f in ((0, np.min), (1, np.max)))
    middle, half = (low + high) / 2, (high - low) / 2
    tile = {'boundingVolume': {'box': [*middle.tolist(), half[0], 0, 0, 0, half[1], 0, 0, 0, half[2]]}, 'geometricError': 0}
    if prefix in boxes:
        return {**tile, 'content': {'uri': prefix + '.glb'}}
    children = [node(boxes, child) for child in sorted({name[:len(prefix) + 1] for name in names})]
    return {**tile, 'geometricError': 2.0 ** (6 - len(prefix)), 'refine': 'REPLACE', 'children': children}


def write_tileset(data, check_fill, folder):
    boxes = {}
    os.makedirs(folder)
    for path in sorted(glob.glob(os.path.join(data, '*.ply'))):
        name = os.path.basename(path)[:-4].split('_')[-1]
        vertices, triangles = check_fill.read(path)
        boxes[name] = (vertices.min(0).astype(float), vertices.max(0).astype(float))
        with open(os.path.join(folder, name + '.glb'), 'wb') as file:
            file.write(glb(vertices, triangles))
    with open(os.path.join(folder, 'tileset.json'), 'w') as file:
        json.dump({'asset': {'version': '1.1'}, 'geometricError': 500, 'root': node(boxes, '')}, file, default=float)


def rings(coordinates):
    """The rings of a polygon or of several."""
    if not isinstance(coordinates[0][0], list):
        return [coordinates]
    return [ring for part in coordinates for ring in rings(part)]


def is_around(ring, x, y):
    xs, ys = [p[0] for p in ring], [p[1] for p in ring]
    return min(xs) <= x <= max(xs) and min(ys) <= y <= max(ys)


def main():
    tilemend, data, tools = sys.argv[1:]
    for needed in (data, os.path.join(tools, 'check_fill.py')):
        if not os.path.exists(needed):
            skip(f'{needed} is not there')
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        skip(f'{error}; install python3-numpy')
    sys.path.insert(0, tools)
    import check_fill
    with tempfile.TemporaryDirectory() as folder:
        scene, out = os.path.join(folder, 'scene'), os.path.join(folder, 'out')
        write_tileset(data, check_fill, scene)
        run = subprocess.run([tilemend, 'run', scene, '--out', out], capture_output=True, text=True, timeout=250)
        if run.returncode not in (0, 100):
            sys.exit(f'tilemend run: exit code {run.returncode}\n{run.stdout}{run.stderr}')
        with open(os.path.join(out, 'holes.geojson')) as file:
            features = json.load(file)['features']
        filled = [f for f in features if f['properties'].get('outcome', 'filled') == 'filled']
        missed = []
        for x, y, area in HOLES:
            if not any(is_around(ring, x, y) for f in filled for ring in rings(f['geometry']['coordinates'])):
                missed.append((x, y, area))
        report = json.load(open(os.path.join(out, 'report.json')))
        area = sum(hole.get('area_m2', 0) for hole in report['per_hole'] if hole['outcome'] == 'filled')
        check = subprocess.run([tilemend, 'check', scene, out, '-o', 'json'], capture_output=True, text=True, timeout=100)
        open_edges = json.loads(check.stdout)['findings']['open_edges']['count']
        print(f'{len(filled)} holes, {area:.1f} m2 filled, {open_edges} new open edges; missed: {missed}')
        sys.exit(0 if not missed and area > 1500 and open_edges <= 10 else 'holes over pieces are not filled')


if __name__ == '__main__':
    main()
