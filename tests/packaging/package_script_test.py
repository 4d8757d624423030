#!/usr/bin/env python3
"""Runs scripts/package.sh and looks into what it made: package_script_test.py ROOT BUILD

BUILD: the build tree of the tests. The script builds in trees of its own, so it is quick only if BUILD is the one of
the preset release, and the tree of the preset python is there. Else the exit code is 77 (skipped, and says so). So it
is if a package is missing that the script would install: a test installs nothing.
"""
import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT, BUILD = (os.path.realpath(path) for path in sys.argv[1:])
TOOLS = 'cpack', 'dpkg-shlibdeps', 'dpkg-deb', 'strip'
MODULES = 'build', 'setuptools', 'wheel'

# What a user's first hour needs.
PROGRAMS = ['usr/bin/tilemend', 'usr/bin/tilemend-coordinator', 'usr/bin/tilemend-worker',
            'usr/lib/tilemend/tilemend-gdal',
            'usr/lib/systemd/system/tilemend-coordinator.service', 'usr/lib/systemd/system/tilemend-worker.service',
            'usr/share/bash-completion/completions/tilemend', 'usr/share/man/man1/tilemend.1.gz',
            *(f'usr/share/doc/tilemend/{name}' for name in (
                'README.md', 'CHANGELOG.md', 'LICENSE', 'docs/tutorial.md', 'docs/user-guide.md', 'docs/operations.md',
                'docs/api.md', 'docs/python.md', 'examples/README.md', 'examples/cluster/run.sh',
                'proto/tilemend/v1/jobs.proto', 'scripts/make_certificates.sh', 'scripts/render.py'))]
MODULE = ['tilemend/__init__.py', 'tilemend/py.typed', 'tilemend/_tilemend.pyi', 'tilemend/_fill.pyi',
          'tilemend/v1/jobs_pb2.py', 'tilemend/v1/jobs_pb2_grpc.py']
PYTHON = [*(f'usr/lib/python3/dist-packages/{name}' for name in MODULE),
          *(f'usr/share/doc/python3-tilemend/{name}' for name in (
              'python.md', 'LICENSE', 'examples/python/fill_arrays.py', 'examples/python/notebook.ipynb'))]


def skip(why):
    print(f'SKIPPED: {why}')
    sys.exit(77)


def expect(is_true, what):
    if not is_true:
        sys.exit(f'FAILED: {what}')


def files_of(package):
    if package.endswith('.whl'):
        with zipfile.ZipFile(package) as archive:
            return set(archive.namelist())
    listed = subprocess.run(['dpkg-deb', '--fsys-tarfile', package], stdout=subprocess.PIPE, check=True)
    names = subprocess.run(['tar', '-t'], input=listed.stdout, stdout=subprocess.PIPE, check=True).stdout.decode()
    return {name.removeprefix('./') for name in names.splitlines()}


def main():
    if BUILD != os.path.join(ROOT, 'build', 'release'):
        skip(f'the tests are not built in build/release but in {BUILD}')
    if not os.path.isdir(os.path.join(ROOT, 'build', 'python', 'package')):
        skip('the Python package is not built')
    missing = [name for name in TOOLS if not shutil.which(name)]
    missing += [name for name in MODULES if importlib.util.find_spec(name) is None]
    if missing:
        skip(f'there is no {", ".join(missing)}')
    listed = subprocess.run([os.path.join(ROOT, 'scripts', 'install.sh'), '--check', '--package', '--python'],
                            stdout=subprocess.PIPE, text=True, check=True)
    if listed.stdout:
        skip(f'these Debian packages are not installed: {", ".join(listed.stdout.split())}')
    with tempfile.TemporaryDirectory(prefix='tilemend-packages-') as folder:
        done = subprocess.run([os.path.join(ROOT, 'scripts', 'package.sh'), folder], text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        expect(done.returncode == 0, f'package.sh ends with {done.returncode}: {done.stdout}')
        named = [shlex.split(line)[-1] for line in re.findall(r'^(?:Install|Python|Wheel): +(.+)$', done.stdout, re.M)]
        expect(len(named) == 3 and sorted(named) == sorted(os.path.join(folder, name) for name in os.listdir(folder)),
               f'package.sh names {named} and makes {os.listdir(folder)}: {done.stdout}')
        for package, wanted in zip(named, (PROGRAMS, PYTHON, MODULE)):
            there = files_of(package)
            expect(not set(wanted) - there, f'{os.path.basename(package)} lacks {sorted(set(wanted) - there)}')
            print(f'{os.path.basename(package)}: {len(there)} files')


if __name__ == '__main__':
    main()
