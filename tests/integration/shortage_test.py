#!/usr/bin/env python3
"""Runs `tilemend run` with too little address space and with too few threads: it must end by itself, with code 0 or 5
and a line that says why, nothing must be left in its work folder, and the same command without a limit must complete
what it left of the output."""
import argparse
import filecmp
import os
import resource
import subprocess
import sys
import tempfile

SKIPPED = 77
NOBODY = 65534


def ended(command, limit, amount, seconds):
    """The process after its end, with one limit lowered and without settings of the user."""

    def lower():
        if limit == resource.RLIMIT_NPROC and os.geteuid() == 0:
            os.setgroups([])
            os.setuid(NOBODY)  # root has no such limit
        resource.setrlimit(limit, (amount, amount))

    return subprocess.run(command, preexec_fn=lower, capture_output=True, text=True, timeout=seconds,
                          env={'PATH': os.environ['PATH']})


def fault_of(run, work):
    """What is wrong with how a run ended; empty if nothing is."""
    if run.returncode not in (0, 5) or (run.returncode == 5 and 'tilemend: ' not in run.stderr):
        return f'code {run.returncode}\n{run.stderr}'
    left = os.listdir(work) if os.path.isdir(work) else []
    return f'left in the work folder: {left}' if left else ''


def differing(folder, reference):
    """The tiles that are not the same in both."""
    names = os.listdir(os.path.join(reference, 'tiles'))
    _, unequal, missing = filecmp.cmpfiles(os.path.join(folder, 'tiles'), os.path.join(reference, 'tiles'), names, False)
    return unequal + missing


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('bin', help='folder of the programs')
    parser.add_argument('--megabytes', default='60:500:40', help='address space: from:to:step')
    parser.add_argument('--threads', default='2:40:8', help='threads and processes of the user: from:to:step')
    parser.add_argument('--seconds', type=float, default=120, help='that a run may take')
    options = parser.parse_args()
    client = os.path.join(os.path.abspath(options.bin), 'tilemend')
    failures = 0
    codes = {}
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o777)
        scene, reference = os.path.join(folder, 'scene'), os.path.join(folder, 'reference')
        subprocess.run([client + '-make-scene', scene, '--cols', '2', '--rows', '2'], check=True, capture_output=True)
        base = [client, 'run', scene, '--workers', '2', '--out']
        subprocess.run(base + [reference], check=True, capture_output=True)
        cases = [(resource.RLIMIT_AS, n, n << 20) for n in range(*map(int, options.megabytes.split(':')))]
        cases += [(resource.RLIMIT_NPROC, n, n) for n in range(*map(int, options.threads.split(':')))]
        for limit, number, amount in cases:
            out = os.path.join(folder, f'out-{limit}-{number}')
            what = f'{number} {"MB" if limit == resource.RLIMIT_AS else "threads"}'
            try:
                work = os.path.join(folder, f'work-{limit}')
                run = ended(base + [out, '--work', work], limit, amount, options.seconds)
            except subprocess.TimeoutExpired:
                print(f'{what}: does not end')
                failures += 1
                continue
            codes[run.returncode] = codes.get(run.returncode, 0) + 1
            if fault := fault_of(run, work):
                print(f'{what}: {fault}')
                failures += 1
            if run.returncode == 5:
                subprocess.run(base + [out], check=True, capture_output=True)
            if unequal := differing(out, reference):
                print(f'{what}: other tiles than without a limit: {unequal}')
                failures += 1
    print(f'{len(cases)} runs that were short of memory or threads, codes {codes}: {failures} failures')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main())
