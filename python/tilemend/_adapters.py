"""Meshes of other libraries. None of them is imported unless its object comes in."""
from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Tuple

import numpy as np

from ._errors import InvalidInput
from ._fill import fill, options
from ._filled import Filled
from ._options import documented
from ._types import FillProgress

Arrays = Tuple[Any, Any]


@documented(options())
def fill_mesh(mesh: Any, *, return_filled: bool = False, progress: Optional[FillProgress] = None, **options: Any) -> Any:
    """Fills the holes of a mesh object of another library and returns a new one of the same kind.

    Args:
        mesh: a trimesh.Trimesh, a meshio.Mesh with cells "triangle", an open3d.geometry.TriangleMesh, or a
            pyvista.PolyData of triangles. Other cells, other data, colours and textures are not carried over.
        return_filled: returns the `Filled` as well, which tells the holes that are left, warnings and the report.
        progress: as for `fill`.
        **options: as for `fill`.

            OPTIONS

    Returns:
        A mesh of the same kind, with the original vertices and faces first; with `return_filled` a pair of it and the
        `Filled`. meshio and PyVista get the cell data "tilemend_filled": 1 for new faces.

    Raises:
        TypeError: it is none of these.
        As `fill`.
    """
    kind = _kind_of(mesh)
    if isinstance(mesh, (str, bytes, os.PathLike)):
        raise TypeError('fill_mesh takes a mesh object, not a path; read the file first, as with meshio.read; '
                        'examples/python/fill_file.py does it')
    if kind is None:
        raise TypeError(f'{type(mesh).__module__}.{type(mesh).__name__} is no trimesh.Trimesh, meshio.Mesh, '
                        'open3d.geometry.TriangleMesh or pyvista.PolyData; give arrays to tilemend.fill')
    arrays, made = _LIBRARIES[kind]
    filled = fill(*arrays(mesh), progress=progress, **options)
    return (made(mesh, filled), filled) if return_filled else made(mesh, filled)


def _kind_of(mesh: Any) -> Optional[Tuple[str, str]]:
    """The row of _LIBRARIES, by the object's class or one that it is made from."""
    for base in type(mesh).__mro__:
        modules = base.__module__.split('.')
        if (modules[0], base.__name__) in _LIBRARIES and 't' not in modules:  # open3d.t has tensors
            return modules[0], base.__name__
    return None


def _of_trimesh(mesh: Any) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def _to_trimesh(_: Any, filled: Filled) -> Any:
    import trimesh
    return trimesh.Trimesh(vertices=filled.vertices, faces=filled.faces, process=False)


def _of_meshio(mesh: Any) -> Arrays:
    others = sorted({block.type for block in mesh.cells} - {'triangle', 'vertex', 'line'})
    if others:
        raise InvalidInput(f'mesh.cells: has {", ".join(others)}; expected triangles, so cut them first')
    blocks = [np.asarray(block.data).astype(np.int64) for block in mesh.cells if block.type == 'triangle']
    return mesh.points, np.concatenate(blocks) if blocks else np.zeros((0, 3), np.int64)


def _to_meshio(_: Any, filled: Filled) -> Any:
    import meshio
    return meshio.Mesh(filled.vertices, [('triangle', filled.faces)],
                       cell_data={'tilemend_filled': [filled.filled.astype(np.uint8)]})


def _of_open3d(mesh: Any) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def _to_open3d(_: Any, filled: Filled) -> Any:
    import open3d
    utility = open3d.utility
    return open3d.geometry.TriangleMesh(utility.Vector3dVector(filled.vertices.astype(np.float64)),
                                        utility.Vector3iVector(filled.faces))


def _of_pyvista(mesh: Any) -> Arrays:
    cells = np.asarray(mesh.faces)
    if cells.size % 4 or (cells.reshape(-1, 4)[:, 0] != 3).any():
        raise InvalidInput('mesh.faces: not all are triangles; call mesh.triangulate() first')
    return np.asarray(mesh.points), cells.reshape(-1, 4)[:, 1:]


def _to_pyvista(_: Any, filled: Filled) -> Any:
    import pyvista
    cells = np.hstack([np.full((len(filled.faces), 1), 3, np.int64), filled.faces]).ravel()
    made = pyvista.PolyData(filled.vertices, cells)
    made.cell_data['tilemend_filled'] = filled.filled.astype(np.uint8)
    return made


_LIBRARIES: Dict[Tuple[str, str], Tuple[Callable[[Any], Arrays], Callable[[Any, Filled], Any]]] = {
    ('trimesh', 'Trimesh'): (_of_trimesh, _to_trimesh),
    ('meshio', 'Mesh'): (_of_meshio, _to_meshio),
    ('open3d', 'TriangleMesh'): (_of_open3d, _to_open3d),
    ('pyvista', 'PolyData'): (_of_pyvista, _to_pyvista),
}
