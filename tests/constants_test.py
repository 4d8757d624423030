#!/usr/bin/env python3
"""Holds the table of docs/constants.md against the sources: each constant has the value there that the page gives.

    constants_test.py ROOT
"""
import os
import re
import sys

ROW = re.compile(r'^\| `(\w+)` \| ([0-9.]+) \| (\S+) \|')


def value_in(source, name):
    """The number that the source gives the name, or None."""
    found = re.search(rf'\b{name} ?= ?([0-9.]+)', source)
    return float(found.group(1)) if found else None


def main():
    root = sys.argv[1]
    page = open(os.path.join(root, 'docs/constants.md'), encoding='utf-8').read()
    rows = [match.groups() for match in map(ROW.match, page.splitlines()) if match]
    faults = [] if len(rows) >= 30 else ['docs/constants.md has lost its table']
    for name, value, path in rows:
        full = os.path.join(root, path)
        found = value_in(open(full, encoding='utf-8').read(), name) if os.path.exists(full) else None
        if found != float(value):
            faults.append(f'{path}: {name} is {found}, docs/constants.md says {value}')
    print('\n'.join(faults) or f'{len(rows)} constants, as in the sources')
    return bool(faults)


if __name__ == '__main__':
    sys.exit(main())
