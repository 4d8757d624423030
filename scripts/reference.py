#!/usr/bin/env python3
"""Writes docs/reference.md from what the programs say of themselves: reference.py BIN [--check]

BIN is the folder of the programs. With --check nothing is written; fails where the file is another.

A flag that commands share is described once, in the first command of SHARED that has it.
"""
import os
import re
import subprocess
import sys

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'docs', 'reference.md')
HEAD = '''# Reference of all flags

`scripts/reference.py` of the source tree writes this page; a test holds it to the programs. Defaults are in brackets.
`--help` shows everyday and *advanced* flags, `--help-all` also those of *papers*, the published methods. Options of jobs
have the same names in the API, with `_` for `-` (`proto/tilemend/v1/job_spec.proto`). Flags are also read from the
[environment and a file](operations.md#without-containers).
'''
SHARED = ('tilemend', 'tilemend run', 'tilemend get', 'tilemend fill', 'tilemend-coordinator')
MANY = 10  # so many shared flags are given as "all but"


def rows_of(section):
    """[(flag, value, default, group, text)] of the section's table."""
    found = []
    for line in section.splitlines():
        cells = [cell.strip().replace('\\|', '|') for cell in re.split(r'(?<!\\)\|', line)[1:-1]]
        if len(cells) == 5 and cells[0].startswith('`'):
            found.append(tuple(cells))
    return found


def item(row):
    flag, value, default, _, text = row
    names = flag.split(' ')
    names[-1] = names[-1].rstrip('`') + (f' {value}`' if value else '`')
    return f'- {", ".join(names)}{f" ({default})" if default else ""}: {text}'


def listed(rows):
    """The rows by group, each as an item."""
    lines, group = [], 'everyday'
    for row in rows:
        if row[3] != group:
            group = row[3]
            lines.append(f'\n*{group}*\n')
        lines.append(item(row))
    return '\n'.join(lines)


def names_of(rows):
    return ', '.join(row[0].split(' ')[-1] for row in rows)


def link_to(title):
    return f'[{title}](#{title.replace(" ", "-")})'


def shortened(title, rows, tables):
    """The flags of a command, without the text of those that are described with another."""
    own, parts = rows, []
    for other in SHARED:
        if other == title:
            break
        shared = [row for row in own if row in tables[other]]
        if not shared:
            continue
        own = [row for row in own if row not in shared]
        absent = [row for row in tables[other] if row not in shared]
        link = link_to(other)
        if len(shared) > MANY and len(absent) < len(shared):
            parts.append(f'The flags of {link}{f" but {names_of(absent)}" if absent else ""}.')
        else:
            parts.append(f'As of {link}: {names_of(shared)}.')
    return '\n'.join(parts + (['', listed(own)] if own else []))


def page(text):
    sections = [section for section in re.split(r'^(?=##+ )', text, flags=re.MULTILINE) if section.strip()]
    titles = [re.match(r'##+ (.*)', section).group(1) for section in sections]
    tables = {title: rows_of(section) for title, section in zip(titles, sections)}
    parts, alike = [HEAD], []
    for title, section in zip(titles, sections):
        same = re.match(r'##+ .*\n\n(.*) Flags as of `(.*)`\.$', section, re.MULTILINE)
        if same:  # commands with the flags of another are items of one list
            parts += [] if alike else [f'These have the flags of {link_to(same.group(2))}:\n']
            alike = [*alike, f'- {same.group(1)}\n']
            continue
        parts += [''.join(alike)] if alike else []
        alike = []
        section = re.sub(r'\n```sh\n.*?```\n', '', section, flags=re.DOTALL)  # `--help` and the user guide have examples
        if tables[title]:
            table = re.search(r'^\|.*\|\n(?:\|.*\|\n)+', section, re.MULTILINE).group(0)
            section = section.replace(table, shortened(title, tables[title], tables).strip('\n') + '\n')
        parts.append(section.strip('\n') + '\n')
    return '\n'.join(parts)


def main():
    text = ''
    for program in ('tilemend', 'tilemend-coordinator', 'tilemend-worker'):
        words = [os.path.join(sys.argv[1], program), '--describe', 'markdown']
        text += subprocess.run(words, text=True, check=True, stdout=subprocess.PIPE).stdout
    text = page(text)
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
