#!/usr/bin/env python3
"""Floods a coordinator with connections, watches, streams and submissions, and looks whether it still serves.

    flood_test.py BIN [--connections 5000] [--watches 300] [--gets 1000] [--most-ms 250] [--most-seconds 5]

BIN has tilemend, tilemend-coordinator, tilemend-worker and tilemend-make-scene. With a descriptor limit of 64: 500 idle
connections; with one of 1,024: `connections` at once. After each the coordinator must serve again within `most-seconds`,
also while they stay open and say nothing. Then messages that are too long and calls that are only begun, which must
not be kept in memory, and calls whose answers nobody reads, which must end. Then `watches` of one job, which must hold no
threads, and ten times more submissions than capacity, while `get` is timed: `gets` times, a process each, with
submissions going on, and 99 of 100 may take `most-ms` at most. Prints its figures. Exit code 1 if anything was not so.
"""
import argparse
import os
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

from cluster_harness import Bench, Failure, await_, require
from raw_calls import LongCall, begun_calls, unread_calls

MAX_JOBS = 8
SUBMITTERS = 4
MOST_NEW_THREADS = 8  # of gRPC itself


def start(bench, descriptors):
    bench.log = open(os.path.join(bench.folder, 'coordinator.log'), 'w+')
    bench.coordinator = subprocess.Popen(
        [bench.program('tilemend-coordinator'), '--work', bench.work, '--listen', bench.address, '--max-jobs',
         str(MAX_JOBS)], stderr=bench.log,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (descriptors, descriptors)))
    require(bench.await_serving(), bench.said())


def served_after(bench):
    """Seconds until a client is answered."""
    begin = time.time()
    await_('the coordinator to serve', lambda: bench.client('list').returncode == 0)
    return time.time() - begin


def open_idle(port, count):
    idle = []
    for _ in range(count):
        connection = socket.socket()
        connection.setblocking(False)
        connection.connect_ex(('127.0.0.1', port))
        idle.append(connection)
    return idle


def flood(bench, descriptors, count, most):
    start(bench, descriptors)
    idle = open_idle(bench.port, count)
    time.sleep(0.5)  # they are there
    while_open = served_after(bench)
    for connection in idle:
        connection.close()
    closed = served_after(bench)
    require(closed <= most and while_open <= most + 1,
            f'{count} connections: served after {while_open:.1f} s while they were open, {closed:.1f} s after they closed')
    bench.kill()
    return while_open, closed


def status_of(bench, key):
    with open(f'/proc/{bench.coordinator.pid}/status') as status:
        return int(next(line for line in status if line.startswith(key)).split()[1])


def send_too_much(bench, callers, megabytes, most):
    """The most memory of the coordinator, in MB, while callers without any right send messages of that length."""
    start(bench, 1024)

    def send():
        LongCall(bench.port, '/tilemend.v1.Jobs/CreateJob').send(megabytes << 20)

    threads = [threading.Thread(target=send) for _ in range(callers)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        served_after(bench)
    memory = status_of(bench, 'VmHWM:') // 1024
    require(memory <= most, f'{memory} MB for messages that are refused')
    bench.kill()
    return memory


def begin_often(bench, connections, calls, most):
    """The most memory of the coordinator, in MB, while callers begin calls and send no message."""
    start(bench, 1024)
    begun = [begun_calls(bench.port, '/tilemend.v1.Jobs/CreateJob', calls) for _ in range(connections)]
    served_after(bench)
    memory = status_of(bench, 'VmHWM:') // 1024
    require(memory <= most, f'{memory} MB for {connections} connections with {calls} calls that were only begun')
    for connection in begun:
        connection.close()
    bench.kill()
    return memory


def leave_unread(bench, most):
    """Seconds until a client is answered, while callers hold more calls than there can be at once and read nothing."""
    start(bench, 1024)
    connections = [unread_calls(bench.port, '/tilemend.v1.Jobs/ListJobs', 20) for _ in range(100)]
    time.sleep(2)  # they are there
    took = served_after(bench)
    require(took <= most, f'calls whose answer nobody reads: served after {took:.1f} s')
    for connection in connections:
        connection.close()
    bench.kill()
    return took


def descriptors_of(bench):
    return len(os.listdir(f'/proc/{bench.coordinator.pid}/fd'))


def watch_often(bench, scene, count, most):
    start(bench, 4096)
    open_before = descriptors_of(bench)  # the submission has some for a moment
    made = bench.client('submit', scene, '--out', os.path.join(bench.folder, 'watched'))
    require(made.returncode == 0, made.stderr)
    name = next(word for word in made.stdout.replace('\n', ' ').split() if word.startswith('jobs/'))
    before = status_of(bench, 'Threads:')
    watches = [subprocess.Popen([bench.program('tilemend'), 'watch', name, '--coordinator', bench.address],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(count)]
    await_('the watches', lambda: descriptors_of(bench) >= open_before + count)
    threads, memory = status_of(bench, 'Threads:') - before, status_of(bench, 'VmRSS:') // 1024
    took = served_after(bench)
    for watch in watches:
        watch.send_signal(signal.SIGKILL)
        watch.wait()
    require(took <= most, f'{count} watches: served after {took:.1f} s')
    require(threads <= MOST_NEW_THREADS, f'{count} watches: {threads} threads more')
    bench.client('cancel', name)
    await_('the job to be over', lambda: 'ended' in (bench.get(name) or {}))
    return threads, memory


class Overload:
    """Submissions that never end, by a few clients: with more the machine would be busy starting them."""

    def __init__(self, bench, scene):
        self.bench, self.scene, self.is_over, self.shed = bench, scene, False, 0
        self.threads = [threading.Thread(target=self.run, args=(number,)) for number in range(SUBMITTERS)]
        for thread in self.threads:
            thread.start()

    def run(self, number):
        out = os.path.join(self.bench.folder, f'more{number}')
        while not self.is_over:
            self.shed += self.bench.client('submit', self.scene, '--out', out).returncode == 5

    def close(self):
        self.is_over = True
        for thread in self.threads:
            thread.join()


def get_often(bench, scene, name, count):
    """Seconds of each `get` of a job under overload, the least first, and how many submissions were shed meanwhile."""
    overload = Overload(bench, scene)
    times = []
    try:
        for _ in range(count):
            begin = time.time()
            require(bench.client('get', name).returncode == 0, 'get failed')
            times.append(time.time() - begin)
    finally:
        overload.close()
    return sorted(times), overload.shed


def submit_often(bench, scene):
    """Ten times more than capacity at once, while `list` is timed."""
    processes = [subprocess.Popen([bench.program('tilemend'), 'submit', scene, '--out',
                                   os.path.join(bench.folder, f'many{number}'), '--coordinator', bench.address],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                 for number in range(10 * MAX_JOBS)]
    times = []
    for _ in range(40):
        begin = time.time()
        require(bench.client('list').returncode == 0, 'list failed')
        times.append(time.time() - begin)
    codes, hints = [], 0
    for process in processes:
        _, error = process.communicate()
        codes.append(process.returncode)
        hints += 'try again in' in error
    taken, shed = codes.count(0), codes.count(5)
    require(taken == MAX_JOBS and taken + shed == len(codes) and hints == shed,
            f'{taken} submissions taken, {shed} shed, {hints} with a hint, exit codes {sorted(set(codes))}')
    times.sort()
    return taken, shed, times[len(times) // 2], times[-1], status_of(bench, 'VmRSS:') // 1024


def run_all(bench, arguments):
    scene = os.path.join(bench.folder, 'scene')
    subprocess.run([bench.program('tilemend-make-scene'), scene, '--cols', '2', '--rows', '2', '--cell', '100',
                    '--spacing', '2'], check=True, stdout=subprocess.DEVNULL)
    for descriptors, count in ((64, 500), (1024, arguments.connections)):
        while_open, closed = flood(bench, descriptors, count, arguments.most_seconds)
        print(f'{count} idle connections, descriptor limit {descriptors}: a client was answered after {while_open:.1f} s '
              f'while they were open, {closed:.1f} s after they were closed')
    memory = send_too_much(bench, 4, 300, arguments.most_megabytes)
    print(f'4 messages of 300 MB at once: refused, at most {memory} MB in all')
    memory = begin_often(bench, 20, 2000, arguments.most_megabytes)
    print(f'20 connections with 2000 calls each that are only begun: at most {memory} MB')
    took = leave_unread(bench, 40 + arguments.most_seconds)
    print(f'2000 calls whose answer nobody reads: a client was answered after {took:.1f} s')
    threads, memory = watch_often(bench, scene, arguments.watches, arguments.most_seconds)
    print(f'{arguments.watches} watches: {threads} threads more, {memory} MB in all')
    taken, shed, median, most, memory = submit_often(bench, scene)
    print(f'{taken + shed} submissions, capacity {MAX_JOBS}: {taken} taken, {shed} shed with a hint; `list`, a process each, '
          f'in {median * 1000:.0f} ms (median), {most * 1000:.0f} ms (most); {memory} MB')
    name = bench.client('list').stdout.split('jobs/')[1].split()[0]
    times, shed = get_often(bench, scene, 'jobs/' + name, arguments.gets)
    slow = times[len(times) * 99 // 100]
    print(f'`get` while {SUBMITTERS} clients submit without end, {shed} shed: {times[len(times) // 2] * 1000:.0f} ms '
          f'(median), {slow * 1000:.0f} ms (99 of 100), {times[-1] * 1000:.0f} ms (most), a process each; '
          f'{status_of(bench, "VmRSS:") // 1024} MB')
    require(slow * 1000 <= arguments.most_ms, f'99 of 100 within {slow * 1000:.0f} ms')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('--connections', type=int, default=5000)
    parser.add_argument('--watches', type=int, default=300)
    parser.add_argument('--gets', type=int, default=1000)
    parser.add_argument('--most-ms', type=float, default=250)
    parser.add_argument('--most-seconds', type=float, default=5)
    parser.add_argument('--most-megabytes', type=int, default=200, help='of memory while messages and calls are refused')
    arguments = parser.parse_args()
    limit = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (limit[1], limit[1]))
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, folder)
        try:
            run_all(bench, arguments)
        except Failure as failure:
            print(f'FAILED: {failure}')
            sys.exit(1)
        finally:
            bench.close()


if __name__ == '__main__':
    main()
