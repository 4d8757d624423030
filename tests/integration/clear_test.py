#!/usr/bin/python3
"""Levels the canal of real photogrammetry tiles, where it is noisy surface, and holds the output to the promises.

    clear_test.py TILEMEND TOOLS

TOOLS has real_scenes.py and check_city.py, and data beside it. For both levels of detail: the canal is flat within 0.02 m
over 97 % of the polygon, its level is within 0.05 m of the known one, and the triangles that the output lacks are as many
as report.json counts, lie at the polygon and no higher than it says.
Exits 77 (skipped) without the tools, their data or numpy.
"""
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
ROW, LEVEL = 15, 0.905  # the row of the canal's tile; its level, metres
# Its shore, metres in the scene.
CANAL = [[0, 1538], [2.5, 1535.5], [12, 1537.5], [16.5, 1544.5], [19, 1544.5], [23.5, 1540], [30, 1540], [41, 1544], [50, 1543.5],
         [55, 1546], [60, 1544.5], [68.5, 1548.5], [73.5, 1554], [79, 1548], [83, 1550.5], [91, 1551.5], [92.5, 1553.5], [97.5, 1552.5],
         [100, 1555], [100, 1578.5], [96.5, 1581.5], [92.5, 1581.5], [89.5, 1579], [81, 1578], [78.5, 1575], [70.5, 1575],
         [67.5, 1573], [62, 1574.5], [56, 1572], [53, 1568.5], [48.5, 1568.5], [46.5, 1566], [42, 1566.5], [38, 1571], [34.5, 1571],
         [29, 1567], [21.5, 1567], [18.5, 1563.5], [7.5, 1568], [0, 1561]]


def skip(why):
    print('SKIPPED:', why)
    sys.exit(SKIPPED)


def inside(np, points, ring):
    """Whether each of the points lies in the ring, by the even-odd rule."""
    result = np.zeros(len(points), bool)
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        if y0 == y1:
            continue
        crosses = (y0 <= points[:, 1]) != (y1 <= points[:, 1])
        result ^= crosses & (points[:, 0] < x0 + (points[:, 1] - y0) / (y1 - y0) * (x1 - x0))
    return result


def write_polygon(path, origin):
    ring = [[x + origin[0], y + origin[1]] for x, y in CANAL + CANAL[:1]]
    json.dump({'type': 'Feature', 'properties': {'name': 'canal', 'clear': True},
               'crs': {'type': 'name', 'properties': {'name': 'EPSG:4547'}},
               'geometry': {'type': 'Polygon', 'coordinates': [ring]}}, open(path, 'w'))


def lost_triangles(np, before, after):
    """Corners (n x 3 x 3) of the faces of the file `before` that `after` lacks; None if any other line is missing or changed."""
    old, new = (open(path, 'rb').read().split(b'\n') for path in (before, after))
    vertices = np.array([line.split()[1:4] for line in old if line.startswith(b'v ')], float)
    lost, at = [], 0
    for line in old[:-1] if old[-1] == b'' else old:
        if at < len(new) and new[at] == line:
            at += 1
        elif line.startswith(b'f '):
            lost.append([int(corner.split(b'/')[0]) - 1 for corner in line.split()[1:]])
        else:
            return None
    return vertices[np.array(lost, int)]


def check(np, tools, scene, out):
    """What is wrong with the output, as texts."""
    sys.path.insert(0, tools)
    import check_city
    import check_fill
    report = json.load(open(os.path.join(out, 'report.json')))
    name = f'tiles/Tile_+000_{ROW:+04d}.obj'
    before, after = (os.path.join(folder, name) for folder in (scene, out))
    grid = np.stack(np.meshgrid(np.arange(0.1, 100, 0.25), np.arange(1535, 1582, 0.25)), -1).reshape(-1, 2)
    grid = grid[inside(np, grid, CANAL)]
    heights = check_city.over(grid, *check_fill.read(after), 2.)[2]
    lost = lost_triangles(np, before, after)
    if lost is None:
        return ['the output tile lacks more than faces']
    area, = report['cleared']['areas']
    level, = [w['level_m'] for w in report['water'] if w['decided_by'] == 'area']
    flat = float((np.abs(heights - level) <= 0.02).mean())
    print(f'level {level:.3f}, flat over {100 * flat:.1f} %, {len(lost)} triangles taken out')
    faults = []
    if abs(level - LEVEL) > 0.05:
        faults.append(f'the level is {level}, not {LEVEL}')
    if flat < 0.97:
        faults.append(f'flat over {flat:.4f} of the polygon')
    if not len(lost) == area['triangles'] == report['cleared']['triangles']:
        faults.append(f'{len(lost)} triangles are missing, the report counts {report["cleared"]}')
    if (lost[:, :, 2] > area['top_m'] + 1e-4).any():
        faults.append('a triangle is missing that stands higher than the top')
    # A triangle of which a tenth lies in the polygon has one of these points in it.
    share = np.array([(1 - u - v, u, v) for u in np.arange(0.02, 1, 0.05) for v in np.arange(0.02, 1 - u, 0.05)])
    points = np.einsum('sk,nkd->nsd', share, lost[:, :, :2])
    if not inside(np, points.reshape(-1, 2), CANAL).reshape(len(lost), -1).any(1).all():
        faults.append('a triangle is missing that lies outside the polygon')
    return faults


def main():
    tilemend, tools = sys.argv[1:3]
    data = os.path.join(os.path.dirname(tools.rstrip('/')), 'data', 'cc_tiles')
    for needed in (os.path.join(tools, 'real_scenes.py'), os.path.join(tools, 'check_city.py'), data):
        if not os.path.exists(needed):
            skip(f'{needed} is not there; set TILEMEND_SHARED_TOOLS')
    try:
        import numpy as np
    except ImportError as error:
        skip(f'{error}; install python3-numpy')
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for detail in ('city17', 'city18'):
            subprocess.run([sys.executable, os.path.join(tools, 'real_scenes.py'), folder, '--only', detail], check=True)
            scene, out, polygon = (os.path.join(folder, name) for name in (detail, detail + '.out', detail + '.geojson'))
            write_polygon(polygon, json.load(open(os.path.join(scene, 'scene.json')))['origin'])
            run = subprocess.run([tilemend, 'run', scene, '--out', out, '--water', polygon], capture_output=True, text=True)
            if run.returncode not in (0, 100):  # 100: some of the tiles' own holes are left
                sys.exit(f'tilemend run: exit code {run.returncode}\n{run.stdout}{run.stderr}')
            faults += [f'{detail}: {fault}' for fault in check(np, tools, scene, out)]
    sys.exit('\n'.join(faults) or 0)


if __name__ == '__main__':
    main()
