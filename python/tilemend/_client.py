"""A client of the coordinator: jobs over gRPC."""
from __future__ import annotations

import difflib
import ipaddress
import numbers
import os
import time
import uuid
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union

import grpc
from google.protobuf.descriptor import FieldDescriptor

from ._errors import Error, InvalidInput, JobFailed, Unavailable, from_status
from ._jobs import Job, Worker, job_of, worker_of
from .v1 import error_info_pb2, job_spec_pb2, jobs_pb2, jobs_pb2_grpc

Path = Union[str, 'os.PathLike[str]']

_FIRST_PAUSE_S = 0.2
_LONGEST_PAUSE_S = 2.0
_CONNECTED_S = 30.0  # a call without an answer that lasts so long had a connection; a job may not change for hours
_RECONNECT_S = 600.0  # as `tilemend watch`
_LOST = (grpc.StatusCode.UNAVAILABLE, grpc.StatusCode.RESOURCE_EXHAUSTED)
# As the programs have: a lost machine is noticed within half a minute, and one that is back within a second.
_CHANNEL_OPTIONS = (('grpc.keepalive_time_ms', 20000), ('grpc.keepalive_timeout_ms', 10000),
                    ('grpc.http2.max_pings_without_data', 0), ('grpc.initial_reconnect_backoff_ms', 100),
                    ('grpc.min_reconnect_backoff_ms', 2000), ('grpc.max_reconnect_backoff_ms', 1000))
_DETAILS = 'grpc-status-details-bin'
_INFO = 'google.rpc.ErrorInfo'
# By the type of the option's field; all others are numbers.
_KINDS_OF_OPTIONS: Dict[int, Tuple[Any, str]] = {
    FieldDescriptor.CPPTYPE_BOOL: (bool, 'True or False'),
    FieldDescriptor.CPPTYPE_STRING: ((str, os.PathLike), 'text or a path')}


class Client:
    """A connection to a coordinator. Close it, or use it in a `with` statement. Safe from several threads.

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
        self._timeout = timeout
        self._channel = _channel(address, ca, cert, key)
        self._jobs = jobs_pb2_grpc.JobsStub(self._channel)
        self._workers = jobs_pb2_grpc.WorkersStub(self._channel)

    def __enter__(self) -> 'Client':
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection. Jobs go on."""
        self._channel.close()

    def submit(self, scene: Path, out: Optional[Path] = None, *, priority: int = 0, request_id: Optional[str] = None,
               **options: Any) -> Job:
        """Starts a job.

        Args:
            scene, out: paths as the coordinator and all workers see them; relative ones are of this process's folder.
                Or s3://BUCKET/PREFIX. `out` may be left out with dry_run=True.
            priority: -100 to 100. A job of a higher one goes first.
            request_id: the same id with the same options gives the job that was made the first time.
            **options: as the flags of `tilemend run`, with _ for -. None leaves an option out. A relative pathlib.Path
                is of this process's folder; text that is a path begins with /.

        Raises:
            InvalidInput: an option is wrong. NotFound: no such scene. Conflict: the output exists (OUTPUT_EXISTS), or
            another job writes there (OUTPUT_IN_USE). TooMuch: too many jobs. Unavailable: whether the job was made is not
            known; `metadata['request_id']` of the error, given as request_id, asks again for the same job.
        """
        spec = _request(job_spec_pb2.JobSpec, scene=_absolute(scene), out='' if out is None else _absolute(out))
        for name, value in options.items():
            _set(spec, name, value)
        request = _request(jobs_pb2.CreateJobRequest, priority=priority, request_id=request_id or str(uuid.uuid4()))
        request.spec.CopyFrom(spec)
        try:
            return _job(self._call(self._jobs.CreateJob, request))
        except Unavailable as error:
            error.metadata['request_id'] = request.request_id
            raise

    def get(self, job: Union[str, Job]) -> Job:
        """The job as it is now. NotFound if there is none."""
        return _job(self._call(self._jobs.GetJob, _request(jobs_pb2.GetJobRequest, name=_name(job))))

    def jobs(self, states: Sequence[str] = ()) -> Iterator[Job]:
        """All jobs, newest first, or those in one of `states` ("RUNNING", ...). Asks for pages as they are needed."""
        known = jobs_pb2.JobState.keys()
        for state in states:
            if state not in known:
                raise InvalidInput(f'states: {state!r}: expected {", ".join(known[1:])}')
        request = jobs_pb2.ListJobsRequest(states=[jobs_pb2.JobState.Value(state) for state in states])
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
        request = _request(jobs_pb2.WatchJobRequest, name=_name(job))
        give_up, pause = None, _FIRST_PAUSE_S  # no time to give up while there is a connection
        while True:
            begun, metadata = time.monotonic(), self._metadata()
            try:
                for message in self._jobs.WatchJob(request, metadata=metadata):
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
                if give_up is None or now - begun > _CONNECTED_S:
                    give_up = now + patience
                if error.code() not in _LOST or now + pause > give_up:
                    raise _error(error) from None
            time.sleep(pause)
            pause = min(2 * pause, _LONGEST_PAUSE_S)

    def wait(self, job: Union[str, Job]) -> Job:
        """The job when it is over: "DONE" or "PARTIAL". Raises JobFailed if it failed or was cancelled."""
        last = None
        for last in self.watch(job):
            pass
        assert last is not None
        if last.state in ('FAILED', 'CANCELLED'):
            why = f': {last.message}' if last.message else ''
            failed = JobFailed(f'{last.name}: {last.state.lower()}{why}', last.reason)
            failed.job = last
            raise failed
        return last

    def cancel(self, job: Union[str, Job]) -> Job:
        """Ends a job; one that is cancelled stays so. Conflict (JOB_OVER) if it is done or has failed."""
        return _job(self._call(self._jobs.CancelJob, _request(jobs_pb2.CancelJobRequest, name=_name(job))))

    def pause(self, job: Union[str, Job]) -> Job:
        """Gives out no task of the job until `resume`."""
        return _job(self._call(self._jobs.PauseJob, _request(jobs_pb2.PauseJobRequest, name=_name(job))))

    def resume(self, job: Union[str, Job]) -> Job:
        """Goes on with a paused job."""
        return _job(self._call(self._jobs.ResumeJob, _request(jobs_pb2.ResumeJobRequest, name=_name(job))))

    def prioritize(self, job: Union[str, Job], priority: int) -> Job:
        """Gives a job another priority, -100 to 100."""
        request = _request(jobs_pb2.PrioritizeJobRequest, name=_name(job), priority=priority)
        return _job(self._call(self._jobs.PrioritizeJob, request))

    def retry(self, job: Union[str, Job], *, overwrite: bool = False) -> Job:
        """A new job like one that is over. With `overwrite` it may replace a complete output."""
        request = jobs_pb2.RetryJobRequest(name=_name(job), request_id=str(uuid.uuid4()), overwrite=overwrite)
        return _job(self._call(self._jobs.RetryJob, request))

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

    def _call(self, method: Any, request: Any) -> Any:
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


def _job(job: Any) -> Job:
    info = _info_of(job.error)
    return job_of(job, info.reason if info else '')


def _name(job: Union[str, Job]) -> str:
    name = job.name if isinstance(job, Job) else job
    if not isinstance(name, str):
        raise TypeError(f'job: has type {type(job).__name__}; expected a Job or its name')
    return name if name.startswith('jobs/') else f'jobs/{name}'


def _request(kind: Any, **fields: Any) -> Any:
    message = kind()
    for name, value in fields.items():
        _assign(message, name, value)
    return message


def _assign(message: Any, name: str, value: Any) -> None:
    """Sets a field. The error names it."""
    try:
        setattr(message, name, value)
    except TypeError as error:
        raise TypeError(f'{name}: {error}') from None
    except ValueError as error:  # and UnicodeEncodeError
        raise InvalidInput(f'{name}: {error}') from None


def _set(spec: Any, name: str, value: Any) -> None:
    """Sets an option. None leaves it out, and a pathlib.Path is of this process's folder."""
    value = value.item() if type(value).__module__ == 'numpy' and hasattr(value, 'item') else value
    field = spec.DESCRIPTOR.fields_by_name.get(name)
    if field is None or name in ('scene', 'out'):
        near = difflib.get_close_matches(name, set(spec.DESCRIPTOR.fields_by_name) - {'scene', 'out'}, 1)
        hint = f'; did you mean {near[0]}?' if near else ''
        raise InvalidInput(f'{name}: there is no such option{hint}', 'INVALID_SPEC', {'field': name})
    if value is None:
        return
    kind, expected = _KINDS_OF_OPTIONS.get(field.cpp_type, (numbers.Real, 'a number'))
    if not isinstance(value, kind) or isinstance(value, bool) != (kind is bool):
        raise TypeError(f'{name}: has type {type(value).__name__}; expected {expected}')
    _assign(spec, name, _absolute(value) if isinstance(value, os.PathLike) else value)


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


def _absolute(path: Path) -> str:
    """A path of this process's folder as others see it; s3:// and the like stay."""
    text = os.fspath(path)
    if not isinstance(text, str):
        raise TypeError(f'path: has type {type(text).__name__}; expected text')
    if text.startswith('s3:/') and not text.startswith('s3://'):
        raise InvalidInput(f'{text}: a pathlib.Path has no s3://; give text')
    return text.rstrip('/') if '://' in text else os.path.abspath(text)


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
