"""A client of the coordinator: jobs over gRPC."""
from __future__ import annotations

import ipaddress
import os
import time
import uuid
from typing import Any, Callable, Iterator, List, Optional, Sequence, Tuple, Union

import grpc

from ._errors import Error, InvalidInput, JobFailed, NotFound, TimedOut, Unavailable, from_status, with_keywords
from ._jobs import Job, JobState, Worker, job_of, worker_of
from ._specs import request_of
from ._submit import Submitter
from ._types import Path
from .v1 import error_info_pb2, jobs_pb2, jobs_pb2_grpc

_FIRST_PAUSE_S = 0.2
_LONGEST_PAUSE_S = 2.0
_CONNECTED_S = 30.0  # a call without an answer that lasts so long had a connection; a job may not change for hours
_RECONNECT_S = 600.0  # as `tilemend watch`
_LONGEST_CALL_S = 1e9  # gRPC counts time in 64 bits, as nanoseconds since 1970, which end at 9.2e9 s
_LOST = (grpc.StatusCode.UNAVAILABLE, grpc.StatusCode.RESOURCE_EXHAUSTED)
# As the programs have: a lost machine is noticed within half a minute, and one that is back within a second.
_CHANNEL_OPTIONS = (('grpc.keepalive_time_ms', 20000), ('grpc.keepalive_timeout_ms', 10000),
                    ('grpc.http2.max_pings_without_data', 0), ('grpc.initial_reconnect_backoff_ms', 100),
                    ('grpc.min_reconnect_backoff_ms', 2000), ('grpc.max_reconnect_backoff_ms', 1000),
                    # Else a client of a forked child would share the connections of the parent's clients.
                    ('grpc.use_local_subchannel_pool', 1))
_DETAILS = 'grpc-status-details-bin'
_INFO = 'google.rpc.ErrorInfo'


class Client(Submitter):
    """A connection to a coordinator. Close it, or use it in a `with` statement. Safe from several threads.

    A process that is forked makes a client of its own.

    Args:
        address: "HOST:PORT".
        ca: PEM file with the authority that the coordinator's certificate is of. Without it and without `cert` the
            connection is plain text.
        cert, key: PEM files of this client, for mutual TLS; both or none.
        token, token_file: who calls, in place of a certificate; at most one of the two. The file is read at each call,
            as a token may be replaced.
        insecure: allows plain text to another machine.
        timeout: seconds that one call may take.

    Raises:
        InvalidInput: these do not go together; the text says what is missing.
    """

    def __init__(self, address: str, *, ca: Optional[Path] = None, cert: Optional[Path] = None,
                 key: Optional[Path] = None, token: Optional[str] = None, token_file: Optional[Path] = None,
                 insecure: bool = False, timeout: float = 30.0) -> None:
        _check_security(address, ca, cert, key, token, token_file, insecure)
        self._token, self._token_file = token, token_file
        if token_file is not None:
            self._token = _read_token(token_file)
        _token_metadata(self._token)
        self._timeout, self._is_closed, self._process = timeout, False, os.getpid()
        self._shown = f'{address}, ' + ('plain text' if ca is None and cert is None else 'TLS')
        self._channel = _channel(address, ca, cert, key)
        self._jobs = jobs_pb2_grpc.JobsStub(self._channel)
        self._workers = jobs_pb2_grpc.WorkersStub(self._channel)

    def __repr__(self) -> str:
        return f'Client({self._shown}{", closed" if self._is_closed else ""})'

    def __enter__(self) -> 'Client':
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection. Jobs go on."""
        self._is_closed = True
        if self._process == os.getpid():  # else the connection is the parent's
            self._channel.close()

    def get(self, job: Union[str, Job]) -> Job:
        """The job as it is now. NotFound if there is none.

        Here and below a job is also named by the beginning of its id, if no other begins so.
        """
        return self._call_for(job, self._jobs.GetJob, jobs_pb2.GetJobRequest)

    def jobs(self, states: Union[JobState, Sequence[JobState]] = ()) -> List[Job]:
        """All jobs, newest first, or those in one of `states` ("RUNNING", ...)."""
        return list(self.iter_jobs(states))

    def iter_jobs(self, states: Union[JobState, Sequence[JobState]] = ()) -> Iterator[Job]:
        """As `jobs`, for very many: asks for pages as they are needed, so that the first call fails when it is used."""
        known = jobs_pb2.JobState.keys()
        names: Sequence[str] = [states] if isinstance(states, str) else states
        for state in names:
            if state not in known:
                raise InvalidInput(f'states: {state!r}: expected {", ".join(known[1:])}')
        request = jobs_pb2.ListJobsRequest(states=[jobs_pb2.JobState.Value(state) for state in names])
        return self._pages(request)

    def _pages(self, request: Any) -> Iterator[Job]:
        while True:
            page = self._call(self._jobs.ListJobs, request)
            yield from (_job(job) for job in page.jobs)
            if not page.next_page_token:
                return
            request.page_token = page.next_page_token

    def watch(self, job: Union[str, Job], *, patience: float = _RECONNECT_S) -> Iterator[Job]:
        """The job now and after each change, until it is over. The last one has `is_over`.

        A lost connection is made again, for `patience` seconds after it was lost; then Unavailable is raised.
        """
        return self._watch(_name(job), patience, None)

    def _watch(self, name: str, patience: float, end: Optional[float]) -> Iterator[Job]:
        """`end`: when TimedOut is raised, by time.monotonic()."""
        request = request_of(jobs_pb2.WatchJobRequest, name=name)
        _check_process(self._process)
        give_up, pause = None, _FIRST_PAUSE_S  # no time to give up while there is a connection
        while True:
            begun, metadata = time.monotonic(), self._metadata()
            try:
                for message in self._jobs.WatchJob(request, metadata=metadata, timeout=_seconds_to(end)):
                    request.cursor = message.cursor
                    give_up, pause = None, _FIRST_PAUSE_S
                    state = _job(message)
                    yield state
                    if state.is_over:
                        return
            except ValueError:
                raise _closed() from None
            except grpc.RpcError as error:
                now = time.monotonic()
                if error.code() == grpc.StatusCode.NOT_FOUND and request.name == name:
                    whole = self._whole_name(name)
                    if whole is not None and whole != name:
                        request.name = whole
                        continue
                if end is not None and now >= end:
                    raise _timed_out(name) from None
                if give_up is None or now - begun > _CONNECTED_S:
                    give_up = now + patience
                is_lost = error.code() in _LOST or end is not None and error.code() == grpc.StatusCode.DEADLINE_EXCEEDED
                if not is_lost or now + pause > give_up:
                    raise _error(error) from None
            time.sleep(pause if end is None else max(0.0, min(pause, end - time.monotonic())))
            pause = min(2 * pause, _LONGEST_PAUSE_S)

    def wait(self, job: Union[str, Job], *, timeout: Optional[float] = None,
             on_progress: Optional[Callable[[Job], Any]] = None) -> Job:
        """The job when it is over: "DONE" or "PARTIAL".

        Args:
            job: the job or its name.
            timeout: seconds to wait at most; None: until the end. With 0 it looks once.
            on_progress: called with the job as it is now, and after each change. An exception that it raises ends the
                wait, not the job.

        Raises:
            JobFailed: it failed or was cancelled. TimedOut (a TimeoutError): it is not over yet, and goes on.
            As `watch`.
        """
        if timeout is not None and not timeout >= 0:
            raise InvalidInput(f'timeout: {timeout!r}: expected seconds, 0 or more, or None')
        name = _name(job)
        if timeout == 0:
            states = iter([self.get(name)])
        else:
            states = self._watch(name, _RECONNECT_S, None if timeout is None else time.monotonic() + timeout)
        last = None
        for last in states:
            if on_progress is not None:
                on_progress(last)
        assert last is not None
        return _ended(last)

    def cancel(self, job: Union[str, Job]) -> Job:
        """Ends a job; one that is cancelled stays so. Conflict (JOB_OVER) if it is done or has failed."""
        return self._call_for(job, self._jobs.CancelJob, jobs_pb2.CancelJobRequest)

    def pause(self, job: Union[str, Job]) -> Job:
        """Gives out no task of the job until `resume`."""
        return self._call_for(job, self._jobs.PauseJob, jobs_pb2.PauseJobRequest)

    def resume(self, job: Union[str, Job]) -> Job:
        """Goes on with a paused job."""
        return self._call_for(job, self._jobs.ResumeJob, jobs_pb2.ResumeJobRequest)

    def prioritize(self, job: Union[str, Job], priority: int) -> Job:
        """Gives a job another priority, -100 to 100."""
        return self._call_for(job, self._jobs.PrioritizeJob, jobs_pb2.PrioritizeJobRequest, priority=priority)

    def retry(self, job: Union[str, Job], *, overwrite: bool = False) -> Job:
        """A new job like one that is over. With `overwrite` it may replace a complete output."""
        return self._call_for(job, self._jobs.RetryJob, jobs_pb2.RetryJobRequest, request_id=str(uuid.uuid4()),
                              overwrite=overwrite)

    def workers(self) -> List[Worker]:
        """All workers that call the coordinator, by id."""
        found: List[Worker] = []
        request = jobs_pb2.ListWorkersRequest()
        while True:
            page = self._call(self._workers.ListWorkers, request)
            found += [worker_of(worker) for worker in page.workers]
            if not page.next_page_token:
                return found
            request.page_token = page.next_page_token

    def _create(self, request: Any) -> Job:
        try:
            return _job(self._call(self._jobs.CreateJob, request))
        except Unavailable as error:
            error.metadata['request_id'] = request.request_id
            raise

    def _call_for(self, job: Union[str, Job], method: Any, message: Any, **fields: Any) -> Job:
        """Calls `method` for the job that is named. Only if there is none of that name, for the one that begins so."""
        name = _name(job)
        try:
            return _job(self._call(method, request_of(message, name=name, **fields)))
        except NotFound as error:
            whole = self._whole_name(name) if error.reason == 'JOB_NOT_FOUND' else None
            if whole is None:
                raise
        return _job(self._call(method, request_of(message, name=whole, **fields)))

    def _whole_name(self, beginning: str) -> Optional[str]:
        """Of the only job whose name begins so; None if there is none. InvalidInput if there are several."""
        found = [job.name for job in self.iter_jobs() if job.name.startswith(beginning)]
        if len(found) > 1:
            more = ', ...' if len(found) > 2 else ''
            raise InvalidInput(f'{beginning!r}: several jobs begin so: {found[0]}, {found[1]}{more}')
        return found[0] if found else None

    def _call(self, method: Any, request: Any) -> Any:
        _check_process(self._process)
        metadata = self._metadata()
        try:
            return method(request, timeout=self._timeout, metadata=metadata)
        except grpc.RpcError as error:
            raise _error(error) from None
        except ValueError:
            raise _closed() from None

    def _metadata(self) -> Tuple[Tuple[str, str], ...]:
        """The token as its file has it now. One that is being replaced, or is gone, changes nothing."""
        if self._token_file is not None:
            try:
                token = _read_token(self._token_file)
                _token_metadata(token)
                self._token = token
            except InvalidInput:
                pass
        return _token_metadata(self._token)


def _closed() -> Error:
    """In place of the ValueError that grpc raises."""
    return InvalidInput('the client is closed')


def _check_process(process: int) -> None:
    """`process`: that which made the client."""
    if process != os.getpid():
        raise InvalidInput(f'the client was made by process {process}, before a fork; make a new one in this process')


def _seconds_to(end: Optional[float]) -> Optional[float]:
    return None if end is None else min(max(0.0, end - time.monotonic()), _LONGEST_CALL_S)


def _timed_out(name: str) -> Error:
    return TimedOut(f'{name}: is not over yet; it goes on', '', {'job': name})


def _ended(job: Job) -> Job:
    """The job, if it is over and has an output."""
    if not job.is_over:
        raise _timed_out(job.name)
    if job.state in ('FAILED', 'CANCELLED'):
        why = f': {job.message}' if job.message else ''
        failed = JobFailed(f'{job.name}: {job.state.lower()}{with_keywords(why)}', job.reason)
        failed.job = job
        raise failed
    return job


def _job(job: Any) -> Job:
    info = _info_of(job.error)
    return job_of(job, info.reason if info else '')


def _name(job: Union[str, Job]) -> str:
    name = job.name if isinstance(job, Job) else job
    if not isinstance(name, str):
        hint = '; call this for each of them' if hasattr(job, '__iter__') else ''
        raise TypeError(f'job: has type {type(job).__name__}; expected one Job or its name ("jobs/ID"){hint}')
    return name if name.startswith('jobs/') else f'jobs/{name}'


def _info_of(status: Any) -> Optional[Any]:
    for detail in status.details:
        if detail.type_url.endswith('/' + _INFO):
            return error_info_pb2.ErrorInfo.FromString(detail.value)
    return None


def _error(error: Any) -> Error:
    """The exception of a failed call, with the reason that its trailer has."""
    code, text = error.code(), error.details() or ''
    if code == grpc.StatusCode.DEADLINE_EXCEEDED:
        return Unavailable(f'the coordinator did not answer in time ({text})')
    for key, value in error.trailing_metadata() or ():
        if key == _DETAILS:
            info = _info_of(error_info_pb2.Status.FromString(value))
            if info:
                return from_status(code.value[0], text, info.reason, dict(info.metadata))
    if code == grpc.StatusCode.UNAVAILABLE:
        text = f'cannot reach the coordinator; is it running, and are address, ca, cert and key right? ({text})'
    return from_status(code.value[0], text, '')


def _is_loopback(address: str) -> bool:
    host = address.rsplit(':', 1)[0].strip('[]')
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == 'localhost'


def _check_security(address: str, ca: Optional[Path], cert: Optional[Path], key: Optional[Path], token: Optional[str],
                    token_file: Optional[Path], insecure: bool) -> None:
    for name, text in (('address', address), ('token', '' if token is None else token)):
        if not isinstance(text, str):
            raise TypeError(f'{name}: has type {type(text).__name__}; expected text')
    host, _, port = address.rpartition(':')
    if not host or '/' in host or not port.isdecimal() or not 0 < int(port) < 65536:
        raise InvalidInput(f'address: {address!r}: expected "HOST:PORT"')
    if (cert is None) != (key is None):
        raise InvalidInput(f'{"key" if key is None else "cert"}: is missing; cert and key go together')
    if token is not None and token_file is not None:
        raise InvalidInput('token, token_file: give one of the two')
    is_plain = ca is None and cert is None
    if is_plain and not insecure and not _is_loopback(address):
        what = 'the token' if token or token_file else 'every call'
        raise InvalidInput(f'ca: is missing: without TLS {what} would go to {address} in plain text; give the '
                           'authority\'s certificate as ca, or insecure=True')


def _token_metadata(token: Optional[str]) -> Tuple[Tuple[str, str], ...]:
    if token is None:
        return ()
    if not 0 < len(token) <= 4096 or not all('!' <= letter <= '~' for letter in token):
        raise InvalidInput('token: expected one word of printable ASCII, at most 4096 letters')
    return (('authorization', f'Bearer {token}'),)


def _read_token(path: Path) -> str:
    return _read(path).decode('ascii', 'replace').strip()


def _read(path: Path) -> bytes:
    try:
        with open(path, 'rb') as file:
            return file.read()
    except OSError as error:
        raise InvalidInput(f'{os.fspath(path)}: {error.strerror}') from None


def _channel(address: str, ca: Optional[Path], cert: Optional[Path], key: Optional[Path]) -> Any:
    if ca is None and cert is None:
        return grpc.insecure_channel(address, _CHANNEL_OPTIONS)
    credentials = grpc.ssl_channel_credentials(*(None if path is None else _read(path) for path in (ca, key, cert)))
    return grpc.secure_channel(address, credentials, _CHANNEL_OPTIONS)
