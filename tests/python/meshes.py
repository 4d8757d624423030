"""Meshes with holes, and PLY files of them, for the tests of the Python package."""
import numpy as np


def sphere(rings=24, sectors=48, hole=5):
    """A sphere of 10 units without the cap of `hole` rings on its side: one closed hole in space."""
    polar = np.linspace(0, np.pi, rings + 1)[1:-1]
    around = np.arange(sectors) * 2 * np.pi / sectors
    body = np.array([[np.sin(p) * np.cos(a), np.sin(p) * np.sin(a), np.cos(p)] for p in polar for a in around])
    vertices = 10 * np.vstack([body, [[0, 0, 1], [0, 0, -1]]])
    faces, north, south, last = [], len(body), len(body) + 1, rings - 2
    at = lambda ring, sector: ring * sectors + sector % sectors
    for s in range(sectors):
        faces += [(north, at(0, s), at(0, s + 1)), (south, at(last, s + 1), at(last, s))]
        for r in range(last):
            faces += [(at(r, s), at(r + 1, s), at(r + 1, s + 1)), (at(r, s), at(r + 1, s + 1), at(r, s + 1))]
    faces = np.array(faces)
    centres = vertices[faces].mean(axis=1)
    return vertices, faces[np.linalg.norm(centres - [10, 0, 0], axis=1) > hole]


def plane(side=40, first=15, last=25, turned=0.3):
    """A wavy sheet of side x side squares of 1 m without those from `first` to `last`."""
    y, x = np.mgrid[0:side + 1, 0:side + 1].astype(float)
    vertices = np.stack([x, y, 0.4 * np.sin(turned * x) * np.cos(turned * y)], axis=-1).reshape(-1, 3)
    faces = []
    for r in range(side):
        for c in range(side):
            if first <= r < last and first <= c < last:
                continue
            a, below = r * (side + 1) + c, (r + 1) * (side + 1) + c
            faces += [(a, a + 1, below + 1), (a, below + 1, below)]
    return vertices, np.array(faces)


def ply_bytes(vertices, faces, filled=None):
    """A binary PLY file. `filled`: as tilemend writes them, with a mark of each face."""
    number = {'f4': 'float', 'f8': 'double'}[vertices.dtype.str[1:]]
    lines = ['ply', 'format binary_little_endian 1.0', f'element vertex {len(vertices)}']
    lines += [f'property {number} {axis}' for axis in 'xyz']
    lines += [f'element face {len(faces)}', 'property list uchar int vertex_indices']
    fields = [('n', 'u1'), ('corners', '<i4', 3)]
    if filled is not None:
        lines.append('property uchar tilemend_filled')
        fields.append(('filled', 'u1'))
    records = np.zeros(len(faces), fields)
    records['n'], records['corners'] = 3, faces
    if filled is not None:
        records['filled'] = filled
    return '\n'.join(lines + ['end_header\n']).encode() + vertices.tobytes() + records.tobytes()
