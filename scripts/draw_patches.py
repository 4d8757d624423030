#!/usr/bin/python3
"""Draws how holes were divided between the cells, from a filled output.

    draw_patches.py OUT picture.png --box X0,Y0,X1,Y1 [--cell 250] [--width PIXELS]

Edges where patches meet original surface have the colour of the cell that closed on them (the label); edges where the patches of
two cells meet (seams) are black, and the places where labels change (junctions) are rings. Patches are drawn with thin lines, cells
with grey ones, original surface is grey. Needs numpy only (Debian: python3-numpy).
"""
import argparse
import glob
import os
from collections import defaultdict

import numpy as np

import render

COLOURS = np.array([[214, 39, 40], [31, 119, 180], [44, 140, 44], [255, 127, 14]], float)
SURFACE, PATCH, MESH, GRID = (np.array(c, float) for c in ([226, 224, 218], [250, 250, 252], [205, 212, 224], [150, 150, 150]))
FINE = 3  # pixels a pixel, either way, before they are averaged


def patch_edges(points, faces):
    """{(position, position): count} of the triangles' edges, without direction."""
    count = defaultdict(int)
    for face in faces:
        for k in range(3):
            a, b = tuple(points[face[k]]), tuple(points[face[(k + 1) % 3]])
            count[min(a, b), max(a, b)] += 1
    return count


class Canvas:
    def __init__(self, box, width):
        self.box, self.scale = box, FINE * width / (box[2] - box[0])
        self.image = np.tile(SURFACE, (FINE * round((box[3] - box[1]) * self.scale / FINE), FINE * width, 1))

    def pixel(self, p):
        return (p[0] - self.box[0]) * self.scale, (self.box[3] - p[1]) * self.scale

    def near(self, p):
        return self.box[0] - 50 < p[0] < self.box[2] + 50 and self.box[1] - 50 < p[1] < self.box[3] + 50

    def disc(self, x, y, radius, colour, inner=0.0):
        low_x, high_x = max(0, int(x - radius)), min(self.image.shape[1], int(x + radius) + 2)
        low_y, high_y = max(0, int(y - radius)), min(self.image.shape[0], int(y + radius) + 2)
        if low_x >= high_x or low_y >= high_y:
            return
        gy, gx = np.mgrid[low_y:high_y, low_x:high_x]
        d = (gx + .5 - x) ** 2 + (gy + .5 - y) ** 2
        self.image[low_y:high_y, low_x:high_x][(d <= radius ** 2) & (d >= inner ** 2)] = colour

    def line(self, a, b, thick, colour):
        (ax, ay), (bx, by) = self.pixel(a), self.pixel(b)
        steps = max(1, int(np.hypot(bx - ax, by - ay)))
        for k in range(steps + 1):
            self.disc(ax + (bx - ax) * k / steps, ay + (by - ay) * k / steps, thick * FINE / 2, colour)

    def triangle(self, corners, colour):
        p = np.array([self.pixel(c) for c in corners])
        low = np.clip(np.floor(p.min(0)), 0, self.image.shape[1::-1]).astype(int)
        high = np.clip(np.ceil(p.max(0)) + 1, 0, self.image.shape[1::-1]).astype(int)
        gy, gx = np.mgrid[low[1]:high[1], low[0]:high[0]] + .5
        side = [(p[(k + 1) % 3, 0] - p[k, 0]) * (gy - p[k, 1]) - (p[(k + 1) % 3, 1] - p[k, 1]) * (gx - p[k, 0]) for k in range(3)]
        inside = np.all([s <= 0 for s in side], 0) | np.all([s >= 0 for s in side], 0)
        self.image[low[1]:high[1], low[0]:high[0]][inside] = colour

    def averaged(self):
        h, w = self.image.shape[0] // FINE, self.image.shape[1] // FINE
        return self.image.reshape(h, FINE, w, FINE, 3).mean((1, 3))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('out')
    parser.add_argument('picture')
    parser.add_argument('--box', required=True, type=lambda t: [float(n) for n in t.split(',')])
    parser.add_argument('--cell', type=float, default=250)
    parser.add_argument('--width', type=int, default=900)
    return parser.parse_args()


def main():
    a = arguments()
    canvas, closing = Canvas(a.box, a.width), defaultdict(list)  # edge -> cells whose patch it bounds
    inner = []
    for path in sorted(glob.glob(os.path.join(a.out, '**', '*.ply'), recursive=True)):
        points, faces, filled = render.read_ply(path)
        faces = [f for f in faces[filled] if any(canvas.near(points[v]) for v in f)]
        cell = os.path.basename(path)[:-4].split('_')[-2:]
        for f in faces:
            canvas.triangle(points[f], PATCH)
        for edge, count in patch_edges(points, faces).items():
            if count == 1:
                closing[edge].append((int(cell[0]), int(cell[1])))
            else:
                inner.append(edge)
    for edge in inner:
        canvas.line(*edge, 0.7, MESH)
    for k in range(int(a.box[0] // a.cell), int(a.box[2] // a.cell) + 1):
        canvas.line((k * a.cell, a.box[1]), (k * a.cell, a.box[3]), 1, GRID)
    for k in range(int(a.box[1] // a.cell), int(a.box[3] // a.cell) + 1):
        canvas.line((a.box[0], k * a.cell), (a.box[2], k * a.cell), 1, GRID)
    labels = defaultdict(set)
    for edge, cells in closing.items():
        if len(cells) == 1:
            canvas.line(*edge, 3, COLOURS[cells[0][0] % 2 + 2 * (cells[0][1] % 2)])
            for p in edge:
                labels[p].add(cells[0])
    for edge, cells in closing.items():
        if len(cells) == 2:
            canvas.line(*edge, 2.2, np.zeros(3))
            for p in edge:
                canvas.disc(*canvas.pixel(p), 2 * FINE, np.zeros(3))
    for p in (p for p, cells in labels.items() if len(cells) > 1):
        canvas.disc(*canvas.pixel(p), 7 * FINE, np.zeros(3), 5 * FINE)
    render.write_png(a.picture, canvas.averaged())
    print(f'{a.picture}: {len(closing)} edges around patches, {sum(len(c) == 2 for c in closing.values())} of them on seams')


if __name__ == '__main__':
    main()
