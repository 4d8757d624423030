#!/usr/bin/env python3
"""tilemend.fill_mesh with meshes of other libraries, and tables, where they are installed: adapters_test.py BIN PACKAGE"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, sys.argv[2])
import tilemend  # noqa: E402
from meshes import sphere  # noqa: E402
from optional_modules import need  # noqa: E402


class AdapterTest(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = sphere()
        self.expected = tilemend.fill(self.vertices, self.faces)

    def test_trimesh(self):
        trimesh = need(self, 'trimesh')
        filled = tilemend.fill_mesh(trimesh.Trimesh(self.vertices, self.faces, process=False))
        self.assertTrue(filled.is_watertight)
        np.testing.assert_array_equal(filled.faces, self.expected.faces)

    def test_meshio(self):
        meshio = need(self, 'meshio')
        filled = tilemend.fill_mesh(meshio.Mesh(self.vertices, [('triangle', self.faces)]))
        np.testing.assert_array_equal(filled.points, self.expected.vertices)
        np.testing.assert_array_equal(filled.cells_dict['triangle'], self.expected.faces)
        self.assertEqual(filled.cell_data['tilemend_filled'][0].sum(), self.expected.filled.sum())
        with self.assertRaisesRegex(ValueError, 'mesh.cells: has quad; expected triangles'):
            tilemend.fill_mesh(meshio.Mesh(self.vertices, [('quad', [[0, 1, 2, 3]])]))

    def test_facts_come_beside_the_mesh(self):
        meshio = need(self, 'meshio')
        mesh, facts = tilemend.fill_mesh(meshio.Mesh(self.vertices, [('triangle', self.faces)]), return_filled=True,
                                         largest_hole=5)
        self.assertEqual((len(mesh.points), facts.left[0]['count']), (len(self.vertices), 1))

    def test_meshio_of_a_class_of_the_users(self):
        meshio = need(self, 'meshio')

        class Survey(meshio.Mesh):
            pass

        filled = tilemend.fill_mesh(Survey(self.vertices, [('triangle', self.faces)]))
        np.testing.assert_array_equal(filled.cells_dict['triangle'], self.expected.faces)

    def test_meshio_from_file_to_file(self):
        meshio = need(self, 'meshio')
        with tempfile.TemporaryDirectory() as folder:
            for ending in ('obj', 'off', 'ply', 'stl', 'vtk', 'vtu'):
                open_, closed = f'{folder}/open.{ending}', f'{folder}/closed.{ending}'
                meshio.write(open_, meshio.Mesh(self.vertices, [('triangle', self.faces)]))
                filled, facts = tilemend.fill_mesh(meshio.read(open_), return_filled=True)
                meshio.write(closed, filled)
                again = meshio.read(closed)
                self.assertEqual((facts.left, len(again.cells_dict['triangle'])), ([], len(self.expected.faces)), ending)

    def open3d_mesh(self, open3d):
        return open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(self.vertices),
                                            open3d.utility.Vector3iVector(self.faces))

    def test_open3d(self):
        open3d = need(self, 'open3d')
        mesh = self.open3d_mesh(open3d)
        filled, facts = tilemend.fill_mesh(mesh, return_filled=True)
        self.assertTrue(filled.is_watertight())
        self.assertEqual(facts.left, [])
        np.testing.assert_array_equal(np.asarray(filled.triangles), self.expected.faces)
        np.testing.assert_array_equal(np.asarray(filled.vertices), self.expected.vertices)
        np.asarray(mesh.vertices)[0] += 1  # its arrays are the caller's again
        with self.assertRaisesRegex(TypeError, r'open3d\..*\.t\.geometry\.TriangleMesh is no '):
            tilemend.fill_mesh(open3d.t.geometry.TriangleMesh.from_legacy(mesh))
        with self.assertRaises(tilemend.InvalidInput):
            tilemend.fill_mesh(open3d.geometry.TriangleMesh())

    def test_open3d_from_file_to_file(self):
        open3d = need(self, 'open3d')
        with tempfile.TemporaryDirectory() as folder:
            mesh = self.open3d_mesh(open3d)
            mesh.compute_vertex_normals()  # which STL needs
            for ending in ('gltf', 'obj', 'off', 'ply', 'stl'):
                self.assertTrue(open3d.io.write_triangle_mesh(f'{folder}/a.{ending}', mesh))
                read = open3d.io.read_triangle_mesh(f'{folder}/a.{ending}')
                if ending == 'stl':  # has a vertex for each corner
                    read.remove_duplicated_vertices()
                filled, facts = tilemend.fill_mesh(read, return_filled=True)
                self.assertEqual((facts.left, filled.is_watertight()), ([], True), ending)

    def test_pyvista(self):
        pyvista = need(self, 'pyvista')
        cells = np.hstack([np.full((len(self.faces), 1), 3), self.faces]).ravel()
        filled = tilemend.fill_mesh(pyvista.PolyData(self.vertices, cells))
        np.testing.assert_array_equal(filled.faces.reshape(-1, 4)[:, 1:], self.expected.faces)
        self.assertEqual(filled.n_open_edges, 0)

    def test_anything_else_is_refused_by_name(self):
        with self.assertRaisesRegex(TypeError, 'builtins.dict is no trimesh.Trimesh, meshio.Mesh'):
            tilemend.fill_mesh({})
        for path in ('a.ply', pathlib.Path('a.ply')):
            with self.assertRaisesRegex(TypeError, 'takes a mesh object, not a path; .*meshio.read'):
                tilemend.fill_mesh(path)

    def test_tables(self):
        need(self, 'pandas')
        table = self.expected.holes_table()
        self.assertEqual(list(table['outcome']), ['filled'])
        self.assertEqual(list(table)[:5], ['column', 'row', 'x', 'y', 'z'])
        self.assertEqual(table.loc[0, 'area_m2'], self.expected.holes[0]['area_m2'])
        without = tilemend.fill(*sphere(hole=0)).holes_table()
        self.assertEqual((len(without), without['area_m2'].sum()), (0, 0))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
