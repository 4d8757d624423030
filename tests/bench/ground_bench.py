#!/usr/bin/env python3
"""Compares the ground filter with the ISPRS reference data (Sithole and Vosselman 2004), as Pingel et al. 2013 do.

    ground_bench.py FOLDER [--program FILE]

FOLDER has samp11.ply, ... (a mesh of the highest points) and samp11_points.npz, ... (xyz; ground: 0 or 1). Prints for each
sample the share of ground taken for objects (type I), of objects taken for ground (type II), of all points (total), and
Cohen's kappa, with the values of the paper and with ours.
"""
import argparse
import glob
import io
import os
import subprocess
import sys

import numpy as np

SETTINGS = {'ours': [], 'the paper\'s single set': ['0.15', '18']}


def flags(program, mesh, points, setting):
    text = io.StringIO()
    np.savetxt(text, points, fmt='%.4f')
    result = subprocess.run([program, mesh, *setting], input=text.getvalue(), capture_output=True, text=True, check=True)
    return np.array([c == '1' for c in result.stdout.strip()])


def figures(ground, on_object):
    n = len(ground)
    a, b = np.sum(ground & ~on_object), np.sum(ground & on_object)
    c, d = np.sum(~ground & ~on_object), np.sum(~ground & on_object)
    agreed, by_chance = (a + d) / n, ((a + b) * (a + c) + (c + d) * (b + d)) / n**2
    return b / (a + b), c / (c + d), (b + c) / n, (agreed - by_chance) / (1 - by_chance)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('folder')
    parser.add_argument('--program', default='build/release/bin/ground_bench')
    args = parser.parse_args()
    meshes = sorted(glob.glob(os.path.join(args.folder, 'samp*.ply')))
    if not meshes:
        sys.exit(f'{args.folder}: no samp*.ply')
    print('| sample | setting | type I | type II | total | kappa |\n|---|---|---|---|---|---|')
    kappas = {}
    for mesh in meshes:
        points = np.load(mesh.replace('.ply', '_points.npz'))
        for name, setting in SETTINGS.items():
            values = figures(points['ground'].astype(bool), flags(args.program, mesh, points['xyz'].astype(float), setting))
            kappas.setdefault(name, []).append(values[3])
            sample = os.path.basename(mesh)[4:6]
            print(f'| {sample} | {name} | ' + ' | '.join(f'{v:.1%}' for v in values) + ' |')
    for name, values in kappas.items():
        print(f'| mean | {name} | | | | {np.mean(values):.1%} |')


if __name__ == '__main__':
    main()
