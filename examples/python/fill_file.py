#!/usr/bin/env python3
"""Fills a mesh file with a few lines; any format that meshio reads: fill_file.py MESH OUT"""
import sys
import meshio
import tilemend

if len(sys.argv) != 3:
    print('Usage: fill_file.py MESH OUT', file=sys.stderr)
    sys.exit(2)
mesh = meshio.read(sys.argv[1])
filled = tilemend.fill_mesh(mesh, progress=lambda step, done, all_holes: print(f'{step} {done}/{all_holes}', file=sys.stderr))
meshio.write(sys.argv[2], filled)
