"""Fills holes of triangle meshes, and follows jobs of tilemend.

    import tilemend
    filled = tilemend.fill(vertices, faces)            # numpy arrays, in this process
    mesh = tilemend.fill_mesh(mesh)                    # of trimesh, meshio, Open3D or PyVista
    with tilemend.Client('127.0.0.1:7070') as client:  # scenes of tiles, on a cluster
        job = client.wait(client.submit('/data/scene', '/data/out'))
    report = tilemend.read_report('/data/out')

The page docs/python.md has more.
"""
from typing import TYPE_CHECKING, Any, List

from ._adapters import fill_mesh
from ._decisions import Decision
from ._errors import (AlreadyExists, Cancelled, Conflict, Error, InvalidInput, JobFailed, NotAllowed, NotFound, TimedOut,
                      TooMuch, Unavailable)
from ._fill import fill, options
from ._filled import Filled
from ._report import Report, read_report
from ._tilemend import RELEASE as __version__

if TYPE_CHECKING:
    from ._client import Client
    from ._jobs import Job, Progress, Worker

_OF_CLIENT = {'Client': '_client', 'Job': '_jobs', 'Progress': '_jobs', 'Worker': '_jobs'}

__all__ = ['AlreadyExists', 'Cancelled', 'Client', 'Conflict', 'Decision', 'Error', 'Filled', 'InvalidInput', 'Job',
           'JobFailed', 'NotAllowed', 'NotFound', 'Progress', 'Report', 'TimedOut', 'TooMuch', 'Unavailable', 'Worker',
           '__version__', 'fill', 'fill_mesh', 'options', 'read_report']


if not TYPE_CHECKING:  # else a checker would take any name for one that is there
    def __getattr__(name: str) -> Any:
        """Loads gRPC when the client is first used: it takes longer than a small mesh."""
        if name not in _OF_CLIENT:
            raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
        import importlib
        return getattr(importlib.import_module('.' + _OF_CLIENT[name], __name__), name)

    def __dir__() -> List[str]:
        return sorted({*globals(), *_OF_CLIENT})
