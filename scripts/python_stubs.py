#!/usr/bin/env python3
"""Writes what the Python package knows of options, from what the programs say: python_stubs.py BIN PACKAGE [--check]

BIN is the folder of the programs, PACKAGE the one with the built package. Written into python/tilemend: the options of
jobs (_job_options.py), and functions with one typed keyword for each option, for checkers and editors (_fill.pyi,
_adapters.pyi, _submit.pyi). With --check nothing is written; fails where a file is another.
"""
import os
import re
import subprocess
import sys

BIN, PACKAGE = (os.path.abspath(path) for path in sys.argv[1:3])
FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'python', 'tilemend')
NUMBER = r'-?[\d.]+(?:e[+-]?\d+)?'
PATHS = {'FILE', 'DIR'}
HEAD = '# Written by scripts/python_stubs.py; a test holds it to the programs.\n'

sys.path.insert(0, PACKAGE)
import tilemend  # noqa: E402
from tilemend._options import SWITCH, choices_of, words_of  # noqa: E402
from tilemend.v1 import job_spec_pb2  # noqa: E402


def rows_of_jobs():
    """The options of `tilemend submit` that are fields of a v1.JobSpec, in the form of tilemend.options()."""
    fields = job_spec_pb2.JobSpec.DESCRIPTOR.fields_by_name
    text = subprocess.run([os.path.join(BIN, 'tilemend'), '--describe', 'markdown'], text=True, check=True,
                          stdout=subprocess.PIPE).stdout
    table = text.split('\n### tilemend submit\n')[1].split('\n### ')[0]
    rows = []
    for line in table.splitlines():
        cells = [cell.strip().replace('\\|', '|') for cell in re.split(r'(?<!\\)\|', line)]
        if len(cells) != 7 or not cells[1].startswith('`'):
            continue
        name = re.findall(r'--([a-z-]+)', cells[1])[0].replace('-', '_')
        if name in fields and name != 'out':
            rows.append(row_of(name, cells[2], cells[3], cells[5], fields[name]))
    return rows


def row_of(name, shown, default, text, field):
    """`shown`: "auto|FILE", "X", "NAME", or "" of a switch."""
    unit, words = '', [word for word in shown.split('|') if word.islower() and not word.startswith('#')]
    if shown == 'NAME':
        text, names = text.rsplit(': ', 1)
        words = re.split(r', | or ', names)
    choices, place = list(words), [part for part in shown.split('|') if part not in words and part != 'NAME' and part]
    bounds = re.fullmatch(rf'(.*); ({NUMBER}) to ({NUMBER}) ?(.*)', text)
    if place and bounds:
        text, low, high, unit = bounds.groups()
        is_whole = field.cpp_type in (field.CPPTYPE_INT32, field.CPPTYPE_INT64)
        choices.append(f'a {"whole " * is_whole}number from {low} to {high}')
    elif place:
        choices.append('a path in UTF-8' if place[0] in PATHS else 'text')
    expected = ' or '.join([', '.join(choices[:-1])] * (len(choices) > 1) + choices[-1:])
    return {'name': name, 'expected': expected or SWITCH, 'default': default, 'unit': unit, 'help': text}


def type_of(row):
    """As a checker reads it. None leaves an option out."""
    if row['expected'] == SWITCH:
        return 'Optional[bool]'
    words = words_of(row)
    kinds = [f'Literal[{", ".join(map(repr, words))}]'] if words else []
    for choice in choices_of(row['expected']):
        if choice not in words:
            kinds.append({'a number': 'float', 'a whole': 'int', 'a path': 'Path', 'text': 'str'}[' '.join(choice.split()[:2])])
    return f'Optional[{kinds[0]}]' if len(kinds) == 1 else f'Union[{", ".join(kinds)}, None]'


def function(head, more, rows, result):
    """`head`: name and the first parameters; `more`: keywords before the options."""
    indent = ' ' * (len(head) - len(head.lstrip()) + 8)
    lines = [*more, *(f'{row["name"]}: {type_of(row)} = None' for row in rows)]
    return head + '\n' + ''.join(f'{indent}{line},\n' for line in lines) + f'{indent[:-4]}) -> {result}: ...\n'


def files():
    """Texts by name."""
    of_mesh, of_jobs = tilemend.options(), rows_of_jobs()
    rows = ''.join('    {' + ', '.join(f'{key!r}: {row[key]!r}' for key in row) + '},\n' for row in of_jobs)
    progress = 'progress: Optional[FillProgress] = None'
    fill = HEAD + ('from typing import Dict, List, Literal, Optional, Union\n\nfrom ._filled import Filled\n'
                   'from ._types import FillProgress, Path, Rows\n\ndef options() -> List[Dict[str, str]]: ...\n')
    fill += function('def fill(vertices: Rows, faces: Rows, *,', [progress], of_mesh, 'Filled')
    meshes = HEAD + ('from typing import Literal, Optional, Tuple, TypeVar, Union, overload\n\nfrom ._filled import Filled\n'
                     'from ._types import FillProgress, Path\n\nMesh = TypeVar(\'Mesh\')\n\n')
    for value, result in (('Literal[False] = False', 'Mesh'), ('Literal[True]', 'Tuple[Mesh, Filled]')):
        meshes += '@overload\n' + function('def fill_mesh(mesh: Mesh, *,', [f'return_filled: {value}', progress], of_mesh, result)
    submit = HEAD + ('from typing import Literal, Optional, Union\n\nfrom ._jobs import Job\n'
                     'from ._types import Path\n\nclass Submitter:\n')
    submit += function('    def submit(self, scene: Path, out: Optional[Path] = None, *,',
                       ['priority: int = 0', 'request_id: Optional[str] = None'], of_jobs, 'Job')
    return {'_job_options.py': f'{HEAD}"""Options of jobs: rows as those of `tilemend.options()`."""\nROWS = [\n{rows}]\n',
            '_fill.pyi': fill, '_adapters.pyi': meshes, '_submit.pyi': submit}


def main():
    for name, text in files().items():
        path = os.path.join(FOLDER, name)
        if '--check' not in sys.argv:
            with open(path, 'w', encoding='utf-8') as file:
                file.write(text)
            continue
        with open(path, encoding='utf-8') as file:
            if file.read() != text:
                sys.exit(f'{path} is out of date: run scripts/python_stubs.py {BIN} {PACKAGE}')
    print(f'the options in {FOLDER}: as the programs say')


if __name__ == '__main__':
    main()
