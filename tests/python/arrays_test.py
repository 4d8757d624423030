#!/usr/bin/env python3
"""What tilemend.fill does with the arrays that come in: arrays_test.py BIN PACKAGE"""
import os
import subprocess
import sys
import tempfile
import threading
import unittest
from multiprocessing import shared_memory

import numpy as np

PACKAGE = sys.argv[2] if len(sys.argv) > 2 else None
sys.path.insert(0, PACKAGE)
import tilemend  # noqa: E402
from meshes import plane, sphere  # noqa: E402

# Prints by how many bytes the process grew at most while it filled.
MEASURED_FILL = r'''
import re, sys
sys.path.insert(0, sys.argv[1])
import numpy as np, tilemend
vertices, faces = np.load(sys.argv[2]), np.load(sys.argv[3])
peak = lambda: 1024 * int(re.search(r'VmHWM:\s+(\d+)', open('/proc/self/status').read()).group(1))
before = peak()
filled = tilemend.fill(vertices, faces)
assert len(filled.holes) == 1 and filled.filled.any(), filled.holes
print(peak() - before, filled.vertices.nbytes + filled.faces.nbytes + filled.filled.nbytes)
'''


def large_plane(is_upright=False):
    """About a million triangles in few steps, with one hole. Upright it is closed in space, not as a height."""
    side, hole = 720, slice(300, 310)
    row, column = np.mgrid[0:side + 1, 0:side + 1]
    vertices = np.stack([column, row, np.sin(column / 4) * np.cos(row / 4)], axis=-1).reshape(-1, 3)
    if is_upright:
        vertices = np.ascontiguousarray(vertices[:, [0, 2, 1]])
    corner = np.arange(len(vertices)).reshape(side + 1, side + 1)[:side, :side]
    kept = np.ones(corner.shape, bool)
    kept[hole, hole] = False
    a = corner[kept]
    return vertices, np.vstack([np.stack([a, a + 1, a + side + 2], axis=-1),
                                np.stack([a, a + side + 2, a + side + 1], axis=-1)])


class InPlaceTest(unittest.TestCase):
    def grown(self, vertices, faces):
        """The most memory beside the arrays that come in and those of the result, in bytes."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ('vertices.npy', 'faces.npy')]
            for path, array in zip(paths, (vertices, faces)):
                np.save(path, array)
            done = subprocess.run([sys.executable, '-c', MEASURED_FILL, PACKAGE, *paths],
                                  stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 0)
        grown, result = map(int, done.stdout.split())
        return grown - result

    def test_the_input_is_not_copied_whatever_its_types(self):
        vertices, faces = large_plane()
        for points in (np.float32, np.float64):
            for corners in (np.int32, np.uint32, np.int64, np.uint64):
                given = vertices.astype(points), faces.astype(corners)
                size = given[0].nbytes + given[1].nbytes
                with self.subTest(vertices=points, faces=corners):
                    grown = self.grown(*given)
                    print(f'{np.dtype(points)}, {np.dtype(corners)}: {size >> 20} MB come in, {grown >> 20} MB beside '
                          'them and the result')
                    self.assertLess(grown, 12 * len(faces) + 24 * len(vertices))

    def test_nor_where_a_hole_is_closed_in_space(self):
        vertices, faces = large_plane(is_upright=True)
        grown = self.grown(vertices, faces)
        print(f'{grown >> 20} MB beside the input and the result')
        self.assertLess(grown, 24 * len(faces) + 24 * len(vertices))


class StrangeArraysTest(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = sphere()
        self.expected = tilemend.fill(self.vertices, self.faces)

    def expect_the_same(self, vertices, faces):
        filled = tilemend.fill(vertices, faces)
        self.assertEqual(filled.vertices.tobytes(), self.expected.vertices.tobytes())
        self.assertEqual(filled.faces.tobytes(), self.expected.faces.tobytes())

    def test_files_that_are_mapped(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ('vertices.npy', 'faces.npy')]
            for path, array in zip(paths, (self.vertices, self.faces)):
                np.save(path, array)
            for mode in ('r', 'r+', 'c'):
                mapped = [np.load(path, mmap_mode=mode) for path in paths]
                self.expect_the_same(*mapped)
                self.expect_the_same(*(np.asarray(array)[:] for array in mapped))
                self.assertEqual(mapped[0].flags.writeable, mode != 'r')

    def test_files_that_another_process_changes_meanwhile(self):
        arrays = plane(300, 2, 298, 0.01)
        expected = tilemend.fill(*arrays)
        for name, wrong in (('faces', 2**30), ('vertices', np.nan)):
            for mode in ('r', 'c'):
                with self.subTest(changed=name, mode=mode), tempfile.TemporaryDirectory() as folder:
                    paths = [os.path.join(folder, f'{name}.npy') for name in ('vertices', 'faces')]
                    for path, array in zip(paths, arrays):
                        np.save(path, array)
                    mapped = [np.load(path, mmap_mode=mode) for path in paths]
                    changed = np.load(os.path.join(folder, f'{name}.npy'), mmap_mode='r+')
                    calls = []

                    def change(*_):
                        calls.append(1)
                        changed[:] = wrong

                    filled = tilemend.fill(*mapped, progress=change)
                    self.assertTrue(calls)
                    self.assertEqual(filled.vertices.tobytes(), expected.vertices.tobytes())
                    self.assertEqual(filled.faces.tobytes(), expected.faces.tobytes())

    def test_memory_that_processes_share_is_copied(self):
        memory = shared_memory.SharedMemory(create=True, size=self.faces.nbytes)
        try:
            faces = np.ndarray(self.faces.shape, self.faces.dtype, memory.buf)
            faces[:] = self.faces
            seen = []
            tilemend.fill(self.vertices, faces, progress=lambda *_: seen.append(faces.flags.writeable))
            self.expect_the_same(self.vertices, faces)
            self.assertTrue(seen and all(seen))
            del faces
        finally:
            memory.close()
            memory.unlink()

    def test_unaligned_arrays(self):
        room = bytearray(self.vertices.nbytes + 1)
        unaligned = np.ndarray(self.vertices.shape, np.float64, room, 1)
        unaligned[:] = self.vertices
        self.expect_the_same(unaligned, self.faces)

    def test_rows_that_are_one_row(self):
        point = np.broadcast_to(np.zeros(3), (50, 3))
        self.assertEqual(len(tilemend.fill(point, np.arange(48).reshape(-1, 3)).vertices), 50)

    def test_subclasses_that_lie_are_read_as_they_are(self):
        class Larger(np.ndarray):
            shape = property(lambda self: (10**9, 3))

        class Wider(np.ndarray):
            dtype = property(lambda self: np.dtype(np.float64))

        class Packed(np.ndarray):
            @property
            def flags(self):
                return np.zeros(3).flags

        self.expect_the_same(self.vertices.view(Larger), self.faces.view(Larger))
        narrow = self.vertices.astype(np.float32)
        self.assertEqual(tilemend.fill(narrow.view(Wider), self.faces).vertices.dtype, np.float32)
        with self.assertRaisesRegex(ValueError, 'row after row in memory'):
            tilemend.fill(np.asfortranarray(self.vertices).view(Packed), self.faces)

    def test_an_array_that_its_caller_lets_go(self):
        held = [self.vertices.copy(), self.faces.copy()]
        filled = tilemend.fill(held.pop(0), held.pop(0), progress=lambda *_: np.full(10**6, np.nan))
        self.assertEqual(filled.vertices.tobytes(), self.expected.vertices.tobytes())


class ReadOnlyTest(unittest.TestCase):
    """Arrays that are read cannot be written to meanwhile."""

    def fill_and_write(self, vertices, faces, write):
        """Fills, and calls `write` while it is at work."""
        def now(*_):
            write()

        return tilemend.fill(vertices, faces, progress=now)

    def test_who_writes_meanwhile_is_refused(self):
        for choose in (0, 1):
            arrays = plane(300, 2, 298, 0.01)

            def write():
                arrays[choose][:] = 10**9

            with self.assertRaisesRegex(ValueError, 'read-only'):
                self.fill_and_write(*arrays, write)
            self.assertTrue(all(array.flags.writeable for array in arrays))

    def test_so_is_who_writes_to_an_array_of_the_same_memory(self):
        class Tracked(np.ndarray):
            pass

        vertices, faces = plane(300, 2, 298, 0.01)
        tracked = vertices.view(Tracked)

        def write():
            self.assertFalse(tracked.flags.writeable or vertices.flags.writeable)
            vertices[0] = 5

        with self.assertRaisesRegex(ValueError, 'read-only'):
            self.fill_and_write(tracked, faces, write)
        self.assertTrue(tracked.flags.writeable and vertices.flags.writeable)

    def test_the_rest_of_an_array_stays_writeable(self):
        vertices, faces = plane(300, 2, 298, 0.01)
        shared = np.vstack([vertices, vertices])
        seen = []
        self.fill_and_write(shared[:len(vertices)], faces, lambda: seen.append(shared.flags.writeable))
        self.assertTrue(seen and all(seen))

    def test_what_was_read_only_stays_so(self):
        vertices, faces = sphere()
        expected = tilemend.fill(vertices, faces)
        vertices.flags.writeable = False
        filled = tilemend.fill(vertices, faces)
        self.assertEqual(filled.vertices.tobytes(), expected.vertices.tobytes())
        self.assertFalse(vertices.flags.writeable)

    def test_views_that_are_made_meanwhile_stay_read_only(self):
        vertices, faces = plane(300, 2, 298, 0.01)
        views = []
        self.fill_and_write(vertices, faces, lambda: views.append(vertices[1:]))
        self.assertTrue(views and not any(view.flags.writeable for view in views))
        views[0].flags.writeable = True
        self.assertTrue(views[0].flags.writeable)

    def test_arrays_that_are_converted_stay_writeable(self):
        vertices, faces = plane(300, 2, 298, 0.01)
        turned = np.asfortranarray(vertices)
        seen = []
        self.fill_and_write(turned, faces, lambda: seen.append(turned.flags.writeable))
        self.assertTrue(seen and all(seen))

    def test_arrays_of_a_result_are_writeable_again(self):
        filled = tilemend.fill(*sphere())
        again = tilemend.fill(filled.vertices, filled.faces)
        self.assertEqual(len(again.holes), 0)
        filled.vertices[0] = 1
        filled.faces[0] = 1

    def test_one_array_serves_several_threads_and_both_arguments(self):
        vertices, faces = plane(300, 2, 298, 0.01)
        seen = []
        threads = [threading.Thread(target=lambda: tilemend.fill(
            vertices, faces, progress=lambda *_: seen.append(vertices.flags.writeable or faces.flags.writeable)))
            for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(seen and not any(seen))
        self.assertTrue(vertices.flags.writeable and faces.flags.writeable)
        numbers = np.array([[0, 1, 2], [1, 0, 2], [0, 2, 1]])
        tilemend.fill(numbers, numbers)
        self.assertTrue(numbers.flags.writeable)

    def test_errors_give_the_arrays_back(self):
        vertices, faces = sphere()
        for wrong in ({'weld': -1}, {'clear': '/nowhere.geojson', 'water': 'auto'}):
            with self.assertRaises(tilemend.Error):
                tilemend.fill(vertices, faces, **wrong)
            self.assertTrue(vertices.flags.writeable and faces.flags.writeable)
        faces[0, 0] = len(vertices)
        with self.assertRaises(tilemend.InvalidInput):
            tilemend.fill(vertices, faces)
        self.assertTrue(vertices.flags.writeable and faces.flags.writeable)

    def test_a_forked_child_may_write(self):
        vertices, faces = plane(300, 2, 298, 0.01)
        codes = []

        def fork():
            if codes:
                return
            child = os.fork()
            if child == 0:
                os._exit(0 if vertices.flags.writeable and faces.flags.writeable else 1)
            codes.append(os.waitpid(child, 0)[1])

        self.fill_and_write(vertices, faces, fork)
        self.assertEqual(codes, [0])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
