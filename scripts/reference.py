#!/usr/bin/env python3
"""Writes docs/reference.md from what the programs say of themselves: reference.py BIN [--check]

BIN is the folder of the programs. With --check nothing is written; fails where the file is another.
"""
import os
import subprocess
import sys

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'docs', 'reference.md')
HEAD = '''# Reference of all flags

`scripts/reference.py` of the source tree writes this page; a test holds it to the programs. Groups: *everyday* and
*advanced* flags are shown by `--help`, those of *papers* (published methods, for comparison) by `--help-all`. Options of
jobs have the same names, ranges and defaults in the API, with `_` for `-` (`proto/tilemend/v1/job_spec.proto`). Flags
are also read from the environment and a file where the [manual pages](operations.md) say so.
'''


def main():
    parts = [HEAD]
    for program in ('tilemend', 'tilemend-coordinator', 'tilemend-worker'):
        words = [os.path.join(sys.argv[1], program), '--describe', 'markdown']
        parts.append(subprocess.run(words, text=True, check=True, stdout=subprocess.PIPE).stdout)
    text = '\n'.join(parts)
    if '--check' not in sys.argv:
        with open(FILE, 'w', encoding='utf-8') as file:
            file.write(text)
        return
    with open(FILE, encoding='utf-8') as file:
        if file.read() != text:
            sys.exit(f'docs/reference.md is out of date: run scripts/reference.py {sys.argv[1]}')
    print('docs/reference.md: as the programs say')


if __name__ == '__main__':
    main()
