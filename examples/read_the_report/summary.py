#!/usr/bin/env python3
"""Prints what became of a scene: summary.py OUT

Reads OUT/report.json, which docs/user-guide.md describes field by field.
"""
import json
import os
import sys

with open(os.path.join(sys.argv[1], 'report.json'), encoding='utf-8') as file:
    report = json.load(file)
holes = [hole for hole in report['per_hole'] if hole['outcome'] != 'not chosen']  # by --cells
filled = [hole for hole in holes if hole['outcome'] == 'filled']
print(f"{len(filled)} of {len(holes)} holes filled, {sum(hole['area_m2'] for hole in filled):.0f} m2")
for body in report['water']:
    sigma = 'given' if body['sigma_m'] is None else f"sigma {body['sigma_m']} m"  # null: a polygon gives the level
    print(f"{body['kind']} at {body['level_m']} m, {body['area_m2']:.0f} m2, {sigma}")
for place in report['look_at']:
    print(f"look at {place['centre']}: {place['why']}")
for left in report['left']:
    print(f"left open in cell {left['cell']}: {left['reason']}")
