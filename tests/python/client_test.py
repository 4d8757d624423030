#!/usr/bin/env python3
"""tilemend.Client with a coordinator and a worker, and tilemend.read_report: client_test.py BIN PACKAGE"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from concurrent import futures

import grpc
import numpy as np

BIN, PACKAGE = sys.argv[1:3] if len(sys.argv) > 2 else (None, None)
sys.path.insert(0, PACKAGE)
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import tilemend  # noqa: E402
from tilemend._errors import from_status  # noqa: E402
from tilemend.v1 import jobs_pb2, jobs_pb2_grpc  # noqa: E402


class Cluster:
    """Programs that end with the test. `more`: flags of the coordinator."""

    def __init__(self, test, *more, worker=()):
        self.test = test
        self.folder = tempfile.mkdtemp(prefix='tilemend-python-')
        test.addCleanup(shutil.rmtree, self.folder)
        self.flags, self.worker_flags = more, worker
        self.coordinator, self.address = self.start(
            'tilemend-coordinator', 'listening address=', '--work', f'{self.folder}/work', '--listen', '127.0.0.1:0', *more)

    def start(self, program, awaited, *words):
        process = subprocess.Popen([os.path.join(BIN, program), *words, '--log', 'text'], stderr=subprocess.PIPE, text=True)
        self.test.addCleanup(self.end, process)
        for line in process.stderr:
            if awaited in line:
                return process, line.split(awaited)[1].strip()
        raise AssertionError(f'{program} ended with {process.wait()}')

    @staticmethod
    def end(process):
        process.terminate()
        process.wait()
        process.stderr.close()

    def add_worker(self):
        return self.start('tilemend-worker', 'info connected', '--coordinator', self.address, *self.worker_flags)[0]

    def scene(self, name='scene'):
        path = os.path.join(self.folder, name)
        subprocess.run([os.path.join(BIN, 'tilemend-make-scene'), path, '--cols', '3', '--rows', '2', '--spacing', '5'],
                       check=True, stdout=subprocess.DEVNULL)
        return path


def calls_of_a_child(old, address):
    """What a forked process gets: from a client of its parent, and from one that it makes. One line a call."""
    lines = []
    for call in (old.jobs, lambda: next(old.watch('a'))):
        try:
            call()
        except tilemend.Error as error:
            lines.append(type(error).__name__ + ('' if 'before a fork' in str(error) else f': {error}'))
    old.close()
    try:
        with tilemend.Client(address, timeout=10) as client:
            lines.append(str(client.jobs()))
    except tilemend.Error as error:
        lines.append(f'{type(error).__name__}: {error}')
    return '\n'.join(lines)


def fork_with_a_client(address):
    """Writes calls_of_a_child, then what the parent's client says afterwards."""
    with tilemend.Client(address) as client:
        client.jobs()
        child = os.fork()
        if child == 0:
            try:
                print(calls_of_a_child(client, address), flush=True)
            finally:
                os._exit(0)
        os.waitpid(child, 0)
        print(client.jobs())


class ClientTest(unittest.TestCase):
    def test_a_job_from_its_start_to_its_report(self):
        cluster = Cluster(self)
        scene, out = cluster.scene(), os.path.join(cluster.folder, 'out')
        with tilemend.Client(cluster.address) as client:
            job = client.submit(scene, out, priority=3, gradation=1.5)
            self.assertEqual((job.state, job.scene, job.out, job.priority), ('RUNNING', scene, out, 3))
            self.assertEqual(client.workers(), [])
            self.assertEqual(client.pause(job).status, 'paused')
            self.assertEqual(client.resume(job).status, 'running')
            with self.assertRaisesRegex(TimeoutError, f'{job.name}: is not over yet; it goes on'):
                client.wait(job, timeout=0.2)
            with self.assertRaises(tilemend.TimedOut):
                client.wait(job, timeout=0)
            self.assertEqual(client.prioritize(job, -4).priority, -4)
            cluster.add_worker()
            seen = list(client.watch(job))
            self.assertEqual((seen[-1].state, seen[-1].is_over, seen[-1].report), ('DONE', True, f'{out}/report.json'))
            self.assertEqual(seen[-1].progress.cells, 6)
            self.assertEqual((seen[-1].progress.stage, seen[-1].progress.phase), ('verify the tiles', 'verify'))
            self.assertLess(seen[0].created, seen[-1].ended)
            told = []
            self.assertEqual(client.wait(job.name.split('/')[1], timeout=60, on_progress=told.append), told[-1])
            self.assertEqual((told[-1].state, client.wait(job, timeout=0)), ('DONE', told[-1]))
            self.assertEqual(client.get(job), seen[-1])
            self.assertEqual(client.get(job.name[5:9]), seen[-1])
            self.assertEqual([state.name for state in client.watch(job.name[:9])], [job.name])
            self.assertEqual([job.name], [found.name for found in client.jobs(['DONE'])])
            self.assertEqual(client.jobs('FAILED'), [])
            self.assertEqual([(worker.state, worker.tasks) for worker in client.workers()], [('WORKING', 0)])
            self.assertEqual([worker.status for worker in client.workers()], ['idle'])
            with self.assertRaisesRegex(FileExistsError, 'give overwrite=True to') as caught:
                client.retry(job)
            self.assertEqual((caught.exception.reason, isinstance(caught.exception, tilemend.Conflict)), ('OUTPUT_EXISTS', True))
            again = client.retry(job, overwrite=True)
            self.assertNotEqual(again.name, job.name)
            self.assertEqual(client.wait(again).state, 'DONE')
            with self.assertRaisesRegex(tilemend.InvalidInput, 'jobs/.*: several jobs begin so: jobs/'):
                client._whole_name('jobs/')
            self.check_report(out)
            self.check_decisions(client, scene, out)

    def check_report(self, out):
        report = tilemend.read_report(out)
        others = {'per_hole': 'holes'}
        for name, value in report.data.items():  # each list is an attribute
            if isinstance(value, list):
                self.assertEqual(getattr(report, others.get(name, name)), value, name)
        self.assertEqual(report.cleared, report['cleared'])
        self.assertEqual(report.levels, report.data.get('levels', []))
        self.assertEqual(report['options']['gradation'], 1.5)
        self.assertEqual(report.path, os.path.join(out, 'report.json'))
        self.assertEqual(len(report.holes), len(report['per_hole']))
        self.assertGreater(len(report.holes), 3)
        self.assertEqual(tilemend.read_report(report.path).data, report.data)
        try:
            table = report.holes_table()
            self.assertEqual(len(table), len(report.holes))
            self.assertEqual(set(table['column']), {hole['cell'][0] for hole in report.holes})
            self.assertEqual(list(report.review_table().index), [item['hole'] for item in report.review])
        except ImportError as error:
            print(f'SKIPPED: table of the holes: {error}')
        try:
            holes = report.holes_map()
            self.assertEqual(set(holes['hole']), {hole['id'] for hole in report.holes})
            self.assertGreater(holes.geometry.area.sum(), 100)
        except ImportError as error:
            print(f'SKIPPED: map of the holes: {error}')

    def check_decisions(self, client, scene, out):
        report = tilemend.read_report(out)
        self.assertRegex(repr(report), r"^Report\('.*/out/report.json': \d+ holes filled, 0 left, \d+ to review\)$")
        first, second = report.review[:2]
        path = os.path.join(out, '..', 'decisions.geojson')
        report.write_decisions(path, {first['hole']: ('water', 1.25), second['hole']: 'open'})
        job = client.wait(client.submit(scene, out, gradation=1.5, decisions=os.path.relpath(path)))
        self.assertEqual(job.state, 'DONE')
        report = tilemend.read_report(out)
        decided = {hole['id']: (hole['decision'], hole.get('level_m')) for hole in report.holes if 'decision' in hole}
        self.assertEqual(decided, {**dict.fromkeys(first['holes'], ('water', 1.25)),
                                   **dict.fromkeys(second['holes'], ('open', None))})
        # What was decided before stays, unless it is decided anew or taken back.
        marks = {second['hole']: None, report.review[0]['hole']: 'accept'}
        with self.assertRaisesRegex(FileExistsError, 'decisions.geojson: exists already; choose another path, or give over'):
            report.write_decisions(path, marks)
        report.write_decisions(path, marks, overwrite=True)
        with open(path, encoding='utf-8') as file:
            rows = [feature['properties'] for feature in json.load(file)['features']]
        self.assertEqual({row['hole']: row['decision'] for row in rows},
                         {**dict.fromkeys(first['holes'], 'water'), **dict.fromkeys(report.review[0]['holes'], 'accept')})
        for bad, text in (({99999: 'open'}, 'the report has no hole 99999'), ({0: 'lake'}, "decisions[0] is 'lake': expected"),
                          ({0: ('water', float('nan'))}, 'with a height in metres'), ({0: ('open', 3)}, 'with a height'),
                          ({0: ('water', float('inf'))}, 'with a height'), ({0: ('water', True)}, 'with a height'),
                          ({0: ('water', 1e300)}, 'with a height in metres from -100000 to 100000'),
                          ({0: ('water', 10 ** 400)}, 'with a height'), ({0: ('water', -100001)}, 'with a height'),
                          ({0: ('water', 'high')}, 'with a height'), ({'0': 'open'}, "the report has no hole '0'")):
            with self.assertRaises(tilemend.InvalidInput) as caught:
                report.write_decisions(path, bad, overwrite=True)
            self.assertIn(text, str(caught.exception))

    def test_errors_have_reasons(self):
        cluster = Cluster(self)
        scene, out = cluster.scene(), os.path.join(cluster.folder, 'out')
        with tilemend.Client(cluster.address) as client:
            def expect(kind, reason, call, *words, **more):
                with self.assertRaises(kind) as caught:
                    call(*words, **more)
                self.assertEqual(caught.exception.reason, reason)
                return caught.exception

            error = expect(tilemend.InvalidInput, 'INVALID_SPEC', client.submit, scene, out, gradation=50.0)
            self.assertIn('expected a number from 1 to 10', str(error))
            self.assertEqual(error.metadata, {'field': 'gradation'})
            expect(tilemend.InvalidInput, 'INVALID_SPEC', client.submit, scene, out, gradatoin=2.0)
            expect(tilemend.NotFound, 'SCENE_NOT_FOUND', client.submit, scene + '/none', out)
            error = expect(tilemend.NotFound, 'JOB_NOT_FOUND', client.get, 'none')
            self.assertIn('no such job; `Client.jobs()` shows all', str(error))
            with self.assertRaises(tilemend.NotFound):
                next(client.watch('none'))
            job = client.submit(scene, out, request_id='one')
            self.assertEqual(client.submit(scene, out, request_id='one').name, job.name)
            expect(tilemend.Conflict, 'OUTPUT_IN_USE', client.submit, scene, out)
            expect(tilemend.Conflict, 'JOB_NOT_OVER', client.retry, job)
            client.cancel(job)
            failed = expect(tilemend.JobFailed, 'JOB_FAILED', client.wait, job)
            self.assertEqual(failed.job.state, 'CANCELLED')
            expect(tilemend.Conflict, 'JOB_OVER', client.pause, job)

    def test_a_watch_outlives_the_coordinator(self):
        cluster = Cluster(self)
        scene, out = cluster.scene(), os.path.join(cluster.folder, 'out')
        with tilemend.Client(cluster.address) as client:
            job = client.submit(scene, out)
            watch = client.watch(job)
            self.assertEqual(next(watch).state, 'RUNNING')
            cluster.coordinator.kill()
            cluster.coordinator.wait()
            cluster.start('tilemend-coordinator', 'listening address=', '--work', f'{cluster.folder}/work', '--listen',
                          cluster.address)
            cluster.add_worker()
            self.assertEqual(list(watch)[-1].state, 'DONE')

    def test_a_forked_process_has_clients_of_its_own(self):
        cluster = Cluster(self)
        words = [sys.executable, os.path.abspath(__file__), BIN, PACKAGE, '--fork', cluster.address]
        # gRPC 1.51 now and then waits for ever for a thread of its own before a fork.
        for is_last in (False, False, True):
            try:
                told = subprocess.run(words, timeout=60, check=True, stdout=subprocess.PIPE, text=True).stdout
                break
            except subprocess.TimeoutExpired:
                if is_last:
                    raise
                print('gRPC stood still before a fork: again', file=sys.stderr)
        self.assertEqual(told.splitlines(), ['InvalidInput', 'InvalidInput', '[]', '[]'])

    def test_says_when_nobody_answers(self):
        with tilemend.Client('127.0.0.1:9', timeout=5) as client:
            with self.assertRaisesRegex(tilemend.Unavailable, 'cannot reach the coordinator; is it running'):
                client.jobs()
            with self.assertRaisesRegex(ConnectionError, 'cannot reach'):
                next(client.watch('none', patience=0.5))


class Coordinator(jobs_pb2_grpc.JobsServicer):
    """Answers in place of the program, and keeps who called."""

    def __init__(self, test):
        self.test, self.callers, self.watches, self.specs = test, [], 0, []
        server = grpc.server(futures.ThreadPoolExecutor(4))
        jobs_pb2_grpc.add_JobsServicer_to_server(self, server)
        self.address = f'127.0.0.1:{server.add_insecure_port("127.0.0.1:0")}'
        server.start()
        test.addCleanup(server.stop, 0)

    def WatchJob(self, request, context):
        self.watches += 1
        if self.watches == 1:
            yield jobs_pb2.Job(name=request.name, state=jobs_pb2.RUNNING, cursor=1)
            time.sleep(1.5)
            context.abort(grpc.StatusCode.UNAVAILABLE, 'it ends')
        yield jobs_pb2.Job(name=request.name, state=jobs_pb2.DONE, cursor=2)

    def ListJobs(self, request, context):
        self.callers.append(dict(context.invocation_metadata()).get('authorization'))
        page = int(request.page_token or 0)
        return jobs_pb2.ListJobsResponse(jobs=[jobs_pb2.Job(name=f'jobs/{page}')], next_page_token=str(page + 1) * (page < 2))

    def CreateJob(self, request, context):
        self.specs.append(request.spec)
        return jobs_pb2.Job(name='jobs/a', state=jobs_pb2.RUNNING, spec=request.spec)


class CallsTest(unittest.TestCase):
    def test_patience_begins_when_the_connection_is_lost(self):
        coordinator = Coordinator(self)
        with tilemend.Client(coordinator.address) as client:
            self.assertEqual([job.state for job in client.watch('a', patience=1)], ['RUNNING', 'DONE'])
        for timeout in (60, 1e10, float('inf')):
            with tilemend.Client(Coordinator(self).address) as client:
                self.assertEqual(client.wait('a', timeout=timeout).state, 'DONE')

    def test_a_wait_ends_in_time_while_the_connection_is_lost(self):
        coordinator = Coordinator(self)
        with tilemend.Client(coordinator.address) as client:
            began = time.monotonic()
            with self.assertRaisesRegex(tilemend.TimedOut, 'jobs/a: is not over yet'):
                client.wait('a', timeout=0.3)
            self.assertLess(time.monotonic() - began, 1.4)
        with tilemend.Client('127.0.0.1:9') as client, self.assertRaises(TimeoutError):
            client.wait('a', timeout=0.5)

    def test_arguments_are_checked_before_a_call(self):
        coordinator = Coordinator(self)
        with tilemend.Client(coordinator.address) as client:
            for name, value, expected in (('gradation', 'much', 'str; expected a number'), ('uniform', 1, 'int; expected True or'),
                                          ('gradation', True, 'bool; expected a number'), ('water', 3, 'int; expected text')):
                with self.assertRaisesRegex(TypeError, f'{name}: has type {expected}'):
                    client.submit('/scene', '/out', **{name: value})
            with self.assertRaisesRegex(TypeError, 'priority'):
                client.submit('/scene', '/out', priority='high')
            with self.assertRaisesRegex(tilemend.InvalidInput, 'priority: Value out of range'):
                client.submit('/scene', '/out', priority=2**40)
            with self.assertRaisesRegex(TypeError, 'job: has type int; expected one Job or its name'):
                client.get(3)
            with self.assertRaisesRegex(TypeError, 'has type list; expected one Job or its name .*; call this for each of them'):
                client.cancel(client.jobs())
            with self.assertRaisesRegex(tilemend.InvalidInput, 'timeout: -1: expected seconds'):
                client.wait('a', timeout=-1)
            with self.assertRaisesRegex(tilemend.InvalidInput, 'expected RUNNING, DONE'):
                client.jobs(['BUSY'])
        self.assertEqual(coordinator.specs, [])

    def test_jobs_are_those_of_all_pages(self):
        coordinator = Coordinator(self)
        with tilemend.Client(coordinator.address) as client:
            self.assertEqual([job.name for job in client.jobs()], ['jobs/0', 'jobs/1', 'jobs/2'])
            jobs = client.iter_jobs()
            self.assertEqual((len(coordinator.callers), next(jobs).name, len(coordinator.callers)), (3, 'jobs/0', 4))

    def test_options_that_are_paths_are_of_this_folder(self):
        coordinator = Coordinator(self)
        with tilemend.Client(coordinator.address) as client:
            client.submit('/scene', 'out', water='w.geojson', clear=pathlib.Path('c.shp'), area='s3://city/a', cells='0,0')
            client.submit('/scene', 'out', water='auto', tension='auto', output_format='obj', decisions='')
        first, second = coordinator.specs
        self.assertEqual([first.water, first.clear, first.area, first.cells],
                         [os.path.abspath('w.geojson'), os.path.abspath('c.shp'), 's3://city/a', '0,0'])
        self.assertEqual([second.water, second.HasField('tension'), second.output_format, second.decisions],
                         ['auto', False, 'obj', ''])

    def test_a_token_may_be_replaced(self):
        coordinator = Coordinator(self)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'token')
            for word in ('first', 'second'):
                pathlib.Path(path).write_text(word)
                if word == 'first':
                    client = tilemend.Client(coordinator.address, token_file=path)
                client.jobs()
        client.jobs()  # the file is gone
        client.close()
        self.assertEqual(coordinator.callers, [f'Bearer {word}' for word in ('first', 'second', 'second') for _ in range(3)])

    def test_a_closed_client_says_so(self):
        client = tilemend.Client('127.0.0.1:9')
        client.close()
        for call in (client.jobs, client.workers, lambda: next(client.watch('a'))):
            with self.assertRaisesRegex(tilemend.InvalidInput, 'the client is closed'):
                call()
        self.assertEqual(repr(client), 'Client(127.0.0.1:9, plain text, closed)')

    def test_paths_in_s3_stay(self):
        coordinator = Coordinator(self)
        with tilemend.Client(coordinator.address) as client:
            client.submit('s3://city/tiles/', 'out')
            with self.assertRaisesRegex(tilemend.InvalidInput, 'give text'):
                client.submit(pathlib.Path('s3://city/tiles'), 'out')
            client.submit('/scene', dry_run=np.bool_(True))
            with self.assertRaises(tilemend.InvalidInput):
                client.submit('/a\udcff', '/out')
        self.assertEqual((coordinator.specs[1].out, coordinator.specs[1].dry_run), ('', True))
        self.assertEqual(coordinator.specs[0].scene, 's3://city/tiles')
        self.assertEqual(coordinator.specs[0].out, os.path.abspath('out'))


class ErrorTextTest(unittest.TestCase):
    def test_flags_of_options_become_keywords(self):
        for text, expected in (
                ('choose another --out, give --overwrite', 'choose another out, give overwrite=True'),
                ('or --decisions FILE to do', 'or decisions=FILE to do'),
                ('--output-format 3dtiles is not possible', 'output_format 3dtiles is not possible'),
                ('--area FILE says it (tilemend inspect --propose-area FILE draws one)',
                 'area=FILE says it (tilemend inspect --propose-area FILE draws one)'),
                ('`tilemend fill --weld TOLERANCE` closes it', '`tilemend fill --weld TOLERANCE` closes it'),
                ('needs --tls-ca; it is paused; `tilemend resume` helps', 'needs --tls-ca; it is paused; `Client.resume()` helps'),
                ('/data/a--out/--overwrite: no such file', '/data/a--out/--overwrite: no such file')):
            self.assertEqual(str(from_status(3, text, '')), expected)


class SecurityTest(unittest.TestCase):
    def test_says_what_is_missing(self):
        def expect(text, *words, **more):
            with self.assertRaises(tilemend.InvalidInput) as caught:
                tilemend.Client(*words, **more)
            self.assertIn(text, str(caught.exception))

        for address in ('localhost', ':7070', 'http://127.0.0.1:7070', 'localhost:0', 'localhost:99999'):
            expect('expected "HOST:PORT"', address)
        expect('ca: is missing: without TLS the token would go to far.example:7070 in plain text', 'far.example:7070',
               token='secret')
        expect('key: is missing; cert and key go together', 'localhost:1', cert='a.pem')
        expect('give one of the two', 'localhost:1', token='a', token_file='b')
        expect('token: expected one word', 'localhost:1', token='two words')
        expect('none.pem: No such file', 'localhost:1', ca='none.pem')
        tilemend.Client('far.example:7070', insecure=True).close()

    def test_tls_certificates_and_tokens(self):
        if not shutil.which('openssl'):
            print('SKIPPED: test_tls_certificates_and_tokens: there is no openssl')
            self.skipTest('there is no openssl')
        folder = tempfile.mkdtemp(prefix='tilemend-python-')
        self.addCleanup(shutil.rmtree, folder)
        tls = os.path.join(folder, 'tls')
        subprocess.run([os.path.join(ROOT, 'scripts/make_certificates.sh'), tls], check=True, stderr=subprocess.DEVNULL)
        path = lambda name: os.path.join(tls, name)
        flags = ('--tls-cert', path('coordinator.pem'), '--tls-key', path('coordinator.key'), '--tls-ca', path('ca.pem'))
        cluster = Cluster(self, *flags)
        address = 'localhost:' + cluster.address.rsplit(':', 1)[1]
        with tilemend.Client(address, ca=path('ca.pem'), cert=path('watch.pem'), key=path('watch.key')) as client:
            self.assertEqual(client.jobs(), [])
            with self.assertRaises(tilemend.NotAllowed) as caught:
                client.submit(cluster.scene(), os.path.join(cluster.folder, 'out'))
            self.assertEqual(caught.exception.reason, 'ROLE_NEEDED')
        with tilemend.Client(address, timeout=5) as client, self.assertRaises(tilemend.Unavailable):
            client.jobs()
        self.check_tokens(folder, path)

    def check_tokens(self, folder, path):
        tokens = os.path.join(folder, 'tokens')
        with open(tokens, 'w') as file:
            file.write(f'ann watch {hashlib.sha256(b"word").hexdigest()}\n')
        os.chmod(tokens, 0o600)
        cluster = Cluster(self, '--tls-cert', path('coordinator.pem'), '--tls-key', path('coordinator.key'), '--tokens', tokens)
        address = 'localhost:' + cluster.address.rsplit(':', 1)[1]
        with tilemend.Client(address, ca=path('ca.pem'), token='word') as client:
            self.assertEqual(client.jobs(), [])
        with tilemend.Client(address, ca=path('ca.pem'), token='other') as client:
            with self.assertRaises(tilemend.NotAllowed) as caught:
                client.jobs()
            self.assertEqual(caught.exception.reason, 'UNAUTHENTICATED')


if __name__ == '__main__' and sys.argv[3:4] == ['--fork']:
    fork_with_a_client(sys.argv[4])
elif __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
