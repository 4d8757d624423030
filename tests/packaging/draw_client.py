#!/usr/bin/env python3
"""Draws the client at work: a real job on a real cluster of this machine, as its commands show it on a terminal.

    draw_client.py BIN PICTURE [SPACING]     needs matplotlib (Debian: python3-matplotlib)

SPACING, in metres, of the vertices of the scene that it makes: less of it, and the job takes longer (default 0.6).
"""
import contextlib
import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import sys
import tempfile
import termios
import time

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt

COLUMNS = 80
LINE = 0.155  # inches
COLOURS = {'$': '#7ee787', '[': '#79c0ff'}  # of a line, by its first letter


class Terminal:
    """The lines that a terminal shows, of a program that writes no other escape than that which erases a line."""

    def __init__(self):
        self.lines, self.column = [''], 0

    def take(self, text):
        for token in re.findall(r'\x1b\[K|[^\x1b]|\x1b', text):
            if token == '\x1b[K':
                self.lines[-1] = self.lines[-1][:self.column]
            elif token == '\r':
                self.column = 0
            elif token == '\n':
                self.lines.append('')
                self.column = 0
            elif token < ' ':
                raise SystemExit(f'FAILED: unknown control character {token!r}')
            else:
                self.put(token)

    def put(self, letter):
        if self.column == COLUMNS:
            self.lines.append('')
            self.column = 0
        line = self.lines[-1].ljust(self.column)
        self.lines[-1] = line[:self.column] + letter + line[self.column + 1:]
        self.column += 1


class Command:
    """A command on a terminal of its own."""

    def __init__(self, folder, environment, *words):
        self.terminal = Terminal()
        self.terminal.take('$ ' + ' '.join(words) + '\n')
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(words[0], words, environment)
        fcntl.ioctl(self.fd, termios.TIOCSWINSZ, struct.pack('HHHH', 40, COLUMNS, 0, 0))

    def read(self, seconds):
        """Whether it still runs."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if not select.select([self.fd], [], [], left)[0]:
                return True
            try:
                text = os.read(self.fd, 65536).decode()
            except OSError:  # as Linux says that the other side has gone
                return False
            self.terminal.take(text.replace('\r\n', '\n'))
        return True

    def to_end(self):
        while self.read(1):
            pass
        code = os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])
        if code:
            raise SystemExit(f'FAILED: exit code {code}: ' + '\n'.join(self.terminal.lines))
        return shown(self)


def shown(command):
    return [line for line in command.terminal.lines if line]


@contextlib.contextmanager
def cluster(folder, programs, address):
    words = [['tilemend-coordinator', '--work', 'work', '--listen', address]]
    words += [['tilemend-worker', '--coordinator', address, '--threads', '1']] * 2
    with open(os.path.join(folder, 'log'), 'w') as log:
        started = [subprocess.Popen([os.path.join(programs, w[0]), *w[1:]], cwd=folder, stdout=log, stderr=log) for w in words]
        try:
            yield
        finally:
            for process in started:
                process.kill()
                process.wait()


def play(folder, programs, spacing):
    """The panes of the picture: (title, lines)."""
    address = '127.0.0.1:17070'
    environment = dict(os.environ, PATH=programs + ':' + os.environ['PATH'], TILEMEND_COORDINATOR=address)
    environment.pop('TILEMEND_CONFIG', None)
    subprocess.run([os.path.join(programs, 'tilemend-make-scene'), os.path.join(folder, 'city'), '--cols', '6', '--rows', '5',
                    '--cell', '250', '--spacing', spacing, '--seed', '7', '--holes', 'lakes,islands,river,small'], check=True,
                   stdout=subprocess.DEVNULL)
    run = lambda *words: Command(folder, environment, *words)
    with cluster(folder, programs, address):
        submit = run('tilemend', 'submit', 'city', '--out', 'filled', '--wait')
        while ' left' not in shown(submit)[-1] or '/' not in shown(submit)[-1] or float(submit_share(submit)) < 0.45:
            if not submit.read(0.2):
                raise SystemExit('FAILED: the job was over before it was looked at; take less SPACING\n' +
                                 '\n'.join(shown(submit)))
        middle = shown(submit)
        others = run('tilemend', 'workers').to_end() + [''] + run('tilemend', 'list').to_end()
        job = others[-1].split()[0].split('/')[1]
        others += [''] + run('tilemend', 'prioritize', job[:4], '5').to_end()
        watch = run('tilemend', 'watch', job[:4])
        watch.read(1)
        others += [''] + shown(watch)
        ended = submit.to_end()
        watch.to_end()
    return [('while it runs', middle), ('another terminal', others), ('the first one, at the end', beginning(ended))]


def beginning(lines):
    """The end of a job without the tables that follow the first: they are longer than a picture."""
    end = next((i for i, line in enumerate(lines) if line.startswith('closed:')), len(lines))
    return lines[:end] + ['...'] * (end < len(lines))


def submit_share(command):
    bar = re.match(r'\[(#*)(\.*)\]', shown(command)[-1])
    return len(bar.group(1)) / (len(bar.group(1)) + len(bar.group(2))) if bar else 0


def draw(panes, picture):
    heights = [len(lines) + 2.5 for _, lines in panes]
    size = (COLUMNS * 0.0705, sum(heights) * LINE + 0.1)
    figure = plt.figure(figsize=size, facecolor='white')
    top = size[1]
    for (title, lines), height in zip(panes, heights):
        bottom = top - height * LINE + 0.06
        figure.patches.append(plt.Rectangle((0.004, bottom / size[1]), 0.992, (top - 0.06 - bottom) / size[1],
                                            transform=figure.transFigure, facecolor='#0d1117'))
        for i, line in enumerate([title] + lines):
            figure.text(0.012, (top - (i + 1.4) * LINE) / size[1], line.replace('$', r'\$'), family='DejaVu Sans Mono',
                        fontsize=8, color='#8b949e' if i == 0 else COLOURS.get(line[:1], '#e6edf3'), va='baseline')
        top -= height * LINE
    figure.savefig(picture, dpi=110, metadata={'Software': None})


def main():
    programs, picture = os.path.abspath(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory(prefix='tilemend-draw-') as folder:
        panes = play(folder, programs, sys.argv[3] if len(sys.argv) > 3 else '0.6')
    for title, lines in panes:
        print(f'-- {title}\n' + '\n'.join(lines))
    draw(panes, picture)


if __name__ == '__main__':
    main()
