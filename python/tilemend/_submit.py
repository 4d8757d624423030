"""The start of a job. Checkers read _submit.pyi, which names each option."""
from __future__ import annotations

from typing import Any, Optional

from ._job_options import ROWS
from ._jobs import Job
from ._options import documented
from ._specs import create_request
from ._types import Path


class Submitter:
    """What Client has `submit` from."""

    @documented(ROWS)
    def submit(self, scene: Path, out: Optional[Path] = None, *, priority: int = 0, request_id: Optional[str] = None,
               **options: Any) -> Job:
        """Starts a job.

        Args:
            scene, out: paths as the coordinator and all workers see them; relative ones are of this process's folder.
                Or s3://BUCKET/PREFIX. `out` may be left out with dry_run=True.
            priority: -100 to 100. A job of a higher one goes first.
            request_id: the same id with the same options gives the job that was made the first time.
            **options: as the flags of `tilemend run`, with _ for -. None leaves an option out. Relative paths are of
                this process's folder.

                OPTIONS

        Raises:
            InvalidInput: an option is wrong. NotFound: no such scene. AlreadyExists: the output exists (OUTPUT_EXISTS).
            Conflict: another job writes there (OUTPUT_IN_USE). TooMuch: too many jobs. Unavailable: whether the job was
            made is not known; `metadata['request_id']` of the error, given as request_id, asks again for the same job.
        """
        return self._create(create_request(scene, out, priority, request_id, options))

    def _create(self, request: Any) -> Job:
        raise NotImplementedError
