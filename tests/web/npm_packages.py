"""Packages of npm by a lock file, those of web/ if none is given, for tests."""
import fcntl
import filecmp
import os
import shutil
import subprocess
import sys

WEB = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'web')
SKIPPED = 77


def skip(why):
    print(f'SKIPPED: {why}')
    sys.exit(SKIPPED)


def fail(why):
    print(f'FAILED: {why}')
    sys.exit(1)


def run(*words, cwd=None, env=None):
    return subprocess.run(words, cwd=cwd, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=280)


def install(folder, of=WEB):
    """Puts the packages into FOLDER/node_modules, unless they are there already. One process at a time does so; the
    test is skipped where npm or its registry is missing."""
    if not shutil.which('npm') or not shutil.which('node'):
        skip('there is no npm')
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, 'install.lock'), 'w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        installed = os.path.join(folder, 'installed.json')
        wanted = os.path.join(of, 'package-lock.json')
        if os.path.exists(installed) and filecmp.cmp(installed, wanted, shallow=False):
            return
        for name in ('package.json', 'package-lock.json'):
            shutil.copy(os.path.join(of, name), folder)
        try:
            done = run('npm', 'ci', '--ignore-scripts', '--no-audit', '--no-fund', cwd=folder)
        except subprocess.TimeoutExpired:
            skip('npm does not get its packages in time')
        if done.returncode:
            skip(f'npm cannot get its packages: {done.stdout[-1000:]}')
        shutil.copy(wanted, installed)


def chromium():
    return shutil.which('chromium') or shutil.which('google-chrome')
