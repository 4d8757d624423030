#!/usr/bin/env python3
"""Fills the hole of a wavy sheet: fill_arrays.py"""
import numpy as np
import tilemend

# A sheet of 19 x 19 squares, two triangles each, without the 5 x 5 in the middle.
row, column = np.mgrid[0:20, 0:20]
vertices = np.stack([column, row, np.sin(column / 4) * np.cos(row / 4)], axis=-1).reshape(-1, 3)
corner = np.array([20 * r + c for r in range(19) for c in range(19) if not (7 <= r < 12 and 7 <= c < 12)])
faces = np.vstack([np.stack([corner, corner + 1, corner + 21], axis=-1), np.stack([corner, corner + 21, corner + 20], axis=-1)])

filled = tilemend.fill(vertices, faces)
print(f'{len(filled.new_faces)} new faces, {len(filled.vertices) - len(vertices)} new vertices')
for hole in filled.holes:
    print(f"hole {hole['id']}: {hole['area_m2']} m2, {hole['outcome']}, {hole['method']}")
