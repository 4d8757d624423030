#!/usr/bin/env python3
"""Fills a scene on a cluster and prints what a person should look at: fill_scene.py HOST:PORT SCENE OUT"""
import sys
import tilemend

if len(sys.argv) != 4:
    print('Usage: fill_scene.py HOST:PORT SCENE OUT', file=sys.stderr)
    sys.exit(2)
address, scene, out = sys.argv[1:]
try:
    with tilemend.Client(address) as client:  # far away: ca=, cert= and key=, or ca= and token_file=
        job = client.submit(scene, out)
        for job in client.watch(job):
            if job.progress.stage:  # empty until the scene is read
                print(f'{job.progress.stage}: {job.progress.holes_filled} of {job.progress.holes} holes', file=sys.stderr)
except tilemend.Error as error:
    sys.exit(f'{error} ({error.reason})')
if not job.report:
    sys.exit(f'{job.name}: {job.state}: {job.message}')
report = tilemend.read_report(out)
for water in report.water:
    print(f"{water['kind']} at {water['level_m']} m, {water['area_m2']:.0f} m2")
for place in report.look_at:
    print(f"look at {place['centre']}: {place['why']}")
print(f'{len(report.holes)} rows of holes, {len(report.left)} left open')
