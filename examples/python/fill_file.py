#!/usr/bin/env python3
"""Fills a mesh file in five lines; any format that meshio reads: fill_file.py MESH OUT"""
import sys
import meshio
import tilemend

mesh = meshio.read(sys.argv[1])
filled = tilemend.fill_mesh(mesh, progress=lambda step, done, all_holes: print(f'{step} {done}/{all_holes}', file=sys.stderr))
meshio.write(sys.argv[2], filled)
