"""Scenes with images for the coordinator's page: a slope with a lake that is missing, red in the west and green in the east."""
import json
import os
import struct
import zlib

SQUARES, STEP = 12, 10  # squares of a tile along a side, metres of a square


def png():
    """Two columns of pixels: red, green."""
    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
    row = b'\0' + b'\xd0\x20\x20' * 8 + b'\x20\xd0\x20' * 8
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 16, 16, 8, 2, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(row * 16)) + chunk(b'IEND', b''))


def surface(column):
    """Points, their places on the image with v upward, triangles."""
    points, places, faces = [], [], []
    for y in range(SQUARES + 1):
        for x in range(SQUARES + 1):
            at = column * SQUARES + x
            points.append((STEP * at, STEP * y, 2 + 0.2 * at + 0.1 * y))
            places.append((x / SQUARES, y / SQUARES))
    for y in range(SQUARES):
        for x in range(SQUARES):
            if 4 <= x < 8 and 5 <= y < 8:
                continue
            a = y * (SQUARES + 1) + x
            faces += [(a, a + 1, a + SQUARES + 2), (a, a + SQUARES + 2, a + SQUARES + 1)]
    return points, places, faces


def write(path, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'wb' if isinstance(data, bytes) else 'w') as file:
        file.write(data)


def obj_scene(folder):
    """Two tiles; the materials lie in a folder of their own, the images in another."""
    tiles = []
    for column in range(2):
        points, places, faces = surface(column)
        lines = ['mtllib ../materials/all.mtl', 'usemtl ground']
        lines += [f'v {x} {y} {z}' for x, y, z in points] + [f'vt {u} {v}' for u, v in places]
        lines += ['f ' + ' '.join(f'{k + 1}/{k + 1}' for k in face) for face in faces]
        path = f'tiles/t{column}.obj'
        write(os.path.join(folder, path), '\n'.join(lines) + '\n')
        tiles.append({'col': column, 'row': 0, 'path': path})
    write(os.path.join(folder, 'materials/all.mtl'), 'newmtl ground\nKd 1 1 1\nmap_Kd ../images/ground.png\n')
    write(os.path.join(folder, 'images/ground.png'), png())
    write(os.path.join(folder, 'scene.json'), json.dumps(
        {'cell_size': SQUARES * STEP, 'cols': 2, 'rows': 1, 'tiles': tiles}))
    return folder


def glb(points, places, faces):
    views, binary = [], b''
    for data in (b''.join(struct.pack('<3f', x, z, -y) for x, y, z in points),  # y is up
                 b''.join(struct.pack('<2f', u, 1 - v) for u, v in places),
                 b''.join(struct.pack('<3H', *face) for face in faces), png()):
        views.append({'buffer': 0, 'byteOffset': len(binary), 'byteLength': len(data)})
        binary += data + b'\0' * (-len(data) % 4)
    turned = [(x, z, -y) for x, y, z in points]
    document = {
        'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
        'meshes': [{'primitives': [{'attributes': {'POSITION': 0, 'TEXCOORD_0': 1}, 'indices': 2, 'material': 0}]}],
        'materials': [{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}, 'metallicFactor': 0}}],
        'textures': [{'source': 0}], 'images': [{'bufferView': 3, 'mimeType': 'image/png'}],
        'buffers': [{'byteLength': len(binary)}], 'bufferViews': views,
        'accessors': [
            {'bufferView': 0, 'componentType': 5126, 'count': len(points), 'type': 'VEC3',
             'min': [min(p[k] for p in turned) for k in range(3)], 'max': [max(p[k] for p in turned) for k in range(3)]},
            {'bufferView': 1, 'componentType': 5126, 'count': len(places), 'type': 'VEC2'},
            {'bufferView': 2, 'componentType': 5123, 'count': 3 * len(faces), 'type': 'SCALAR'}]}
    text = json.dumps(document).encode()
    text += b' ' * (-len(text) % 4)
    return (struct.pack('<4sII', b'glTF', 2, 28 + len(text) + len(binary)) + struct.pack('<I4s', len(text), b'JSON') + text +
            struct.pack('<I4s', len(binary), b'BIN\0') + binary)


def b3dm(model, centre):
    table = json.dumps({'BATCH_LENGTH': 0, 'RTC_CENTER': centre}).encode()
    table += b' ' * (-(28 + len(table)) % 8)
    return struct.pack('<4sIIIIII', b'b3dm', 1, 28 + len(table) + len(model), len(table), 0, 0, 0) + table + model


def tileset_scene(folder):
    """One tileset with two levels; the finer one is a b3dm about a centre of its own."""
    points, places, faces = surface(0)
    side, centre = SQUARES * STEP, [60.0, 60.0, 0.0]
    box = {'box': [side / 2, side / 2, 4, side / 2, 0, 0, 0, side / 2, 0, 0, 0, 4]}
    write(os.path.join(folder, 'coarse.glb'), glb(points, places, faces))
    moved = [tuple(p[k] - centre[k] for k in range(3)) for p in points]
    write(os.path.join(folder, 'fine/fine.b3dm'), b3dm(glb(moved, places, faces), centre))
    write(os.path.join(folder, 'tileset.json'), json.dumps({
        'asset': {'version': '1.0'}, 'geometricError': 100, 'root': {
            'boundingVolume': box, 'geometricError': 10, 'refine': 'REPLACE', 'content': {'uri': 'coarse.glb'},
            'children': [{'boundingVolume': box, 'geometricError': 0, 'content': {'uri': 'fine/fine.b3dm'}}]}}))
    return folder
