"""Jobs and workers as the client shows them."""
from __future__ import annotations

from dataclasses import dataclass, field
from datetime import datetime, timezone
from typing import Any, Literal, Optional, Tuple

from ._tilemend import stages
from .v1 import jobs_pb2

_STAGES = stages()  # those of the programs

JobState = Literal['RUNNING', 'DONE', 'PARTIAL', 'FAILED', 'CANCELLED']
OVER = ('DONE', 'PARTIAL', 'FAILED', 'CANCELLED')


@dataclass(frozen=True)
class Progress:
    """How far a job is. Counts are 0 while not known.

    Attributes:
        stage: what the job does now, in the words of `tilemend run` and the coordinator's page: "look at the tiles".
            "" until it begins.
        phase: the same as the API has it, for programs: "survey", "sample layer 2 of 3", ...
        cells, cells_done: cells of the grid.
        holes, holes_filled: holes.
        triangles: new ones, of the holes that are filled.
        tasks, tasks_done: pieces of work; `tasks` grows while the job runs.
    """

    stage: str
    phase: str
    cells: int
    cells_done: int
    holes: int
    holes_filled: int
    triangles: int
    tasks: int
    tasks_done: int


@dataclass(frozen=True)
class Job:
    """A job at one moment.

    Attributes:
        name: "jobs/ID".
        state: "RUNNING", "DONE", "PARTIAL" (done, but some holes are left), "FAILED" or "CANCELLED".
        scene, out: absolute paths, as the coordinator sees them.
        progress: how far it is.
        message: one line on the outcome; of a failed job why.
        reason: of a failed job, a word for programs; else "".
        report: path of report.json, "" until it is written.
        waiting: why nothing goes on ("no worker is connected"), "" if it does.
        priority: -100 to 100.
        paused: whether none of its tasks is given out.
        warnings: on workers that get no task of it.
        created, ended: times in UTC; `ended` is None while it runs.
    """

    name: str
    state: str
    scene: str
    out: str
    progress: Progress
    message: str
    reason: str
    report: str
    waiting: str
    priority: int
    paused: bool
    warnings: Tuple[str, ...]
    created: Optional[datetime]
    ended: Optional[datetime]
    cursor: int = field(repr=False)

    @property
    def is_over(self) -> bool:
        return self.state in OVER

    @property
    def status(self) -> str:
        """The state as `tilemend list` shows it: "running", "paused", "done", "partial", "failed" or "cancelled"."""
        return 'paused' if self.paused and self.state == 'RUNNING' else self.state.lower()


@dataclass(frozen=True)
class Worker:
    """A worker that calls the coordinator.

    Attributes:
        id: its name.
        state: "WORKING", "DRAINING" or "SET_ASIDE"; `message` says why.
        threads, tasks: tasks that it takes at once, and that it holds.
    """

    id: str
    state: str
    threads: int
    tasks: int
    message: str

    @property
    def status(self) -> str:
        """The state as `tilemend workers` shows it: "working", "idle" (it holds no task), "draining" or "set aside"."""
        return 'idle' if self.state == 'WORKING' and self.tasks == 0 else self.state.lower().replace('_', ' ')


def job_of(job: Any, reason: str) -> Job:
    """Of a v1.Job; `reason` is that of its error."""
    p = job.progress
    progress = Progress(_stage(p.phase), p.phase, p.cells, p.cells_done, p.holes, p.holes_filled, p.triangles, p.tasks, p.tasks_done)
    return Job(job.name, _word(jobs_pb2.JobState, job.state), job.spec.scene, job.spec.out, progress,
               job.error.message or job.message, reason, job.report, job.waiting, job.priority, job.paused,
               tuple(job.warnings), _time(job, 'create_time'), _time(job, 'end_time'), job.cursor)


def worker_of(worker: Any) -> Worker:
    """Of a v1.WorkerInfo."""
    return Worker(worker.id, _word(jobs_pb2.WorkerState, worker.state), worker.threads, worker.tasks, worker.message)


def _stage(phase: str) -> str:
    """The words of a phase. One that is not known stays as it is."""
    return next((words for beginning, words in _STAGES if phase.startswith(beginning)), phase)


def _word(kind: Any, value: int) -> str:
    """The name of a state. A newer coordinator may have one that is not known here."""
    return str(kind.Name(value)) if value in kind.values() else f'STATE_{value}'


def _time(job: Any, name: str) -> Optional[datetime]:
    if not job.HasField(name):
        return None
    return getattr(job, name).ToDatetime().replace(tzinfo=timezone.utc)
