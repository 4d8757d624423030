"""Builds the module with CMake (preset python): python3 -m build --wheel --no-isolation python"""
import os
import re
import shutil
import subprocess

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PACKAGE = os.path.join(ROOT, 'build', 'python', 'package', 'tilemend')


def release():
    with open(os.path.join(ROOT, 'CMakeLists.txt'), encoding='utf-8') as file:
        return re.search(r'project\(tilemend VERSION ([0-9.]+)', file.read()).group(1)


class CMakeBuild(build_ext):
    """Copies the module and the messages of the API from CMake's tree."""

    def run(self):
        subprocess.run(['cmake', '--preset', 'python'], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(['cmake', '--build', '--preset', 'python', '-j', os.environ.get('JOBS', '2'), '--target',
                        'tilemend_python_package'], cwd=ROOT, check=True)
        target = os.path.join(self.build_lib, 'tilemend')
        os.makedirs(os.path.join(target, 'v1'), exist_ok=True)
        for name in os.listdir(PACKAGE):
            if name.endswith('.so'):
                shutil.copy(os.path.join(PACKAGE, name), target)
                subprocess.run(['strip', os.path.join(target, name)], check=True)
        for name in ('LICENSE', 'NOTICE', 'THIRD_PARTY.md'):
            shutil.copy(os.path.join(ROOT, name), target)
        for name in os.listdir(os.path.join(PACKAGE, 'v1')):
            if name.endswith('.py'):
                shutil.copy(os.path.join(PACKAGE, 'v1', name), os.path.join(target, 'v1'))


setup(version=release(), ext_modules=[Extension('tilemend._tilemend', [])], cmdclass={'build_ext': CMakeBuild})
