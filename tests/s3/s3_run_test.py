#!/usr/bin/env python3
"""Scenes and outputs in an S3 store give what folders give, through faults too, or a clear error.

    s3_run_test.py PACKAGES PROGRAMS     PACKAGES is a folder for npm packages
"""
import json
import os
import subprocess
import sys
import tempfile

from s3_server import BUCKET, SECRET, S3Server
from textured_scenes import obj_scene, tileset_scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'integration'))
from free_port import free_port  # noqa: E402

VARYING = ('report.json', 'report.html', '.tilemend-results')  # with dates, paths and times


def expect(true, what):
    if not true:
        print(f'FAILED: {what}')
        sys.exit(1)


def files_below(folder):
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(at, name)
            found[os.path.relpath(path, folder)] = open(path, 'rb').read()
    return found


def same_output(found, wanted):
    """Whether these files are those of an output, but for what always differs."""
    kept = [{name: data for name, data in files.items() if name not in VARYING} for files in (found, wanted)]
    expect(sorted(kept[0]) == sorted(kept[1]), f'files {sorted(kept[0])}, not {sorted(kept[1])}')
    for name, data in kept[0].items():
        expect(data == kept[1][name], f'{name} differs')
    expect('report.json' in found and 'report.html' in found, 'no report')


class Test:
    def __init__(self, packages, programs, folder):
        self.programs, self.folder = programs, folder
        self.server = S3Server(packages, folder)
        self.said = []  # all that programs printed

    def program(self, name):
        return os.path.join(self.programs, name)

    def run(self, *words, environment=None):
        done = subprocess.run([self.program('tilemend'), *words], capture_output=True, text=True, timeout=240,
                              env=environment or self.server.environment())
        self.said.append(done.stdout + done.stderr)
        return done

    def fails(self, what, *words, environment=None):
        done = self.run(*words, environment=environment)
        expect(done.returncode != 0, f'{words} succeeds')
        for part in what:
            expect(part in done.stderr, f'"{part}" is not in {done.stderr}')

    def same_as_folder(self):
        self.scene = obj_scene(os.path.join(self.folder, 'a scene'))
        self.server.upload(self.scene, 'city/a scene')
        done = self.run('run', self.scene, '--out', os.path.join(self.folder, 'out'))
        expect(done.returncode == 0, done.stderr)
        self.wanted = files_below(os.path.join(self.folder, 'out'))
        self.in_store = f's3://{BUCKET}/city/a scene'
        self.good_run('plain')

    def good_run(self, name):
        done = self.run('run', self.in_store, '--out', f's3://{BUCKET}/out/{name}')
        expect(done.returncode == 0, f'{name}: {done.stderr}')
        same_output(self.server.objects(f'out/{name}/'), self.wanted)

    def through_faults(self):
        for name, method, match, times, kind in (('busy', 'GET', 'tiles', 3, 'busy'), ('lists', 'GET', 'list-type', 2, 'busy'),
                                                 ('looks', 'HEAD', 'tiles', 3, 'busy'), ('cut', 'GET', 't0.obj', 2, 'cut'),
                                                 ('slow', 'GET', 't1.obj', 2, 'slow'), ('flip', 'GET', 't0.obj', 2, 'flip'),
                                                 ('puts', 'PUT', '.tilemend-attempts', 2, 'busy'),
                                                 ('sent', 'PUT', '.tilemend-attempts', 1, 'flip'),
                                                 ('lost', 'PUT', '.tilemend-attempts', 2, 'cut')):
            self.server.spoil((method, match, times, kind))
            self.good_run(name)
            expect(self.server.faults_left() == 0, f'{name}: the fault did not happen')

    def errors(self):
        out = f's3://{BUCKET}/out/no'
        self.fails([f's3://{BUCKET}/none', 'no such scene'], 'run', f's3://{BUCKET}/none', '--out', out)
        self.fails(['s3://nobucket/none', 'no such'], 'run', 's3://nobucket/none', '--out', out)
        self.fails(['s3://nobucket/out', 'no such bucket'], 'run', self.in_store, '--out', 's3://nobucket/out')
        wrong = self.server.environment(AWS_SECRET_ACCESS_KEY='wrong-secret')
        self.fails([self.in_store, 'refuses', '403'], 'run', self.in_store, '--out', out, environment=wrong)
        none = self.server.environment(AWS_ACCESS_KEY_ID='', AWS_SHARED_CREDENTIALS_FILE='/nowhere')
        self.fails(['no credentials', '/nowhere'], 'run', self.in_store, '--out', out, environment=none)
        self.server.spoil(('GET', 't0.obj', 1000, 'flip'))
        self.fails(['t0.obj', 'checksum'], 'run', self.in_store, '--out', out)
        self.server.spoil()
        expect('report.json' not in self.server.objects('out/no/'), 'a report of a job that failed')
        self.fails(['--overwrite'], 'run', self.in_store, '--out', f's3://{BUCKET}/out/plain')

    def same_in_store(self, name, scene, *words, **changes):
        """Runs a job on a scene in a folder and in the store; gives the latter's output."""
        environment = self.server.environment(**changes)
        at = f'city/{name}/{os.path.basename(scene)}'
        self.server.upload(scene, at)
        local, stored = os.path.join(self.folder, f'out-{name}'), f's3://{BUCKET}/out/{name}'
        for source, out in ((scene, local), (f's3://{BUCKET}/{at}', stored)):
            done = self.run('run', source, '--out', out, *words, environment=environment)
            expect(done.returncode == 0, f'{name}: {done.stderr}')
        same_output(self.server.objects(f'out/{name}/'), files_below(local))
        return local, stored

    def trees_of_files(self):
        scene = tileset_scene(os.path.join(self.folder, 'tileset'))
        _, stored = self.same_in_store('tileset', scene)
        done = self.run('check', f's3://{BUCKET}/city/tileset/tileset', stored)
        expect(done.returncode == 0, done.stdout + done.stderr)
        delivered, _ = self.same_in_store('delivered', self.scene, '--output-format', 'osgb')
        _, stored = self.same_in_store('Tile_+000', delivered)  # as exports name their folders
        expect(self.run('check', stored).returncode == 0, 'check of OSGB tiles')

    def checks(self):
        done = self.run('check', self.in_store, f's3://{BUCKET}/out/plain')
        expect(done.returncode == 0, done.stdout + done.stderr)
        self.server.drop('out/plain/images/ground.png')
        done = self.run('check', self.in_store, f's3://{BUCKET}/out/plain')
        expect(done.returncode == 100 and 'images/ground.png' in done.stdout, done.stdout + done.stderr)
        self.fails(['nothing', 'no such'], 'check', f's3://{BUCKET}/nothing')

    def large_objects(self):
        """A tile and an image above the size of a part, through faults."""
        scene = obj_scene(os.path.join(self.folder, 'large'))
        with open(os.path.join(scene, 'tiles/t0.obj'), 'a') as tile:
            tile.write('# made large\n' * 500000)
        with open(os.path.join(scene, 'images/ground.png'), 'ab') as image:
            image.write(bytes(11 << 20))  # after its end, where nobody reads
        self.server.spoil(('PUT', 'partNumber=2', 2, 'busy'), ('PUT', 'partNumber=1', 1, 'flip'),
                          ('POST', 'uploadId', 1, 'cut'), ('POST', 'uploads', 1, 'busy'))
        self.same_in_store('large', scene, TILEMEND_S3_PART_MB='5')
        expect(self.server.faults_left() == 0, 'a fault did not happen')
        sent = [r for r in self.server.requests() if 'partNumber' in r['url']]
        expect(any('x-amz-copy-source' in r['headers'] for r in sent), 'no image was copied in parts')
        expect(any('x-amz-copy-source' not in r['headers'] for r in sent), 'no tile was sent in parts')

    def credentials_in_file(self):
        path = os.path.join(self.folder, 'credentials')
        open(path, 'w').write(f'[default]\naws_access_key_id = x\naws_secret_access_key = y\n[city]\n'
                              f'aws_access_key_id = S3RVER\naws_secret_access_key = {SECRET}\n')
        environment = self.server.environment(AWS_ACCESS_KEY_ID='', AWS_SECRET_ACCESS_KEY='', AWS_PROFILE='city',
                                              AWS_SHARED_CREDENTIALS_FILE=path)
        done = self.run('inspect', self.in_store, environment=environment)
        expect(done.returncode == 0, done.stderr)

    def cluster(self):
        address = f'127.0.0.1:{free_port()}'
        logs = [os.path.join(self.folder, f'log{i}') for i in range(3)]
        roots = ['--root', f's3://{BUCKET}/city:s3://{BUCKET}/out']
        commands = [['tilemend-coordinator', '--work', os.path.join(self.folder, 'work'), '--listen', address, *roots]]
        commands += [['tilemend-worker', '--coordinator', address, '--threads', '1', *roots]] * 2
        running = [subprocess.Popen([self.program(command[0]), *command[1:]], env=self.server.environment(),
                                    stderr=open(log, 'w')) for command, log in zip(commands, logs)]
        try:
            words = ['--coordinator', address, '-o', 'json']
            done = self.run('submit', self.in_store, '--out', f's3://{BUCKET}/out/cluster', *words)
            expect(done.returncode == 0, done.stderr)
            name = json.loads(done.stdout)['name']
            done = self.run('watch', name, *words)
            expect(done.returncode == 0, done.stdout + done.stderr + open(logs[0]).read() + open(logs[1]).read())
            found = self.server.objects('out/cluster/')
            beside = {'report.html': b'', 'holes.csv': self.wanted['holes.csv']}  # which `run` adds, and `report --html`
            same_output(found | beside, self.wanted)
            expect(json.loads(found['report.json'])['holes'], 'a report without holes')
            self.fails(['--root'], 'submit', self.in_store, '--out', f's3://{BUCKET}/elsewhere', *words)
            self.fails(['--root'], 'submit', self.scene, '--out', f's3://{BUCKET}/out/other', *words)
        finally:
            for process in running:
                process.terminate()
            for process in running:
                process.wait()
        self.said += [open(log).read() for log in logs]

    def secrets(self):
        text = ''.join(self.said) + ''.join(str(data) for data in self.server.objects('out/').values())
        expect('wrong-secret' not in text and SECRET not in text, 'a secret in a log, a message or an output')
        unsigned = [r for r in self.server.requests() if 'authorization' not in r['headers']]
        expect(not unsigned, f'requests without a signature: {unsigned[:1]}')

    def all(self):
        try:
            for step in (self.same_as_folder, self.through_faults, self.errors, self.trees_of_files, self.large_objects,
                         self.credentials_in_file, self.cluster, self.checks, self.secrets):
                step()
                print(f'{step.__name__}: done', flush=True)
        finally:
            self.server.close()


def main():
    with tempfile.TemporaryDirectory() as folder:
        Test(sys.argv[1], sys.argv[2], folder).all()


if __name__ == '__main__':
    main()
