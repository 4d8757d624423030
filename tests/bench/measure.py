"""What the benchmarks share: running a program with its resources counted, and tables. Needs Python's own library only."""
import json
import math
import os
import statistics
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BIN = os.path.join(ROOT, 'build', 'release', 'bin')


class Run:
    """One run of a program: wall seconds, CPU seconds, the process's peak resident memory in bytes, exit code.

    A process starts out with the peak of the one that forked it, so that a small one is put between: this file, run.
    """

    def __init__(self, command, accept=(0,)):
        launcher = subprocess.run([sys.executable, '-S', os.path.abspath(__file__), *command], check=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        result = json.loads(launcher.stdout)
        self.wall, self.cpu, self.peak, self.code = (result[k] for k in ('wall', 'cpu', 'peak', 'code'))
        if self.code not in accept:
            raise SystemExit(f'{" ".join(command)}: exit code {self.code}\n{launcher.stderr}')


def launch(command):
    """Runs a program without output on stdout and prints what it took."""
    start = time.perf_counter()
    silence = os.open(os.devnull, os.O_WRONLY)
    pid = os.posix_spawnp(command[0], command, os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, silence, 1)])
    _, status, usage = os.wait4(pid, 0)
    print(json.dumps({'wall': time.perf_counter() - start, 'cpu': usage.ru_utime + usage.ru_stime,
                      'peak': usage.ru_maxrss * 1024, 'code': os.waitstatus_to_exitcode(status)}))


def up(value, digits):
    """A figure that is better when lower, never rounded in our favour."""
    scale = 10 ** digits
    return f'{math.ceil(value * scale - 1e-9) / scale:.{digits}f}'


def down(value, digits):
    """A figure that is better when higher."""
    scale = 10 ** digits
    return f'{math.floor(value * scale + 1e-9) / scale:.{digits}f}'


def megabytes(size):
    return up(size / 1e6, 0)


def median(values):
    return statistics.median(values)


def table(heads, rows):
    """Markdown; every column but the first is aligned to the right."""
    lines = ['| ' + ' | '.join(heads) + ' |', '|---' + '|---:' * (len(heads) - 1) + '|']
    return '\n'.join(lines + ['| ' + ' | '.join(str(c) for c in row) + ' |' for row in rows])


def verdict(printed, stand_in, outcome, ours):
    """A row of the table at the top of docs/papers.md, as a line."""
    return f'{printed} | {stand_in} | {outcome} | {ours}\n'


def make_scene(bin_folder, folder, *flags):
    subprocess.run([os.path.join(bin_folder, 'tilemend-make-scene'), folder, *map(str, flags)], check=True,
                   stdout=subprocess.DEVNULL)


def machine():
    """Processor, cores and the load of the last minute, as text."""
    name = 'unknown processor'
    with open('/proc/cpuinfo', encoding='utf-8') as file:
        for line in file:
            if line.startswith('model name'):
                name = ' '.join(line.split(':', 1)[1].split())
                break
    return f'{name}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}'


if __name__ == '__main__':
    launch(sys.argv[1:])
