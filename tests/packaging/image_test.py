#!/usr/bin/env python3
"""Holds the container image to what the programs need, without a Docker engine: image_test.py BIN

docker/runtime_packages.txt and the table of THIRD_PARTY.md must name the Debian package of every library that a program
of BIN needs (`objdump -p`), and each service of docker/compose.yaml must be able to write to its TMPDIR. Exit code 77
(skipped, and says so) without dpkg or objdump; without Debian's python3-yaml the second part is left out.
"""
import importlib.util
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAMS = ('tilemend', 'tilemend-coordinator', 'tilemend-worker', 'tilemend-gdal', 'tilemend-make-scene')
# In debian:12-slim already.
BASE = {'libc6', 'libgcc-s1', 'zlib1g'}
faults = []


def check(condition, text):
    if not condition:
        faults.append(text)


def read(path):
    with open(os.path.join(ROOT, path)) as file:
        return file.read()


def needed_libraries(program):
    listed = subprocess.run(['objdump', '-p', program], text=True, stdout=subprocess.PIPE, check=True).stdout
    return set(re.findall(r'^\s*NEEDED\s+(\S+)', listed, re.MULTILINE))


def loaded_files(program):
    """By library, the file that the loader takes."""
    listed = subprocess.run(['ldd', program], text=True, stdout=subprocess.PIPE, check=True).stdout
    return dict(re.findall(r'^\s*(\S+) => (/\S+)', listed, re.MULTILINE))


def packages_of(files):
    """By file, the Debian package that owns it. With merged /usr dpkg knows a file by one of two paths."""
    paths = {path: file for file in files for path in (file, '/usr' + file, file.removeprefix('/usr'))}
    listed = subprocess.run(['dpkg', '-S', *paths], text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    return {paths[path]: package for package, path in re.findall(r'^([^:\s]+)\S* (/\S+)$', listed, re.MULTILINE)}


def check_libraries(bin_folder):
    installed = {line for line in read('docker/runtime_packages.txt').splitlines() if not line.startswith('#')}
    described = read('THIRD_PARTY.md')
    needs = {}  # by library, its file and one program that needs it
    for program in PROGRAMS:
        path = os.path.join(bin_folder, program)
        files = loaded_files(path)
        for library in needed_libraries(path):
            if not library.startswith('ld-linux'):  # the loader itself
                needs[library] = (files[library], program)
    packages = packages_of({file for file, _ in needs.values()})
    for library, (file, program) in sorted(needs.items()):
        package, by = packages.get(file), f'({library} of {program})'
        check(package is not None, f'{file}: no package has it {by}')
        check(package in installed | BASE, f'docker/runtime_packages.txt: {package} is missing {by}')
        check(str(package) in described, f'THIRD_PARTY.md: {package} is missing {by}')
    check(len(needs) > 0, 'no library found')
    return len(needs)


def check_temporary_folders():
    """The image's file system is read-only: TMPDIR must be a volume or a tmpfs of each service."""
    if importlib.util.find_spec('yaml') is None:
        print('SKIPPED in part: no python3-yaml, so TMPDIR of the services is not looked at')
        return
    import yaml
    (of_image,) = re.findall(r'^ENV TMPDIR=(\S+)', read('docker/Dockerfile'), re.MULTILINE)
    for name, service in yaml.safe_load(read('docker/compose.yaml'))['services'].items():
        if not service.get('read_only'):
            continue
        folder = service.get('environment', {}).get('TMPDIR', of_image)
        writable = service.get('tmpfs', []) + [v.rsplit(':', 1)[1] for v in service['volumes'] if not v.endswith(':ro')]
        check(folder in writable, f'docker/compose.yaml: {name} cannot write to TMPDIR ({folder})')


def main():
    for program in ('dpkg', 'objdump', 'ldd'):
        if not shutil.which(program):
            print(f'SKIPPED: there is no {program}, so docker/runtime_packages.txt is not looked at')
            sys.exit(77)
    count = check_libraries(os.path.abspath(sys.argv[1]))
    check_temporary_folders()
    if faults:
        sys.exit('FAILED\n' + '\n'.join(faults))
    print(f'{len(PROGRAMS)} programs, {count} libraries, 0 faults')


if __name__ == '__main__':
    main()
