#!/usr/bin/env python3
"""Installs the programs into a folder and reads the pages for users there: installed_docs_test.py BUILD CMAKE

Each file of the project that such a page names is installed, or its section says that it is in the source tree. Links to
other files lead somewhere.
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from docs_links_test import SCHEME, links  # noqa: E402

PAGES = ['README.md', 'examples/README.md',
         *(f'docs/{name}.md' for name in ('api', 'glossary', 'operations', 'python', 'reference', 'tutorial', 'user-guide'))]
NAMED = re.compile(r'(?<![\w/.-])((?:scripts|docker|tests|web|proto|deploy)/[\w./-]*\w)')
HEADING = re.compile(r'^(?=#+ )', re.MULTILINE)
SAID = 'source tree'


def faults_of(root, page):
    with open(os.path.join(root, page), encoding='utf-8') as file:
        text = file.read()
    folder = os.path.dirname(os.path.join(root, page))
    for line, target in links(text):
        path = target.split('#')[0]
        if path and not SCHEME.match(target) and not os.path.exists(os.path.join(folder, path)):
            yield f'{page}:{line}: {target} is not installed'
    for section in HEADING.split(text):
        for path in sorted(set(NAMED.findall(section))):
            if not os.path.exists(os.path.join(root, path)) and SAID not in ' '.join(section.split()):
                title = section.splitlines()[0]
                yield f'{page}: {path} is not installed, and the section "{title}" does not say that it is in the {SAID}'


def main():
    build, cmake = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix='tilemend-docs-') as folder:
        done = subprocess.run([cmake, '--install', build, '--prefix', '/usr'], env={**os.environ, 'DESTDIR': folder}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode:
            sys.exit(f'FAILED: cmake --install: {done.stdout}')
        root = os.path.join(folder, 'usr/share/doc/tilemend')
        faults = [fault for page in PAGES for fault in faults_of(root, page)]
    print(*faults, f'{len(PAGES)} pages, {len(faults)} faults', sep='\n')
    sys.exit(bool(faults))


if __name__ == '__main__':
    main()
