#!/usr/bin/python3
"""Draw a scene and its filled output side by side, from above, as a PNG.

    render.py SCENE OUT picture.png [--width PIXELS] [--grid]
    render.py MESH FILLED picture.png [--width PIXELS]

SCENE is a folder with scene.json, or any folder of tiles; OUT is the output folder of `tilemend run` (the same relative paths, and
tiles of its own for cells that had none). Tiles are .ply or .obj; of others, such as OSGB or 3D Tiles, nothing is drawn. MESH and
FILLED are single files (.ply, .obj or .off), before and after `tilemend fill`. Original surface
is a grey hillshade, holes are dark red, filled triangles (the mark tilemend_filled of the output's files; in OFF, that has no
marks, the faces after those of MESH) are blue; cells that scene.json does not list are white. --grid draws the borders of the
cells. Needs numpy only (Debian: python3-numpy). Exit codes: 2 usage, 3 a path is not there, 4 no triangles or no mesh.
"""
import argparse
import glob
import json
import os
import struct
import sys
import zlib

import numpy as np

NUMBERS = {'char': 'i1', 'int8': 'i1', 'uchar': 'u1', 'uint8': 'u1', 'short': '<i2', 'int16': '<i2', 'ushort': '<u2',
           'uint16': '<u2', 'int': '<i4', 'int32': '<i4', 'uint': '<u4', 'uint32': '<u4', 'float': '<f4',
           'float32': '<f4', 'double': '<f8', 'float64': '<f8'}
NOT_FOUND, INVALID = 3, 4  # exit codes, as of tilemend
OUTSIDE = np.array([255, 255, 255], float)
HOLE = np.array([96, 18, 22], float)
ORIGINAL = np.array([232, 230, 224], float)
FILLED = np.array([104, 164, 236], float)
GAP = 12  # pixels between the two pictures


def ply_header(data, path):
    """Format, [(element, count, [property words])] and where the body begins."""
    end = data.find(b'end_header')
    if not data.startswith(b'ply') or end < 0:
        raise ValueError(f'{path}: no PLY header')
    kind, elements = None, []
    for words in (line.split() for line in data[:end].decode('latin-1').splitlines()):
        if words[:1] == ['format']:
            kind = words[1]
        elif words[:1] == ['element']:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ['property']:
            elements[-1][2].append(words[1:])
    return kind, elements, data.index(b'\n', end) + 1


def ply_record(properties, order, first):
    """The fixed-size record of an element; lists are taken to be as long as in its first record, `first(offset, type)`."""
    fields, offset = [], 0
    for words in properties:
        if words[0] != 'list':
            fields.append((words[1], NUMBERS[words[0]].replace('<', order)))
            offset += np.dtype(fields[-1][1]).itemsize
            continue
        count_type, item_type = (NUMBERS[w].replace('<', order) for w in words[1:3])
        count = int(first(offset, count_type))
        fields += [('n_' + words[3], count_type), (words[3], item_type, (count,))]
        offset += np.dtype(count_type).itemsize + count * np.dtype(item_type).itemsize
    return np.dtype(fields)


def read_ply_binary(data, elements, at, order, path):
    tables = {}
    for name, count, properties in elements:
        if count == 0:
            tables[name] = None
            continue
        record = ply_record(properties, order, lambda offset, kind: np.frombuffer(data, kind, 1, at + offset)[0])
        tables[name] = np.frombuffer(data, record, count, at)
        at += count * record.itemsize
    vertex, face = tables.get('vertex'), tables.get('face')
    if vertex is None:
        return np.zeros((0, 3)), np.zeros((0, 3), int), np.zeros(0, bool)
    points = np.column_stack([vertex[k] for k in 'xyz']).astype(float)
    if face is None:
        return points, np.zeros((0, 3), int), np.zeros(0, bool)
    key = 'vertex_indices' if 'vertex_indices' in face.dtype.names else 'vertex_index'
    if (face['n_' + key] != 3).any():
        raise ValueError(f'{path}: only triangles can be drawn')
    filled = face['tilemend_filled'] != 0 if 'tilemend_filled' in face.dtype.names else np.zeros(len(face), bool)
    return points, face[key].astype(int), filled


def read_ply_ascii(lines, elements):
    points, faces, filled, at = [], [], [], 0
    for name, count, properties in elements:
        rows, at = [line.split() for line in lines[at:at + count]], at + count
        names = [words[-1] for words in properties]
        if name == 'vertex':
            points = [[float(row[names.index(k)]) for k in 'xyz'] for row in rows]
        if name == 'face':  # the list of corners comes first, as everybody writes it
            for row in rows:
                n, rest = int(row[0]), names[1:]
                mark = 'tilemend_filled' in rest and row[1 + n + rest.index('tilemend_filled')] != '0'
                for k in range(2, n):
                    faces.append([int(row[1]), int(row[k]), int(row[k + 1])])
                    filled.append(mark)
    return np.array(points, float).reshape(-1, 3), np.array(faces, int).reshape(-1, 3), np.array(filled, bool)


def read_ply(path):
    with open(path, 'rb') as file:
        data = file.read()
    kind, elements, at = ply_header(data, path)
    if kind == 'ascii':
        return read_ply_ascii([l for l in data[at:].decode('latin-1').splitlines() if l.strip()], elements)
    return read_ply_binary(data, elements, at, '<' if kind == 'binary_little_endian' else '>', path)


def read_obj(path):
    points, faces, filled, mark = [], [], [], False
    with open(path, encoding='latin-1') as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == 'v':
                points.append([float(w) for w in words[1:4]])
            elif words[0] == 'g':
                mark = 'tilemend_filled' in words
            elif words[0] == 'f':
                corners = [int(w.split('/')[0]) for w in words[1:]]
                corners = [c - 1 if c > 0 else len(points) + c for c in corners]
                for k in range(2, len(corners)):
                    faces.append([corners[0], corners[k - 1], corners[k]])
                    filled.append(mark)
    return np.array(points, float).reshape(-1, 3), np.array(faces, int).reshape(-1, 3), np.array(filled, bool)


def read_off(path):
    """The format has no marks: none is filled."""
    with open(path, encoding='latin-1') as file:
        lines = [words for words in (line.split('#')[0].split() for line in file) if words]
    if not lines or not lines[0][0].endswith('OFF'):
        raise ValueError(f'{path}: no OFF header')
    lines = [lines[0][1:], *lines[1:]] if len(lines[0]) > 1 else lines[1:]
    vertices, count = int(lines[0][0]), int(lines[0][1])
    points = np.array([[float(w) for w in words[:3]] for words in lines[1:1 + vertices]]).reshape(-1, 3)
    faces = []
    for words in lines[1 + vertices:1 + vertices + count]:
        corners = [int(w) for w in words[1:1 + int(words[0])]]
        faces += [[corners[0], corners[k - 1], corners[k]] for k in range(2, len(corners))]
    return points, np.array(faces, int).reshape(-1, 3), np.zeros(len(faces), bool)


NOT_DRAWN = ('.osgb', '.b3dm', '.glb', '.gltf', '.stl', '.las', '.laz')
READERS = {'.ply': read_ply, '.obj': read_obj, '.off': read_off}


def read_folder(folder):
    """All tiles below a folder, or one mesh file, as one soup: corner positions (n x 3 x 3) and the mark of each triangle."""
    paths = [folder] if os.path.isfile(folder) else sorted(
        p for pattern in ('*.ply', '*.obj') for p in glob.glob(os.path.join(folder, '**', pattern), recursive=True))
    corners, marks = [np.zeros((0, 3, 3))], [np.zeros(0, bool)]
    for path in paths:
        reader = READERS.get(os.path.splitext(path)[1].lower())
        if reader is None:
            raise ValueError(f'{path}: expected .ply, .obj or .off')
        points, faces, filled = reader(path)
        corners.append(points[faces])
        marks.append(filled)
    return np.concatenate(corners), np.concatenate(marks)


def what_is_missing(path):
    """Why nothing of a path can be drawn, and what to do."""
    others = sorted({ending for _, _, names in os.walk(path) for name in names
                     if (ending := os.path.splitext(name)[1].lower()) in NOT_DRAWN})
    if not others:
        return 'no triangles in .ply or .obj files'
    return (f'has {" and ".join(others)} files, and only .ply and .obj are drawn; let `tilemend run` write the output with '
            '--output-format ply, and draw that twice: render.py OUT OUT picture.png')


def outline(scene, corners):
    """x0, y0, x1, y1 of the picture in metres: the grid's, or without scene.json the bounds of the tiles; and the number of
    columns and rows of cells in it, 1 if it is not known."""
    path = os.path.join(scene, 'scene.json')
    if os.path.exists(path):
        with open(path, encoding='utf-8') as file:
            s = json.load(file)
        cells = np.array([[t['col'], t['row']] for t in s['tiles']])
        size = np.broadcast_to(np.array(s['cell_size'], float), 2)
        corner = np.array(s.get('grid_corner') or [0, 0], float)
        box = np.concatenate([corner + cells.min(0) * size, corner + (cells.max(0) + 1) * size])
        return box, cells.max(0) + 1 - cells.min(0)
    return np.concatenate([corners[:, :, :2].min((0, 1)), corners[:, :, :2].max((0, 1))]), np.array([1, 1])


def paint_outside(image, scene):
    """Paints the cells that scene.json does not list: they lie outside the area and are no holes."""
    path = os.path.join(scene, 'scene.json')
    if not os.path.exists(path):
        return
    with open(path, encoding='utf-8') as file:
        listed = np.array([[t['col'], t['row']] for t in json.load(file)['tiles']])
    low, cells = listed.min(0), listed.max(0) + 1 - listed.min(0)
    is_outside = np.ones(cells[::-1], bool)
    is_outside[tuple((listed - low).T[::-1])] = False
    height, width = image.shape[:2]
    rows = (np.arange(height)[::-1] * cells[1]) // height
    cols = (np.arange(width) * cells[0]) // width
    # Surface that reaches over the border of its cell stays.
    image[is_outside[rows][:, cols] & (image == HOLE).all(2)] = OUTSIDE


def draw_grid(image, cells):
    """Darkens the pixels on the borders between the cells."""
    height, width = image.shape[:2]
    for k in range(1, cells[0]):
        image[:, round(width * k / cells[0])] *= 0.72
    for k in range(1, cells[1]):
        image[round(height * k / cells[1])] *= 0.72


def shades(corners):
    """Lambert light from the north-west at 45 degrees, slopes exaggerated so that gentle terrain shows."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal *= np.where(normal[:, 2:] < 0, -1, 1)
    normal[:, :2] *= 2
    length = np.linalg.norm(normal, axis=1)
    light = np.array([-0.5, 0.5, 0.7071])
    return np.clip(normal @ light / np.where(length > 0, length, 1), 0, 1) * 0.75 + 0.3


def repeated(counts):
    """The number of each group, as often as it has members, and the place of each member in its group."""
    group = np.repeat(np.arange(len(counts)), counts)
    return group, np.arange(len(group)) - (np.cumsum(counts) - counts)[group]


def row_ranges(a, b, y, low, high):
    """Narrows [low, high], the x that a triangle has in row y, by its edge from a to b (n x 2 each)."""
    rise = b[:, 1] - a[:, 1]
    crosses = ((a[:, 1] <= y) & (y <= b[:, 1])) | ((b[:, 1] <= y) & (y <= a[:, 1]))
    steep = np.where(rise != 0, rise, 1)
    x = a[:, 0] + (y - a[:, 1]) / steep * (b[:, 0] - a[:, 0])
    level = crosses & (rise == 0)
    first = np.where(level, np.minimum(a[:, 0], b[:, 0]), x)
    last = np.where(level, np.maximum(a[:, 0], b[:, 0]), x)
    return np.where(crosses, np.minimum(low, first), low), np.where(crosses, np.maximum(high, last), high)


def rasterise(corners, box, shape):
    """The number of the topmost triangle at each pixel's centre, -1 where there is none. A z-buffer over spans of rows."""
    height, width = shape
    scale = np.array([width, height]) / (box[2:] - box[:2])
    xy = (corners[:, :, :2] - box[:2]) * scale - 0.5
    edges = xy[:, 1:] - xy[:, :1]
    area = edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 1, 0] * edges[:, 0, 1]
    low = np.clip(np.ceil(xy[:, :, 1].min(1) - 1e-9), 0, height).astype(int)
    high = np.clip(np.floor(xy[:, :, 1].max(1) + 1e-9), -1, height - 1).astype(int)
    rows = np.where(area != 0, np.maximum(high - low + 1, 0), 0)  # upright triangles cover no pixel
    owner_image, z_image = np.full(width * height, -1), np.full(width * height, -np.inf)
    # In portions of about 4 million pixels, to bound memory.
    reach = np.clip(xy[:, :, 0].max(1), 0, width) - np.clip(xy[:, :, 0].min(1), 0, width)
    starts = np.concatenate([[0], np.cumsum(rows * (reach / 2 + 2))])
    first = 0
    while first < len(corners):
        last = max(first + 1, int(np.searchsorted(starts, starts[first] + 4_000_000, 'right')) - 1)
        draw(xy[first:last], corners[first:last, :, 2], first, low[first:last], rows[first:last], width, owner_image, z_image)
        first = last
    return owner_image.reshape(shape)[::-1]


def draw(xy, z, first, low, rows, width, owner_image, z_image):
    """Draws the triangles from number `first` on: their spans in rows, and the pixels of these."""
    owner, at = repeated(rows)
    y = (low[owner] + at).astype(float)
    begin, end = np.full(len(owner), np.inf), np.full(len(owner), -np.inf)
    for k in range(3):
        begin, end = row_ranges(xy[owner, k], xy[owner, (k + 1) % 3], y, begin, end)
    begin = np.ceil(np.clip(begin, -1, width) - 1e-9).astype(int).clip(0)
    counts = np.maximum(np.floor(np.clip(end, -1, width - 1) + 1e-9).astype(int) - begin + 1, 0)
    # z over the plane of each triangle.
    (bx, by), (cx, cy) = (xy[:, 1] - xy[:, 0]).T, (xy[:, 2] - xy[:, 0]).T
    area = np.where(bx * cy != cx * by, bx * cy - cx * by, 1)
    bz, cz = z[:, 1] - z[:, 0], z[:, 2] - z[:, 0]
    slope_x, slope_y = (bz * cy - cz * by) / area, (cz * bx - bz * cx) / area
    at_begin = z[owner, 0] + slope_x[owner] * (begin - xy[owner, 0, 0]) + slope_y[owner] * (y - xy[owner, 0, 1])
    span, step = repeated(counts)
    pixel = y.astype(int)[span] * width + begin[span] + step
    depth = at_begin[span] + slope_x[owner][span] * step
    seen = np.flatnonzero(depth > z_image[pixel])
    order = seen[np.argsort(depth[seen], kind='stable')]  # of each pixel the highest is written last
    owner_image[pixel[order]], z_image[pixel[order]] = first + owner[span[order]], depth[order]


def picture(corners, marks, box, shape):
    owner = rasterise(corners, box, shape)
    if not len(corners):
        return np.broadcast_to(HOLE, (*shape, 3))
    colours = np.where(marks[:, None], FILLED, ORIGINAL) * shades(corners)[:, None]
    return np.where(owner[..., None] >= 0, np.minimum(colours, 255)[owner], HOLE)


def write_png(path, image):
    height, width = image.shape[:2]
    rows = np.concatenate([np.zeros((height, 1), np.uint8), image.astype(np.uint8).reshape(height, -1)], 1)

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))

    os.makedirs(os.path.dirname(path) or '.', exist_ok=True)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)) +
                   chunk(b'IDAT', zlib.compress(rows.tobytes(), 6)) + chunk(b'IEND', b''))


def halve(image):
    """Means of 2 x 2 pixels: smooth edges."""
    return (image[0::2, 0::2] + image[1::2, 0::2] + image[0::2, 1::2] + image[1::2, 1::2]) / 4


def fail(code, message):
    print(f'render.py: {message}', file=sys.stderr)
    sys.exit(code)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('scene')
    parser.add_argument('out')
    parser.add_argument('picture')
    parser.add_argument('--width', type=int, default=1400, help='of the whole picture, in pixels')
    parser.add_argument('--grid', action='store_true', help='draw the borders of the cells (of a scene.json)')
    a = parser.parse_args()
    for path in (a.scene, a.out):
        if not os.path.exists(path):
            fail(NOT_FOUND, f'{path}: no such file or folder')
    try:
        before, after = read_folder(a.scene), read_folder(a.out)
    except ValueError as error:
        fail(INVALID, str(error))
    for path, soup in ((a.scene, before), (a.out, after)):
        if not len(soup[0]):
            fail(INVALID, f'{path}: {what_is_missing(path)}')
    if a.out.lower().endswith('.off'):
        after[1][len(before[0]):] = True
    box, cells = outline(a.scene, before[0])
    width = 2 * max(1, (a.width - GAP) // 2)
    shape = (2 * max(1, round(width / 2 * (box[3] - box[1]) / (box[2] - box[0]))), width)
    pictures = [np.array(picture(*soup, box, shape)) for soup in (before, after)]
    for image in pictures:
        paint_outside(image, a.scene)
    images = [halve(image) for image in pictures]
    if a.grid:
        for image in images:
            draw_grid(image, cells)
    gap = np.full((images[0].shape[0], GAP, 3), 255.)
    write_png(a.picture, np.concatenate([images[0], gap, images[1]], 1))
    print(f'{a.picture}: {len(before[0])} triangles before, {len(after[0])} after ({int(after[1].sum())} filled)')


if __name__ == '__main__':
    main()
