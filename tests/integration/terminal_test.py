#!/usr/bin/env python3
"""`tilemend demo` and `tilemend run` as a person sees them, at a terminal and through a pipe: terminal_test.py BIN"""
import os
import pty
import re
import subprocess
import sys
import tempfile

BIN = os.path.join(os.path.abspath(sys.argv[1]), 'tilemend')
OF_PROGRAMS = ('task', 'phase', 'jobs/', 'cluster')  # words that say nothing to a surveyor


def at_terminal(*words):
    """What a terminal gets, and the exit code."""
    ours, theirs = pty.openpty()
    program = subprocess.Popen([BIN, *words], stdout=theirs, stderr=theirs)
    os.close(theirs)
    shown = b''
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        shown += part
    os.close(ours)
    return program.wait(), shown.decode().replace('\r\n', '\n')


def expect(is_true, what, shown):
    if not is_true:
        raise SystemExit(f'FAILED: {what}:\n{shown}')


def check_pipe(scene, out):
    """Into files: the same words in lines, the whole summary, and the job with -v alone."""
    def piped(*words):
        done = subprocess.run([BIN, 'run', scene, *words], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        expect(done.returncode == 0, f'run {words} ends with {done.returncode}', done.stdout + done.stderr)
        return done

    plain = piped('--out', out)
    shown = plain.stdout + plain.stderr
    for word in (*OF_PROGRAMS, 'state ', '\r', '\033'):
        expect(word not in shown, f'run into a pipe shows {word!r}', shown)
    expect(plain.stdout.startswith('10 of 10 holes filled') and 'kind of hole ' in plain.stdout, 'no summary', plain.stdout)
    expect(plain.stdout.endswith(f'page: {out}/report.html (open it in a browser)\ncheck: tilemend check {scene} {out}\n'),
           'the page is not named', plain.stdout)
    lines = plain.stderr.splitlines()
    for begins, ends in zip(lines[::2], lines[1::2]):
        expect(re.fullmatch(re.escape(begins) + r', [0-9]+\.[0-9] s', ends), 'a stage does not begin and end in a line', plain.stderr)
    expect(lines[-2:-1] == ['write the tiles'], 'the last stage is missing', plain.stderr)  # a short one may pass unseen
    dry = piped('--dry-run')
    expect(dry.stdout.startswith('10 holes found, nothing written') and 'task' not in dry.stdout, 'dry run', dry.stdout)
    shown = piped('--out', out + '_v', '-v').stdout
    expect(shown.startswith('state    done') and 'tasks ' in shown and 'jobs/' not in shown, 'run -v into a pipe', shown)


def main():
    with tempfile.TemporaryDirectory(prefix='tilemend-terminal-') as folder:
        demo = os.path.join(folder, 'demo')
        code, shown = at_terminal('demo', demo)
        expect(code == 0, f'demo ends with {code}', shown)
        for part in ('write the tiles', '10 of 10 holes filled', 'filled flat as water', '412.0', f'{demo}/out/report.html',
                     f'check: tilemend check {demo}/scene {demo}/out\n'):
            expect(part in shown, f'demo does not show {part!r}', shown)
        for word in OF_PROGRAMS:
            expect(word not in shown, f'demo shows {word!r}', shown)
        for file in ('report.html', 'report.json', 'tiles/Tile_+000_+000.ply'):
            expect(os.path.exists(os.path.join(demo, 'out', file)), f'{file} is missing', shown)
        code, shown = at_terminal('demo', demo)
        expect(code == 0, 'demo does not run twice', shown)

        expect(shown.count('report.html') == 1, 'demo does not name the page once', shown)

        code, shown = at_terminal('run', f'{demo}/scene', '--out', f'{folder}/again', '-v')
        expect(code == 0 and 'tasks' in shown and f'{folder}/again/report.html' in shown, 'run -v does not show the job', shown)
        expect('jobs/' not in shown, 'run -v names a job that no command can ask for', shown)

        mine = os.path.join(folder, 'mine')
        os.mkdir(mine)
        open(os.path.join(mine, 'letter.txt'), 'w').close()
        code, shown = at_terminal('demo', mine)
        expect(code == 4 and os.listdir(mine) == ['letter.txt'], 'demo writes into a folder of somebody else', shown)

        check_pipe(f'{demo}/scene', f'{folder}/piped')
    print('a terminal shows stages and the result')


if __name__ == '__main__':
    main()
