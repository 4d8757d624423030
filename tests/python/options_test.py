#!/usr/bin/env python3
"""Options of tilemend.fill, fill_mesh and submit, as help, editors and checkers show them: options_test.py BIN PACKAGE

mypy checks types, if it is there.
"""
import importlib.util
import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest

BIN, PACKAGE = sys.argv[1:3] if len(sys.argv) > 2 else (None, None)
sys.path.insert(0, PACKAGE)
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import tilemend  # noqa: E402
from tilemend._job_options import ROWS  # noqa: E402

# A line with a mark is refused with this word in the message; all others are taken.
TYPED = '''
import pathlib
from typing import Any, Dict, List
import numpy as np
import tilemend

v, f = np.zeros((3, 3)), np.zeros((1, 3), np.int32)
filled: tilemend.Filled = tilemend.fill(v, f, tension='auto', water=pathlib.Path('a'), uniform=True, largest_hole=5)
tilemend.fill([[0, 0, 0], (1.5, 2, 3)], f.tolist(), tension=2, progress=lambda step, done, holes: print(step))
more: Dict[str, Any] = {}
tilemend.fill([v[0], v[1]], f, **more)
mesh, facts = tilemend.fill_mesh('a', return_filled=True)
print(mesh.upper(), facts.left, tilemend.fill_mesh(3, weld='off') + 1)
with tilemend.Client('a:1') as c:
    j = c.submit('a', water='auto', dry_run=True, cells='0,0')
    print(c.wait(j, timeout=3, on_progress=print).status)
    jobs: List[tilemend.Job] = c.jobs('RUNNING') + c.jobs(['DONE', 'FAILED'])
r = tilemend.read_report('a')
r.write_decisions('x', {7: 'accept', 8: ('water', 3), 9: None}, overwrite=True)
tilemend.fill(v, f, tensoin=2)  # tensoin
tilemend.fill('a', f)  # "str"
tilemend.fill(v, 3)  # "int"
tilemend.fill(v, f, filler='magic')  # magic
tilemend.fill(v, f, gradation='much')  # "str"
tilemend.fill(v, f, out='a')  # out
tilemend.fill_mesh(v, uniform='yes')  # fill_mesh
c.submit('a', 'b', watr='auto')  # watr
c.jobs('BUSY')  # BUSY
r.write_decisions('x', {7: 'accpt'})  # accpt
r.write_decisions('x', {7: ('ground', 3)})  # ground
'''


class OptionsTest(unittest.TestCase):
    def test_stubs_are_as_the_programs_say(self):
        done = subprocess.run([sys.executable, os.path.join(ROOT, 'scripts/python_stubs.py'), BIN, PACKAGE, '--check'],
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_help_lists_each_option(self):
        for function, rows in ((tilemend.fill, tilemend.options()), (tilemend.fill_mesh, tilemend.options()),
                               (tilemend.Client.submit, ROWS)):
            names = list(inspect.signature(function).parameters)
            self.assertEqual(names[-len(rows):], [row['name'] for row in rows])
            self.assertNotIn('OPTIONS\n', function.__doc__)
            for row in rows:
                self.assertRegex(function.__doc__, rf'\n +{row["name"]}: .*{re.escape(row["unit"])}.*, default .*; '
                                                   rf'{re.escape(row["help"])}\n')
        self.assertIn(' tension: "auto" or a number from 0 to 1000 per m^2, default "auto"; how taut', tilemend.fill.__doc__)
        self.assertIn(' uniform: True or False, default False; keep', tilemend.fill.__doc__)

    def test_checkers_refuse_wrong_options(self):
        if importlib.util.find_spec('mypy') is None:
            print('SKIPPED: test_checkers_refuse_wrong_options: there is no mypy (Debian: mypy)')
            self.skipTest('there is no mypy')
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'typed.py')
            with open(path, 'w', encoding='utf-8') as file:
                file.write(TYPED)
            words = [sys.executable, '-m', 'mypy', '--strict', '--follow-imports=silent', '--hide-error-context',
                     '--cache-dir', os.path.join(folder, 'cache'), path]
            text = subprocess.run(words, text=True, stdout=subprocess.PIPE, env=dict(os.environ, MYPYPATH=PACKAGE)).stdout
        found = {int(number): message for number, message in re.findall(r'typed\.py:(\d+): error: (.*)', text)}
        marks = {number: line.split('  # ')[1] for number, line in enumerate(TYPED.splitlines(), 1) if '  # ' in line}
        self.assertEqual(set(found), set(marks), text)
        for number, mark in marks.items():
            self.assertIn(mark, found[number])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
