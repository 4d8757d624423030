"""What the benchmarks share about meshes: scenes as one mesh, OFF files, heights over points. Needs numpy and scipy."""
import os
import sys

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'scripts'))
import render

TOUCH = 1e-9  # how far outside a triangle, as a share of its height, a point still counts as over it


def merged(scene):
    """All tiles as one mesh: points (n x 3), triangles (m x 3); equal positions welded."""
    corners, _ = render.read_folder(scene)
    points, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return points, index.reshape(-1, 3)


def filled(folder):
    """Corners (n x 3 x 3) of the triangles that tilemend has marked as its own in the tiles below a folder."""
    corners, marks = render.read_folder(folder)
    return corners[marks]


def truth_of(scene):
    """The points (x, y, z) that the scene tools have removed."""
    return np.load(os.path.join(scene, 'truth.npz'))['points'].astype(float)


def boundary(triangles):
    """The edges (n x 2) with one triangle, in its direction."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    n = triangles.max() + 1
    key, back = edges[:, 0] * n + edges[:, 1], edges[:, 1] * n + edges[:, 0]
    return edges[~np.isin(key, back)]


def components(edges, n):
    """For each of n vertices the number of its connected component."""
    return connected_components(coo_matrix((np.ones(len(edges), bool), edges.T), (n, n)), directed=False)[1]


def close_rim(points, triangles):
    """Adds an apex far below and a cone from it to the boundary loops that reach the mesh's outline: a program that takes
    every loop for a hole then leaves them alone, the holes that open to the outline among them."""
    edges, n = boundary(triangles), len(points)
    lo, hi, xy = points[:, :2].min(0), points[:, :2].max(0), points[:, :2]
    loop, on_rim = components(edges, n), ((xy - lo < 1e-3) | (hi - xy < 1e-3)).any(1)
    rim = edges[np.isin(loop[edges[:, 0]], loop[edges[on_rim[edges].all(1), 0]])]
    apex = np.append((lo + hi) / 2, points[:, 2].min() - (hi - lo).max())
    cone = np.column_stack([rim[:, 1], rim[:, 0], np.full(len(rim), n)])
    return np.vstack([points, apex]), np.vstack([triangles, cone])


def write_off(path, points, triangles):
    with open(path, 'w', encoding='ascii') as file:
        file.write(f'OFF\n{len(points)} {len(triangles)} 0\n')
        np.savetxt(file, points, '%.9g')
        np.savetxt(file, np.column_stack([np.full(len(triangles), 3), triangles]), '%d')


def write_ply(path, points, triangles):
    """Binary, with float32 coordinates, as tiles are delivered."""
    faces = np.empty(len(triangles), [('n', 'u1'), ('v', '<i4', 3)])
    faces['n'], faces['v'] = 3, triangles
    with open(path, 'wb') as file:
        file.write(f'ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\n'
                   f'property float y\nproperty float z\nelement face {len(triangles)}\n'
                   'property list uchar int vertex_indices\nend_header\n'.encode())
        file.write(points.astype('<f4').tobytes() + faces.tobytes())


def read_off(path):
    with open(path, encoding='ascii') as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], float).reshape(-1, 3)
    return points, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], int).reshape(-1, 4)[:, 1:]


def raster_pairs(lo, hi, points, size):
    """Numbers of boxes (lo, hi) and points that share a square of a raster: two arrays of the same length."""
    first, last = np.floor(lo / size).astype(int), np.floor(hi / size).astype(int)
    origin, wide = first.min(0), last.max(0) - first.min(0) + 1
    spans = last - first + 1
    owner = np.repeat(np.arange(len(lo)), spans.prod(1))
    step = np.arange(len(owner)) - np.repeat(np.cumsum(spans.prod(1)) - spans.prod(1), spans.prod(1))
    column = first[owner, 0] - origin[0] + step % spans[owner, 0]
    square = column + wide[0] * (first[owner, 1] - origin[1] + step // spans[owner, 0])
    order = np.argsort(square, kind='stable')
    square, owner = square[order], owner[order]
    at = np.floor(points / size).astype(int) - origin
    over = ((at >= 0) & (at < wide)).all(1)
    wanted = np.where(over, at[:, 0] + wide[0] * at[:, 1], -1)
    begin = np.searchsorted(square, wanted)
    count = np.searchsorted(square, wanted, 'right') - begin
    which = np.repeat(np.arange(len(points)), count)
    return owner[np.repeat(begin - np.cumsum(count) + count, count) + np.arange(len(which))], which


def over(corners, points):
    """For each point (x, y, z) the triangle over or under it, the nearest in height of several, and its height there.

    Triangles as corners (n x 3 x 3). Number -1 and height NaN where there is none."""
    number, height = np.full(len(points), -1), np.full(len(points), np.nan)
    if not len(corners):
        return number, height
    flat = corners[:, :, :2]
    lo, hi = flat.min(1), flat.max(1)
    triangle, point = raster_pairs(lo, hi, points[:, :2], 2 * np.mean(hi - lo))
    (a, b, c), p = corners[triangle].transpose(1, 0, 2), points[point]
    twice_area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])
    with np.errstate(divide='ignore', invalid='ignore'):
        u = ((p[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (p[:, 1] - a[:, 1])) / twice_area
        v = ((b[:, 0] - a[:, 0]) * (p[:, 1] - a[:, 1]) - (p[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])) / twice_area
    inside = (twice_area != 0) & (u >= -TOUCH) & (v >= -TOUCH) & (u + v <= 1 + TOUCH)
    z = a[:, 2] + u * (b[:, 2] - a[:, 2]) + v * (c[:, 2] - a[:, 2])
    triangle, point, z, off = triangle[inside], point[inside], z[inside], np.abs(z - p[:, 2])[inside]
    order = np.lexsort((off, point))
    found, first = np.unique(point[order], return_index=True)
    number[found], height[found] = triangle[order][first], z[order][first]
    return number, height


def errors(corners, truth):
    """|height of the fill - height of the truth| at each point of the truth; NaN where there is no fill."""
    return np.abs(over(corners, truth)[1] - truth[:, 2])


def patches(corners):
    """For each triangle the number of the patch that it belongs to: triangles connected over equal corners."""
    _, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    index = index.reshape(-1, 3)
    return components(np.vstack([index[:, [0, 1]], index[:, [1, 2]]]), index.max() + 1)[index[:, 0]]
