#!/usr/bin/env python3
"""Fills a mesh file with a few lines; any format that meshio reads: fill_file.py MESH OUT

meshio 5.0 (Debian 12) cannot read a binary PLY whose faces have a number beside their corners, such as the property
tilemend_filled of filled files ("TypeError: object of type 'numpy.int8' has no len()"). Fill such a file with
`tilemend fill MESH --out OUT`. A PLY that meshio writes does not have the property.
"""
import sys
import meshio
import tilemend

if len(sys.argv) != 3:
    print('Usage: fill_file.py MESH OUT', file=sys.stderr)
    sys.exit(2)
mesh = meshio.read(sys.argv[1])
filled = tilemend.fill_mesh(mesh, progress=lambda step, done, all_holes: print(f'{step} {done}/{all_holes}', file=sys.stderr))
meshio.write(sys.argv[2], filled)
