#!/usr/bin/env python3
"""tilemend.fill beside the command line: fill_test.py BIN PACKAGE

Adapters are tested with the libraries that are installed; the others are named as skipped.
"""
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

BIN, PACKAGE = sys.argv[1:3] if len(sys.argv) > 2 else (None, None)
sys.path.insert(0, PACKAGE)
import tilemend  # noqa: E402
from meshes import plane, ply_bytes, sphere  # noqa: E402

MESHES = {'sphere': sphere, 'plane': plane}


def by_command_line(vertices, faces, *flags):
    """The bytes of the filled file, and the report."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, out = os.path.join(folder, 'mesh.ply'), os.path.join(folder, 'out.ply')
        with open(mesh, 'wb') as file:
            file.write(ply_bytes(vertices, faces))
        done = subprocess.run([os.path.join(BIN, 'tilemend'), 'fill', mesh, '--out', out, '-o', 'json', *flags],
                              stdout=subprocess.PIPE, text=True)
        if done.returncode not in (0, 100):
            raise AssertionError(f'tilemend fill ends with {done.returncode}')
        with open(out, 'rb') as file:
            return file.read(), json.loads(done.stdout)


def without_times(report):
    return {key: value for key, value in report.items() if key not in ('date', 'scene', 'seconds', 'peak_rss_bytes')}


class FillTest(unittest.TestCase):
    def test_equals_the_command_line_to_the_byte(self):
        options = [{}, {'uniform': True, 'tension': 0.5}, {'filler': 'advancing-front-normal'}, {'surface': 'wang'},
                   {'largest_hole': 8, 'fill_outlines': True}, {'weld': 1e-3}, {'water': 'auto'}]
        filled_holes = 0
        for name, make in MESHES.items():
            for dtype in (np.float32, np.float64):
                for given in options:
                    with self.subTest(mesh=name, dtype=dtype.__name__, options=given):
                        vertices, faces = make()
                        vertices = vertices.astype(dtype)
                        flags = [f'--{key.replace("_", "-")}' + ('' if value is True else f'={value}')
                                 for key, value in given.items()]
                        expected, report = by_command_line(vertices, faces, *flags)
                        filled = tilemend.fill(vertices, faces, **given)
                        mark = filled.filled if filled.filled.any() else None
                        self.assertEqual(filled.vertices.dtype, dtype)
                        self.assertEqual(ply_bytes(filled.vertices, filled.faces, mark), expected)
                        self.assertEqual(without_times(filled.report), without_times(report))
                        filled_holes += sum(hole['outcome'] == 'filled' for hole in filled.holes)
        self.assertGreater(filled_holes, 20)

    def test_welds_a_crack_like_the_command_line(self):
        vertices, faces = plane()
        cut = faces[vertices[faces].mean(axis=1)[:, 0] > 30]
        moved = len(vertices) + np.arange(len(vertices))
        faces = np.vstack([faces[vertices[faces].mean(axis=1)[:, 0] <= 30], moved[cut]])
        vertices = np.vstack([vertices, vertices + [1e-4, 0, 0]])
        expected, report = by_command_line(vertices, faces, '--weld', '0.01')
        filled = tilemend.fill(vertices, faces, weld=0.01)
        self.assertEqual(ply_bytes(filled.vertices, filled.faces, filled.filled), expected)
        self.assertGreater(len(report['weld']['welded']), 20)

    def test_takes_out_surface_in_polygons_like_the_command_line(self):
        ring = [[5, 5], [12, 5], [12, 12], [5, 12], [5, 5]]
        areas = {'type': 'FeatureCollection', 'features': [{
            'type': 'Feature', 'properties': {'water': True}, 'geometry': {'type': 'Polygon', 'coordinates': [ring]}}]}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'pond.geojson')
            with open(path, 'w') as file:
                json.dump(areas, file)
            try:
                expected, report = by_command_line(*plane(), '--clear', path, '--water', 'auto')
            except AssertionError as error:
                self.fail(str(error))
            vertices, faces = plane()
            # The program that reads polygons lies beside tilemend, or where the package puts it.
            os.environ['TILEMEND_GDAL'] = os.path.join(BIN, 'tilemend-gdal')
            filled = tilemend.fill(vertices, faces, clear=path, water='auto')
        self.assertEqual(ply_bytes(filled.vertices, filled.faces, filled.filled), expected)
        self.assertGreater(report['cleared']['triangles'], 10)

    def test_the_original_comes_first_and_is_not_changed(self):
        vertices, faces = sphere()
        before = vertices.copy(), faces.copy()
        filled = tilemend.fill(vertices, faces)
        np.testing.assert_array_equal(filled.vertices[:len(vertices)], vertices)
        np.testing.assert_array_equal(filled.faces[:len(faces)], faces)
        np.testing.assert_array_equal(vertices, before[0])
        np.testing.assert_array_equal(faces, before[1])
        self.assertEqual(filled.filled.sum(), len(filled.new_faces))
        self.assertEqual((len(filled.holes), filled.holes[0]['outcome'], filled.left), (1, 'filled', []))

    def test_the_arrays_of_the_result_are_those_of_the_mesh(self):
        vertices, faces = sphere()
        filled = tilemend.fill(vertices, faces)
        copied = tilemend.fill(vertices.astype(np.float32), faces)
        for array in (filled.vertices, filled.faces, copied.faces):
            self.assertEqual(type(array.base).__name__, 'PyCapsule')
            self.assertTrue(array.flags.c_contiguous and array.flags.writeable)
        kept, before = filled.vertices, filled.vertices.copy()
        del filled
        np.testing.assert_array_equal(kept, before)
        self.assertEqual(copied.vertices.dtype, np.float32)

    def test_any_layout_of_the_arrays_gives_the_same(self):
        vertices, faces = sphere()
        expected = tilemend.fill(vertices, faces)
        wide = np.zeros((len(vertices), 7))
        wide[:, 1:7:2] = vertices
        for name, points in {'fortran': np.asfortranarray(vertices), 'strided': wide[:, 1:7:2],
                             'big endian': vertices.astype('>f8'), 'list': vertices.tolist()}.items():
            for corners in (faces.astype(np.int32), faces.astype(np.uint64), faces.astype('>i4'), faces.astype(np.uint16),
                            faces.tolist(), np.asfortranarray(faces)):
                with self.subTest(vertices=name):
                    filled = tilemend.fill(points, corners)
                    self.assertEqual(filled.vertices.tobytes(), expected.vertices.tobytes())
                    self.assertEqual(filled.faces.tobytes(), expected.faces.tobytes())

    def test_integers_become_double_precision(self):
        vertices, faces = plane(side=6, first=2, last=4)
        whole = np.round(10 * vertices) + 0.0  # integers have no -0
        expected = tilemend.fill(whole, faces)
        for points in (whole.astype(np.int32), whole.astype('>i8'), whole.astype(np.int8), whole.astype(int).tolist()):
            filled = tilemend.fill(points, faces)
            self.assertEqual((filled.vertices.dtype, filled.vertices.tobytes()), (np.float64, expected.vertices.tobytes()))

    def test_tells_in_one_line_what_it_is(self):
        self.assertRegex(repr(tilemend.fill(*sphere())), r'^Filled\(1124 vertices, 2178 faces, 66 new, 1 hole filled, 0 left\)$')
        vertices, faces = sphere()
        filled = tilemend.fill(vertices + 5e6, faces, filler='advancing-front-normal', longest_rim=5)
        self.assertRegex(repr(filled), r'^Filled\(.*, 0 new, 0 holes filled, 1 left\)$')

    def test_holes_that_are_longer_than_chosen_are_told_as_left(self):
        filled = tilemend.fill(*sphere(), largest_hole=5)
        self.assertEqual(filled.left, [{'reason': 'longer than largest_hole=5', 'count': 1, 'open_edges': 32}])
        self.assertIn('0 holes filled, 1 left)', repr(filled))
        self.assertEqual(tilemend.fill(*sphere(), largest_hole=50).left, [])

    def test_single_precision_far_from_the_origin_is_told(self):
        vertices, faces = sphere()
        far = vertices + [500000.0, 5000000.0, 0.0]
        self.assertIn('single-precision numbers, 0.5 apart', ' '.join(tilemend.fill(far.astype(np.float32), faces).warnings))
        for exact in (far, vertices.astype(np.float32)):
            self.assertNotIn('single-precision', ' '.join(tilemend.fill(exact, faces).warnings))

    def test_a_mesh_without_holes_stays(self):
        vertices, faces = sphere(hole=0)
        filled = tilemend.fill(vertices, faces)
        self.assertEqual((len(filled.faces), filled.holes, filled.left), (len(faces), [], []))


class ErrorTest(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = plane(side=6, first=2, last=4)

    def expect(self, kind, text, vertices=None, faces=None, **options):
        vertices = self.vertices if vertices is None else vertices
        faces = self.faces if faces is None else faces
        with self.assertRaises(kind) as caught:
            tilemend.fill(vertices, faces, **options)
        self.assertIn(text, str(caught.exception))
        return caught.exception

    def test_says_which_array_and_what_was_expected(self):
        self.expect(TypeError, 'vertices: has dtype bool; expected float32, float64 or integers', self.vertices.astype(bool))
        self.expect(TypeError, 'vertices: has dtype float16', self.vertices.astype(np.float16))
        self.expect(TypeError, 'vertices: has dtype complex128', self.vertices.astype(complex))
        self.expect(TypeError, 'faces: has dtype float64; expected integers', faces=self.faces.astype(float))
        self.expect(TypeError, 'faces: has dtype bool', faces=self.faces.astype(bool))
        self.expect(TypeError, 'faces: has dtype object', faces=self.faces.astype(object))
        self.expect(ValueError, 'vertices: has shape (49, 2); expected (n, 3)', self.vertices[:, :2])
        self.expect(ValueError, 'faces: has shape (192,); expected (m, 3)', faces=self.faces.ravel())
        self.expect(ValueError, 'faces: has shape ()', faces=np.array(3))
        self.expect(ValueError, 'vertices: there are none', np.zeros((0, 3)))
        self.expect(TypeError, 'vertices: cannot be made an array', [[1, 2], [3]])
        self.expect(TypeError, 'faces: has type dict; expected an array of shape (m, 3)', faces={})
        masked = np.ma.masked_array(self.vertices, self.vertices > 3)
        self.expect(ValueError, 'vertices: has masked values; leave these rows out', masked)
        many = np.broadcast_to(np.zeros(3), (2**31, 3))  # 51 GB if it were copied
        self.expect(ValueError, 'vertices: 2147483648 rows; expected at most 2147483647', many)
        self.expect(TypeError, 'progress: has type int; expected a function', progress=3)

    def test_says_which_number_is_wrong(self):
        for number, shown in ((np.nan, 'nan'), (np.inf, 'inf'), (-np.inf, '-inf'), (2e9, '2e+09')):
            vertices = self.vertices.copy()
            vertices[17, 1] = number
            self.expect(tilemend.InvalidInput, f'vertices[17, 1] is {shown}: expected a finite number', vertices)
        for index in (49, -1, 2**31, 2**62):
            faces = self.faces.astype(np.int64)
            faces[5, 2] = index
            error = self.expect(ValueError, f'faces[5, 2] is {index}: expected an index from 0 to 48', faces=faces)
            self.assertIsInstance(error, tilemend.Error)
            self.assertEqual(error.reason, 'INVALID_INPUT')
        self.expect(ValueError, f'faces[0, 0] is {2**64 - 1}', faces=np.full((1, 3), 2**64 - 1, np.uint64))

    def test_every_error_has_a_reason(self):
        for kind in (tilemend.Error, tilemend.InvalidInput, tilemend.NotFound, tilemend.NotAllowed, tilemend.Conflict,
                     tilemend.AlreadyExists, tilemend.TooMuch, tilemend.Unavailable, tilemend.TimedOut, tilemend.Cancelled,
                     tilemend.JobFailed):
            name = 'Other' if kind is tilemend.Error else kind.__name__
            self.assertEqual(kind('why').reason, re.sub('(?<=[a-z])(?=[A-Z])', '_', name).upper())
            self.assertEqual(kind('why', 'INVALID_SPEC').reason, 'INVALID_SPEC')
        with self.assertRaises(tilemend.NotFound) as caught:
            tilemend.read_report('/nowhere')
        self.assertEqual(caught.exception.reason, 'NOT_FOUND')

    def test_checks_options_as_the_command_line_does(self):
        error = self.expect(tilemend.InvalidInput, "gradation '0.5': expected a number from 1 to 10", gradation=0.5)
        self.assertEqual(error.reason, 'INVALID_SPEC')
        self.expect(ValueError, "gradation 'nan': expected a number", gradation=float('nan'))
        self.expect(TypeError, 'gradation: has type bool; expected a number', gradation=True)
        self.expect(TypeError, 'uniform: has type int; expected True or False', uniform=1)
        self.expect(TypeError, 'water: has type bool; expected auto', water=True)
        self.expect(ValueError, 'gradation: uniform', uniform=True, gradation=2)
        self.expect(ValueError, 'tension: the filler minimum-area has none', filler='minimum-area', tension=1)
        self.expect(ValueError, 'gradatoin: there is no such option; did you mean gradation?', gradatoin=2)
        self.expect(ValueError, 'largest: there is no such option; did you mean largest_hole?', largest=5)
        self.expect(ValueError, 'out: arrays have no such option', out='file.ply')
        self.expect(ValueError, 'expected', filler='magic')
        self.expect(TypeError, 'tension: has type list', tension=[1])
        self.expect(ValueError, r"water: '\udcff' is no valid Unicode", water='\udcff')
        uniform = tilemend.fill(self.vertices, self.faces, uniform=np.bool_(True), largest_hole=np.int32(500))
        self.assertEqual(uniform.report['options']['uniform'], True)
        self.expect(tilemend.NotFound, '/no/such/file.geojson', water='/no/such/file.geojson')

    def test_lists_its_options(self):
        rows = {row['name']: row for row in tilemend.options()}
        self.assertEqual(rows['gradation']['expected'], 'a number from 1 to 10')
        self.assertEqual(rows['water']['default'], 'off')
        self.assertNotIn('out', rows)

    def test_the_module_itself_checks_arrays(self):
        from tilemend import _tilemend
        good = np.zeros((3, 3)), np.zeros((1, 3), np.int32)
        for kind, vertices, faces in ((TypeError, good[1], good[1]), (TypeError, good[0], good[0]),
                                      (ValueError, good[0][:, :2], good[1]), (ValueError, good[0][::2], good[1]),
                                      (TypeError, good[0].astype('>f8'), good[1]), (TypeError, None, good[1])):
            with self.assertRaises(kind):
                _tilemend.fill(vertices, faces, {}, None)


def random_array(rng):
    """Anything that a caller might hand over, good or bad."""
    shape = rng.choice([(rng.randrange(12), 3)] * 6 + [(0, 3), (3,), (2, 2), (2, 3, 3), ()])
    dtype = rng.choice(['f4', 'f8', '>f8', 'i1', 'i4', 'u4', 'i8', 'u8', '>i8', 'f2', 'c8', 'O', 'S3', 'M8[s]', '?'])
    raw = np.frombuffer(rng.randbytes(8 * 128), 'u1')
    size = int(np.prod(shape))
    if dtype == 'O':
        return np.full(shape, rng.choice([None, 'x', 1.5]), object)
    kind = rng.random()
    if kind < 0.5 and dtype not in ('S3', 'M8[s]'):
        return (raw[:size] % 12).astype(dtype).reshape(shape)
    made = np.frombuffer(raw.tobytes(), dtype)[:size].reshape(shape)
    return made[::-1] if made.ndim and kind > 0.9 else made


class FuzzTest(unittest.TestCase):
    def test_bad_input_gives_exceptions_and_nothing_else(self):
        rng, filled = random.Random(5), 0
        names = [row['name'] for row in tilemend.options()] + ['x', '']
        values = [None, True, False, 0, 1, -1, 2.5, 1e400, float('nan'), 'auto', '', 'x' * 5000, '\0', b'\xff', [1], {}]
        for _ in range(4000):
            options = {rng.choice(names): rng.choice(values) for _ in range(rng.choice([0, 0, 0, 1, 2]))}
            try:
                vertices = rng.choice([random_array(rng), rng.random() * np.ones((4, 3))])
                tilemend.fill(vertices, random_array(rng), **options)
                filled += 1
            except (TypeError, ValueError, OSError, tilemend.Error) as error:
                self.assertTrue(str(error))
        self.assertGreater(filled, 20)

    def test_random_triangles_are_filled_like_by_the_command_line(self):
        rng = np.random.default_rng(7)
        for _ in range(8):
            vertices = rng.integers(0, 4, (20, 3)).astype(np.float64)
            faces = rng.integers(0, 20, (30, 3))
            expected, _ = by_command_line(vertices, faces)
            filled = tilemend.fill(vertices, faces)
            mark = filled.filled if filled.filled.any() else None
            self.assertEqual(ply_bytes(filled.vertices, filled.faces, mark), expected)


# Fills a hole of many triangles, says so, and tells how it ended.
LONG = '''
import sys, time
sys.path[:0] = {paths!r}
import tilemend
from meshes import plane
vertices, faces = plane(900, 2, 898, 0.01)
try:
    tilemend.fill(vertices, faces, uniform=True, progress=lambda step, *_: print(step, flush=True))
    print('filled')
except KeyboardInterrupt:
    print('interrupted', flush=True)
'''

class LongWorkTest(unittest.TestCase):
    def test_ctrl_c_ends_it_soon(self):
        text = LONG.format(paths=[PACKAGE, os.path.dirname(os.path.abspath(__file__))])
        with subprocess.Popen([sys.executable, '-c', text], stdout=subprocess.PIPE, text=True) as program:
            for line in program.stdout:
                if line.strip() == 'fill':
                    break
            sent = time.monotonic()
            program.send_signal(signal.SIGINT)
            self.assertEqual(program.stdout.read().strip().splitlines()[-1], 'interrupted')
            print(f'ended {time.monotonic() - sent:.2f} s after Ctrl-C')
        self.assertEqual(program.returncode, 0)

    def test_other_threads_run_meanwhile(self):
        vertices, faces = plane(300, 2, 298, 0.01)
        turns, stop = [0], threading.Event()

        def count():
            while not stop.wait(0.001):
                turns[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        began = time.monotonic()
        tilemend.fill(vertices, faces, uniform=True)
        seconds = time.monotonic() - began
        stop.set()
        thread.join()
        self.assertGreater(turns[0], 20 * seconds)

    def test_progress_is_told_and_may_end_the_work(self):
        steps = []
        tilemend.fill(*plane(300, 2, 298, 0.01), uniform=True, progress=lambda *step: steps.append(step))
        self.assertIn(('fill', 0, 1), steps)

        def refuse(*_):
            raise RuntimeError('enough')

        with self.assertRaisesRegex(RuntimeError, 'enough'):
            tilemend.fill(*plane(300, 2, 298, 0.01), uniform=True, progress=refuse)

    def test_several_threads_fill_at_once(self):
        vertices, faces = sphere()
        expected = tilemend.fill(vertices, faces).vertices.tobytes()
        results = []
        threads = [threading.Thread(target=lambda: results.append(tilemend.fill(vertices, faces).vertices.tobytes()))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, [expected] * 4)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
