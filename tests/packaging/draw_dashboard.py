#!/usr/bin/env python3
"""Draws the dashboard from Prometheus' real answers: `compose_test.py ... --answers FILE` writes them.

    draw_dashboard.py ANSWERS PICTURE     needs matplotlib (Debian: python3-matplotlib)
"""
import json
import os
import re
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
UNITS = {'ops': '/s', 's': 's', 'Bps': 'B/s', 'percentunit': 'share', 'short': '', 'bytes': 'B'}
MOST_LEGENDS = 6


def legend_of(template, labels):
    return re.sub(r'\{\{(\w+)\}\}', lambda m: labels.get(m.group(1), ''), template).replace('tilemend.v1.', '')


def draw(axes, panel, answers, start):
    shown = 0
    for answer in (a for a in answers if a['panel'] == panel['title']):
        for series in answer['result']:
            times = [t - start for t, _ in series['values']]
            values = [float(v) for _, v in series['values']]
            label = legend_of(answer['legend'], series['metric']) if shown < MOST_LEGENDS else None
            axes.plot(times, values, linewidth=1.4, marker='.', markersize=3, label=label)
            shown += 1
    unit = UNITS[panel['fieldConfig']['defaults']['unit']]
    axes.set_title(panel['title'] + (f' [{unit}]' if unit else ''), fontsize=8, loc='left')
    axes.set_ylim(bottom=0)
    axes.tick_params(labelsize=6)
    axes.grid(alpha=0.25)
    axes.legend(fontsize=5.5, loc='upper left', framealpha=0.6)


def main():
    answers_file, picture = sys.argv[1:3]
    with open(answers_file) as file:
        answers = json.load(file)
    with open(os.path.join(ROOT, 'deploy/grafana/tilemend.json')) as file:
        panels = json.load(file)['panels']
    rows = [p for p in panels if p['type'] == 'row']
    start = min(t for a in answers for s in a['result'] for t, _ in s['values'])
    figure = plt.figure(figsize=(13, 2.3 * len(rows)))
    for at, sub in zip(rows, figure.subfigures(len(rows), 1)):
        sub.suptitle(at['title'], fontsize=9, fontweight='bold', x=0.02, ha='left')
        inside = [p for p in panels if p['type'] != 'row' and p['gridPos']['y'] == at['gridPos']['y'] + 1]
        axes = sub.subplots(1, len(inside))
        sub.subplots_adjust(left=0.03, right=0.99, bottom=0.12, top=0.78, wspace=0.12 if len(inside) < 4 else 0.22)
        for one, panel in zip(axes, inside):
            draw(one, panel, answers, start)
    figure.savefig(picture, dpi=90, metadata={'Software': None})


if __name__ == '__main__':
    main()
