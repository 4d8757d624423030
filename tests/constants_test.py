#!/usr/bin/env python3
"""Holds the lists of docs/constants.md against the sources: each constant has the value there that the page gives.

    constants_test.py ROOT
"""
import os
import re
import sys

FILE = re.compile(r'^`(\S+)`$')
ITEM = re.compile(r'^- `(\w+)` ([0-9.]+):')


def rows_of(page):
    """(name, value, path) of each item; the path stands above the list."""
    path = None
    for line in page.splitlines():
        file, item = FILE.match(line), ITEM.match(line)
        path = file.group(1) if file else path
        if item:
            yield (*item.groups(), path)


def value_in(source, name):
    """The number that the source gives the name, or None."""
    found = re.search(rf'\b{name} ?= ?([0-9.]+)', source)
    return float(found.group(1)) if found else None


def main():
    root = sys.argv[1]
    page = open(os.path.join(root, 'docs/constants.md'), encoding='utf-8').read()
    rows = list(rows_of(page))
    faults = [] if len(rows) >= 30 else ['docs/constants.md has lost its lists']
    for name, value, path in rows:
        full = os.path.join(root, path)
        found = value_in(open(full, encoding='utf-8').read(), name) if os.path.exists(full) else None
        if found != float(value):
            faults.append(f'{path}: {name} is {found}, docs/constants.md says {value}')
    print('\n'.join(faults) or f'{len(rows)} constants, as in the sources')
    return bool(faults)


if __name__ == '__main__':
    sys.exit(main())
