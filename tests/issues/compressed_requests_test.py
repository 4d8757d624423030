#!/usr/bin/env python3
"""Sends compressed requests to a coordinator: they must be refused before they are decompressed.

    compressed_requests_test.py BIN

BIN has tilemend and tilemend-coordinator. 400 KB of gzip hold 400 MB of zeros. The memory of the coordinator may grow
by MOST_MEGABYTES. Exit code 1 if it grows more, or if the coordinator does not serve afterwards.
"""
import os
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'integration'))
from cluster_harness import require, run_attack  # noqa: E402
from raw_calls import compressed_call  # noqa: E402

MEGABYTES = 400  # of the message once it is decompressed
MOST_MEGABYTES = 60  # of threads and buffers of a few calls
CALLS = 4


WINDOWS = {'gzip': 31, 'deflate': 15}  # what zlib calls the two formats


def packed_zeros(encoding, megabytes):
    packer = zlib.compressobj(9, zlib.DEFLATED, WINDOWS[encoding])
    return b''.join(packer.compress(bytes(1 << 20)) for _ in range(megabytes)) + packer.flush()


def peak_megabytes(process):
    with open(f'/proc/{process.pid}/status') as status:
        return int(next(line for line in status if line.startswith('VmHWM:')).split()[1]) // 1024


def attack(bench):
    bench.start()
    require(bench.await_serving(), bench.said())
    require(bench.client('list').returncode == 0, 'the coordinator does not serve')
    before = peak_megabytes(bench.coordinator)
    for encoding in WINDOWS:
        message = packed_zeros(encoding, MEGABYTES)
        for _ in range(CALLS):
            compressed_call(bench.port, '/tilemend.v1.Jobs/CreateJob', encoding, message)
    after = peak_megabytes(bench.coordinator)
    print(f'{2 * CALLS} messages of {len(message) // 1024} KB, {MEGABYTES} MB each when decompressed: '
          f'memory from {before} MB to {after} MB')
    require(after - before <= MOST_MEGABYTES, f'{after - before} MB for messages that must be refused')
    require(bench.client('list').returncode == 0, 'the coordinator does not serve any more')


if __name__ == '__main__':
    sys.exit(run_attack(attack))
