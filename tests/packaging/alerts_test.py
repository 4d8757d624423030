#!/usr/bin/env python3
"""Holds the alerts to their unit tests, and alerts and dashboard to the metrics that the sources register.

Every alert needs a test in which it fires and one in which it does not. Every metric that an expression names must be
registered by a source. The unit tests themselves need promtool (Debian: prometheus); without it they are skipped, loudly.
"""
import json
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RULES = os.path.join(ROOT, 'deploy/prometheus/tilemend.rules.yml')
TESTS = os.path.join(ROOT, 'deploy/prometheus/tilemend.rules.test.yml')
DASHBOARD = os.path.join(ROOT, 'deploy/grafana/tilemend.json')


def read(path):
    with open(path) as file:
        return file.read()


def registered():
    """All names of metrics in the sources; `prefix + "x"` as the prefix of its file says."""
    names = set()
    for folder in ('common', 'worker', 'coordinator'):
        for base, _, files in os.walk(os.path.join(ROOT, folder)):
            for name in files:
                if not name.endswith('.cc'):
                    continue
                text = read(os.path.join(base, name))
                prefix = re.search(r'prefix = "(\w+)"', text)
                names.update(re.findall(r'"((?:tilemend|process)_\w+)"', text))
                if prefix:
                    names.update(prefix.group(1) + tail for tail in re.findall(r'prefix \+ "(\w+)"', text))
    return names


def main():
    faults, have = [], registered()
    rules, tests = read(RULES), read(TESTS)
    for alert in re.findall(r'alert: (\w+)', rules):
        cases = re.findall(rf'alertname: {alert}\b(\}}?)', tests)
        if len(cases) < 2:
            faults.append(f'{alert}: needs a test in which it fires and one in which it does not')
    with open(DASHBOARD) as file:
        queries = [t['expr'] for p in json.load(file)['panels'] for t in p.get('targets', [])]
    for text in [rules] + queries:
        for name in re.findall(r'\b(?:tilemend|process)_[a-z_]+', text):
            if re.sub('_(bucket|sum|count)$', '', name) not in have:
                faults.append(f'no source registers {name}')
    made = subprocess.run([sys.executable, os.path.join(ROOT, 'deploy/grafana/make_dashboard.py')], text=True,
                          stdout=subprocess.PIPE, check=True).stdout
    if made != read(DASHBOARD):
        faults.append('tilemend.json is not what make_dashboard.py writes')
    if faults:
        sys.exit('\n'.join(faults))
    if not shutil.which('promtool'):
        print('SKIPPED: the unit tests of the alerts need promtool (apt-get install prometheus)')
        sys.exit(77)
    sys.exit(subprocess.run(['promtool', 'test', 'rules', TESTS]).returncode)


if __name__ == '__main__':
    main()
