#!/usr/bin/env python3
"""Runs everything in examples/: examples_test.py BIN

The client in Python is left out, with a message, without protoc's plugin for Python, grpc and protobuf.
"""
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXAMPLES = os.path.join(ROOT, 'examples')


def run(example, *arguments, path=None, python_path=None):
    """What the example prints."""
    env = dict(os.environ, PATH=f"{path}:{os.environ['PATH']}")
    if python_path:
        env['PYTHONPATH'] = python_path
    script = os.path.join(EXAMPLES, example)
    words = [sys.executable, script] if script.endswith('.py') else [script]
    done = subprocess.run(words + list(arguments), env=env, text=True, capture_output=True, timeout=300)
    if done.returncode != 0:
        raise SystemExit(f'FAILED: {example} ends with {done.returncode}\n{done.stdout}\n{done.stderr}')
    return done.stdout


def start(words, text):
    """A program, and what follows `text` on the line of its log that holds it."""
    program = subprocess.Popen(words + ['--log', 'text'], stderr=subprocess.PIPE, text=True)
    for line in program.stderr:
        if text in line:
            return program, line.split(text)[1].strip()
    raise SystemExit(f'FAILED: {words[0]} ended')


def expect(text, part, of):
    if part not in text:
        raise SystemExit(f'FAILED: {of} does not print {part!r}:\n{text}')


def python_client(folder, at, scene):
    plugin = shutil.which('grpc_python_plugin')
    if not plugin or any(importlib.util.find_spec(name) is None for name in ('grpc', 'google.protobuf')):
        print('SKIPPED: python_client needs protobuf-compiler-grpc, python3-grpcio and python3-protobuf')
        return
    proto = os.path.join(ROOT, 'proto')
    files = ['error_info', 'stages', 'job_spec', 'jobs', 'work']
    subprocess.run(['protoc', '-I', proto, f'--python_out={at}', f'--grpc_out={at}', f'--plugin=protoc-gen-grpc={plugin}'] +
                   [f'{proto}/tilemend/v1/{name}.proto' for name in files], check=True)
    coordinator, address = start([f'{folder}/tilemend-coordinator', '--work', f'{at}/work', '--listen', '127.0.0.1:0'],
                                 'listening address=')
    worker, _ = start([f'{folder}/tilemend-worker', '--coordinator', address], 'info connected')
    try:
        expect(run('python_client/fill.py', address, scene, f'{at}/by_python', path=folder, python_path=at), '"closed"',
               'python_client')
    finally:
        worker.terminate()
        coordinator.terminate()


def main():
    folder = os.path.abspath(sys.argv[1])
    listed = open(os.path.join(EXAMPLES, 'README.md'), encoding='utf-8').read()
    for name in os.listdir(EXAMPLES):
        if os.path.isdir(os.path.join(EXAMPLES, name)):
            expect(listed, f'({name}/', 'examples/README.md')
    with tempfile.TemporaryDirectory() as at:
        scene, out = f'{at}/scene', f'{at}/out'
        subprocess.run([f'{folder}/tilemend-make-scene', scene, '--cols', '3', '--rows', '2', '--spacing', '5'], check=True,
                       stdout=subprocess.DEVNULL)
        expect(run('fill_a_scene/run.sh', scene, out, path=folder), 'holes filled', 'fill_a_scene')
        expect(run('read_the_report/summary.py', out), 'holes filled', 'read_the_report')
        tile = next(os.path.join(where, name) for where, _, names in os.walk(scene) for name in sorted(names)
                    if name.endswith(('.obj', '.ply')))
        expect(run('fill_a_mesh/run.sh', tile, f'{at}/mesh{os.path.splitext(tile)[1]}', path=folder), 'holes', 'fill_a_mesh')
        expect(run('cluster/run.sh', scene, f'{at}/by_cluster', path=folder), 'holes filled', 'cluster')
        python_client(folder, at, scene)
    print('all examples ran')


if __name__ == '__main__':
    main()
