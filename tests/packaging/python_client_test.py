#!/usr/bin/env python3
"""Runs docs/examples/fill.py, the client in Python, against a cluster: python_client_test.py BIN

Exit code 77 (skipped, and says so) without protoc's plugin for Python, grpc and protobuf.
"""
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def start(words, text):
    """A program, and what follows `text` on the line of its log that holds it."""
    program = subprocess.Popen(words + ['--log', 'text'], stderr=subprocess.PIPE, text=True)
    for line in program.stderr:
        if text in line:
            return program, line.split(text)[1].strip()
    raise SystemExit(f'FAILED: {words[0]} ended')


def main():
    folder = sys.argv[1]
    plugin = shutil.which('grpc_python_plugin')
    if not plugin or any(importlib.util.find_spec(name) is None for name in ('grpc', 'google.protobuf')):
        print('SKIPPED: needs protobuf-compiler-grpc, python3-grpcio and python3-protobuf')
        sys.exit(77)
    with tempfile.TemporaryDirectory() as at:
        proto = os.path.join(ROOT, 'proto')
        files = ['error_info', 'stages', 'jobs', 'work']
        subprocess.run(['protoc', '-I', proto, f'--python_out={at}', f'--grpc_out={at}', f'--plugin=protoc-gen-grpc={plugin}'] +
                       [f'{proto}/tilemend/v1/{name}.proto' for name in files], check=True)
        scene, out = os.path.join(at, 'scene'), os.path.join(at, 'out')
        subprocess.run([f'{folder}/tilemend-make-scene', scene, '--cols', '3', '--rows', '2', '--spacing', '5'], check=True,
                       stdout=subprocess.DEVNULL)
        coordinator, address = start([f'{folder}/tilemend-coordinator', '--work', f'{at}/work', '--listen', '127.0.0.1:0'],
                                     'listening address=')
        worker, _ = start([f'{folder}/tilemend-worker', '--coordinator', address], 'info connected')
        try:
            done = subprocess.run([sys.executable, os.path.join(ROOT, 'docs/examples/fill.py'), address, scene, out],
                                  env=dict(os.environ, PYTHONPATH=at), text=True, stdout=subprocess.PIPE, check=True)
        finally:
            worker.terminate()
            coordinator.terminate()
        filled = json.loads(done.stdout)
        if not os.path.exists(f'{out}/report.json') or sum(filled['I'].values()) + filled['closed'] == 0:
            raise SystemExit(f'FAILED: {filled}')
    print(f'filled {filled}')


if __name__ == '__main__':
    main()
