#!/usr/bin/env python3
"""Runs the cells of examples/python/notebook.ipynb and compares what they print: notebook_test.py BIN PACKAGE [--write]

Pictures are drawn and counted, not compared. --write puts the outputs into the notebook. Exit code 77 (skipped, and says
so) without matplotlib, pandas or GeoPandas.
"""
import ast
import atexit
import base64
import contextlib
import importlib.util
import io
import json
import os
import subprocess
import sys

BIN, PACKAGE = (os.path.abspath(path) for path in sys.argv[1:3])
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
NOTEBOOK = os.path.join(ROOT, 'examples', 'python', 'notebook.ipynb')
LARGEST = 300_000  # bytes


def run(source, names):
    """The outputs of a cell, as Jupyter stores them: what it prints, its pictures, and its last expression."""
    from matplotlib import pyplot
    body = ast.parse(source).body
    last = ast.Expression(body.pop().value) if body and isinstance(body[-1], ast.Expr) else None
    printed, value = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(body, []), NOTEBOOK, 'exec'), names)
        if last:
            value = eval(compile(last, NOTEBOOK, 'eval'), names)
    outputs = []
    if printed.getvalue():
        outputs.append({'name': 'stdout', 'output_type': 'stream', 'text': printed.getvalue().splitlines(True)})
    if value is not None:
        data = {'text/plain': repr(value).splitlines(True)}
        if hasattr(value, '_repr_html_'):
            data['text/html'] = value._repr_html_().splitlines(True)
        outputs.append({'data': data, 'metadata': {}, 'output_type': 'execute_result'})
    for number in pyplot.get_fignums():
        picture = io.BytesIO()
        pyplot.figure(number).savefig(picture, format='png')
        pyplot.close(number)
        outputs.append({'data': {'image/png': base64.b64encode(picture.getvalue()).decode()}, 'metadata': {},
                        'output_type': 'display_data'})
    return outputs


def compared(outputs):
    """The text, and where pictures stand."""
    return [output.get('text') or output['data'].get('text/plain') or sorted(output['data']) for output in outputs]


def end_programs(names):
    """Those that cells started, if a cell failed before the last."""
    for value in names.values():
        if isinstance(value, subprocess.Popen) and value.poll() is None:
            value.terminate()
            value.wait()


def main():
    missing = [name for name in ('matplotlib', 'pandas', 'geopandas') if importlib.util.find_spec(name) is None]
    if missing:
        print(f'SKIPPED: there is no {", ".join(missing)} (Debian: python3-...)')
        sys.exit(77)
    os.environ['PATH'] = f"{BIN}:{os.environ['PATH']}"
    sys.path.insert(0, PACKAGE)
    import matplotlib
    matplotlib.use('Agg')
    with open(NOTEBOOK, encoding='utf-8') as file:
        text = file.read()
    notebook, names, faults, count = json.loads(text), {'__name__': '__main__'}, [], 0
    atexit.register(end_programs, names)
    for cell in notebook['cells']:
        if cell['cell_type'] != 'code':
            continue
        count += 1
        outputs = [dict(output, execution_count=count) if output['output_type'] == 'execute_result' else output
                   for output in run(''.join(cell['source']), names)]
        if compared(outputs) != compared(cell['outputs']):
            faults.append(f'cell {count} gives {compared(outputs)}\nthe notebook has {compared(cell["outputs"])}')
        cell.update(execution_count=count, outputs=outputs)
    if '--write' in sys.argv:
        with open(NOTEBOOK, 'w', encoding='utf-8') as file:
            file.write(json.dumps(notebook, indent=1, ensure_ascii=False) + '\n')
    elif faults or len(text) > LARGEST:
        sys.exit(f'FAILED: {len(text)} bytes, at most {LARGEST}; to renew the notebook, add --write\n' + '\n'.join(faults))
    print(f'{count} cells: passed')


if __name__ == '__main__':
    main()
