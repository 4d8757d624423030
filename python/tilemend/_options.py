"""Options in docstrings and signatures: `help` lists them, and a notebook completes them."""
from __future__ import annotations

import inspect
from typing import Any, Callable, List, Mapping, Sequence, TypeVar

Function = TypeVar('Function', bound=Callable[..., Any])
Row = Mapping[str, str]  # name, expected, default, unit, help

SWITCH = 'true or false'
_PLACE = 'OPTIONS'  # a line of the docstring that the options take the place of


def choices_of(expected: str) -> List[str]:
    """["auto", "a number from 0 to 1000"] of "auto or a number from 0 to 1000"."""
    *first, last = expected.split(' or ')
    return [choice for part in first for choice in part.split(', ')] + [last]


def words_of(row: Row) -> List[str]:
    """Those of the choices that are to be given as they are."""
    return [] if row['expected'] == SWITCH else [
        choice for choice in choices_of(row['expected']) if not choice.startswith(('a number', 'a whole', 'a path', 'text'))]


def is_path(row: Row) -> bool:
    return any(choice.startswith('a path') for choice in choices_of(row['expected']))


def documented(rows: Sequence[Row]) -> Callable[[Function], Function]:
    """Puts the options into a function's docstring and, in place of **options, into its signature."""
    def decorate(function: Function) -> Function:
        if function.__doc__:  # python -OO has none
            lines = function.__doc__.split('\n')
            at = next(i for i, line in enumerate(lines) if line.strip() == _PLACE)
            indent = lines[at][:-len(_PLACE)]
            lines[at:at + 1] = [indent + _line(row) for row in rows]
            function.__doc__ = '\n'.join(lines)
        kept = [p for p in inspect.signature(function).parameters.values() if p.kind != p.VAR_KEYWORD]
        made = [inspect.Parameter(row['name'], inspect.Parameter.KEYWORD_ONLY, default=None) for row in rows]
        setattr(function, '__signature__', inspect.signature(function).replace(parameters=kept + made))
        return function
    return decorate


def _line(row: Row) -> str:
    """'weld: "off" or a number from 1e-12 to 1e9 of the mesh's units, default "off"; merge ...'"""
    words = words_of(row)
    if row['expected'] == SWITCH:
        return f'{row["name"]}: True or False, default False; {row["help"]}'
    choices = [f'"{choice}"' if choice in words else choice.replace(' in UTF-8', '')
               for choice in choices_of(row['expected'])]
    allowed = ' or '.join([', '.join(choices[:-1])] * (len(choices) > 1) + choices[-1:])
    unit = f' {row["unit"]}' if row['unit'] else ''
    default = f'"{row["default"]}"' if row['default'] in words else row['default']
    return f'{row["name"]}: {allowed}{unit}, default {default or "none"}; {row["help"]}'
