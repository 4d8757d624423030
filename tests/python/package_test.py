#!/usr/bin/env python3
"""Makes the Debian package and the wheel, and fills a mesh with what each of them holds: package_test.py ROOT TREE

Exit code 77 (skipped, and says so) without what packs. TREE: the build tree of the preset python.
"""
import glob
import importlib.metadata
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT, TREE = (os.path.abspath(path) for path in sys.argv[1:])
TRIAL = '''
import sys
sys.path.append({here!r})
import tilemend
from meshes import sphere
assert tilemend.__file__.startswith({package!r}), tilemend.__file__
filled = tilemend.fill(*sphere())
assert filled.filled.any() and not filled.left
assert 'grpc' not in sys.modules
tilemend.Client('127.0.0.1:1').close()
print(tilemend.__version__, len(filled.new_faces))
'''


def run(*words, **more):
    done = subprocess.run(words, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    if done.returncode:
        raise SystemExit(f'FAILED: {" ".join(words)}: {done.stdout}')
    return done.stdout.strip()


def expect(is_true, what):
    if not is_true:
        raise SystemExit(f'FAILED: {what}')


def fill_with(package):
    """The release, and how many faces the sphere gets."""
    text = TRIAL.format(here=os.path.dirname(os.path.abspath(__file__)), package=package)
    return run(sys.executable, '-c', text, env=dict(os.environ, PYTHONPATH=package), cwd='/')


def debian_package(folder):
    run('cpack', '-G', 'DEB', '--config', os.path.join(TREE, 'CPackConfig.cmake'), '-B', folder, cwd=TREE)
    (package,) = glob.glob(os.path.join(folder, '*.deb'))
    depends = run('dpkg-deb', '-f', package, 'Depends')
    for name in ('libprotobuf32', 'python3-numpy', 'python3-grpcio', 'python3 (<< 3.12)'):
        expect(name in depends, f'the package does not depend on {name}: {depends}')
    expect('libgrpc' not in depends, f'the module links gRPC: {depends}')
    run('dpkg-deb', '-x', package, os.path.join(folder, 'root'))
    expect(not os.path.exists(os.path.join(folder, 'root/usr/bin')), 'the package has programs')
    return fill_with(os.path.join(folder, 'root/usr/lib/python3/dist-packages'))


def check_requirements(metadata):
    """Debian's packages must be what the wheel asks for, or pip refuses it."""
    from packaging.requirements import Requirement  # python3-build needs it
    wanted = [Requirement(text) for text in re.findall(r'^Requires-Dist: (.*)$', metadata, re.M)]
    needed = {each.name: each for each in wanted if not each.marker}
    expect(set(needed) == {'numpy', 'grpcio', 'protobuf'}, f'the wheel needs {sorted(needed)}')
    for name, each in needed.items():
        expect(each.specifier.contains(importlib.metadata.version(name)),
               f'the wheel needs {each}, Debian has {importlib.metadata.version(name)}')


def wheel(folder):
    run(sys.executable, '-m', 'build', '--wheel', '--no-isolation', '--outdir', folder, os.path.join(ROOT, 'python'), cwd=ROOT)
    (path,) = glob.glob(os.path.join(folder, '*.whl'))
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
        check_requirements(archive.read(next(name for name in names if name.endswith('/METADATA'))).decode())
        archive.extractall(os.path.join(folder, 'wheel'))
    for name in ('tilemend/py.typed', 'tilemend/_tilemend.pyi', 'tilemend/_fill.pyi', 'tilemend/v1/jobs_pb2_grpc.py'):
        expect(name in names, f'the wheel has no {name}')
    return fill_with(os.path.join(folder, 'wheel'))


def main():
    for name in ('cpack', 'dpkg-shlibdeps', 'dpkg-deb', 'strip'):
        if not shutil.which(name):
            print(f'SKIPPED: there is no {name}')
            sys.exit(77)
    if any(importlib.util.find_spec(name) is None for name in ('build', 'setuptools', 'wheel')):
        print('SKIPPED: there is no python3-build, python3-setuptools or python3-wheel')
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix='tilemend-package-') as folder:
        of_debian, of_wheel = debian_package(folder), wheel(folder)
    expect(of_debian == of_wheel, f'the Debian package gives {of_debian}, the wheel {of_wheel}')
    print(f'both fill a sphere: {of_wheel}')


if __name__ == '__main__':
    main()
