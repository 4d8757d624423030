#!/usr/bin/env python3
"""Reads the #include lines of every source and fails on one that points against the layers.

    layering_test.py ROOT        checks the sources below ROOT, after checking itself

All third-party headers share one include path, so that the compiler finds a forbidden one as easily as an allowed one.
RULES says for each folder which of our folders and which third-party libraries it may include. A folder without a rule is an
error: a new folder needs a decision. Tests may include everything.
"""
import os
import re
import sys

# Third-party libraries by the beginning of an include path. Longer beginnings are tried first.
LIBRARIES = {
    'absl/': 'absl', 'Eigen/': 'eigen', 'unsupported/Eigen/': 'eigen', 'OpenMesh/': 'openmesh', 'draco/': 'draco', 'fast_float/': 'fast_float',
    'nlohmann/': 'json', 'pugixml': 'pugixml', 'openssl/': 'openssl', 'grpc/': 'grpc', 'grpcpp/': 'grpc',
    'google/protobuf/': 'protobuf', 'google/rpc/': 'protobuf', 'prometheus/': 'prometheus', 'gtest/': 'gtest',
    'gmock/': 'gtest', 'sqlite3': 'sqlite', 'proto/': 'protobuf', 'tilemend/v1/': 'protobuf',
}
# Standard and system headers that a pure folder may not use: it has no files, no threads and no clock of its own.
IMPURE = {'filesystem', 'fstream', 'thread', 'mutex', 'shared_mutex', 'condition_variable', 'future', 'stop_token',
          'semaphore', 'latch', 'barrier', 'atomic', 'iostream', 'cstdio', 'unistd.h', 'fcntl.h', 'stdio.h', 'pthread.h'}
IMPURE_ABSL = ('absl/synchronization/', 'absl/time/clock')

GEOMETRY = ['common/util', 'common/mesh', 'common/mesh/triangulation', 'common/grid', 'common/records', 'common/codec']
SERVICE = GEOMETRY + ['common/store', 'common/metrics', 'common/rpc']
PLAN = ['common/util', 'common/mesh', 'common/grid', 'common/records', 'coordinator/plan/types']
FILL = ['common/util', 'common/mesh', 'common/mesh/triangulation', 'common/grid', 'common/records']


def rule(folders, libraries, pure=False):
    return {'folders': set(folders), 'libraries': set(libraries), 'pure': pure}


# Each folder may include itself. Every folder has a rule of its own.
RULES = {
    'common/util': rule([], ['absl']),
    'common/mesh': rule(['common/util'], ['absl', 'eigen']),
    'common/mesh/triangulation': rule(['common/util', 'common/mesh'], ['absl', 'eigen']),
    'common/grid': rule(['common/util', 'common/mesh'], ['absl', 'eigen', 'json', 'pugixml']),
    'common/records': rule(['common/mesh', 'common/grid'], ['eigen']),
    'common/codec': rule(['common/util', 'common/mesh'], ['absl', 'eigen', 'draco', 'fast_float']),
    'common/store': rule(['common/util'], ['absl', 'openssl']),
    'common/metrics': rule(['common/util'], ['absl', 'prometheus']),
    'common/rpc': rule(GEOMETRY + ['common/store'], ['absl', 'eigen', 'openssl', 'grpc', 'protobuf']),
    'worker/survey': rule(GEOMETRY, ['absl', 'eigen']),
    'worker/fill/mesh': rule(['common/mesh'], ['eigen', 'openmesh']),
    'worker/fill/region': rule(FILL, ['eigen']),
    'worker/fill/hole': rule(FILL + ['worker/fill/region'], ['eigen']),
    'worker/fill/surface': rule(FILL + ['worker/fill/hole'], ['absl', 'eigen']),
    'worker/fill/shape': rule(FILL, ['eigen']),
    'worker/fill/space': rule(FILL, ['eigen']),
    'worker/fill/crease': rule(FILL + ['worker/fill/region', 'worker/fill/hole', 'worker/fill/surface', 'worker/fill/space'],
                               ['eigen']),
    'worker/fill/seam': rule(FILL + ['worker/fill/region', 'worker/fill/hole', 'worker/fill/surface'], ['eigen']),
    'worker/fill': rule(GEOMETRY + ['worker/fill/region', 'worker/fill/hole', 'worker/fill/surface', 'worker/fill/shape',
                                    'worker/fill/space', 'worker/fill/crease', 'worker/fill/seam'], ['absl', 'eigen']),
    'worker/assemble': rule(GEOMETRY, ['absl', 'eigen']),
    'worker/service': rule(SERVICE + ['worker/survey', 'worker/fill', 'worker/fill/hole', 'worker/fill/seam', 'worker/fill/shape',
                                      'worker/fill/space', 'worker/assemble'], ['absl', 'eigen', 'grpc', 'protobuf']),
    'worker': rule(SERVICE + ['worker/service'], ['absl', 'grpc']),
    'coordinator/plan/types': rule(['common/mesh', 'common/grid', 'common/records'], ['eigen'], pure=True),
    'coordinator/plan/rim': rule(PLAN, ['absl', 'eigen'], pure=True),
    'coordinator/plan/seam': rule(PLAN + ['coordinator/plan/rim'], ['absl', 'eigen'], pure=True),
    'coordinator/plan/hole': rule(PLAN + ['common/mesh/triangulation', 'coordinator/plan/rim'], ['absl', 'eigen'], pure=True),
    'coordinator/plan/pieces': rule(PLAN + ['coordinator/plan/rim'], ['absl', 'eigen'], pure=True),
    'coordinator/plan/water': rule(PLAN + ['coordinator/plan/seam'], ['absl', 'eigen'], pure=True),
    'coordinator/plan': rule(PLAN + ['coordinator/plan/rim', 'coordinator/plan/seam', 'coordinator/plan/hole',
                                     'coordinator/plan/pieces', 'coordinator/plan/water'], ['absl', 'eigen'], pure=True),
    'coordinator/state': rule(['common/util', 'common/grid'], ['absl', 'eigen'], pure=True),
    'coordinator/report': rule(GEOMETRY + ['common/store', 'coordinator/plan', 'coordinator/plan/types'],
                               ['absl', 'eigen', 'json']),
    'coordinator/service': rule(SERVICE + ['coordinator/plan', 'coordinator/plan/types', 'coordinator/plan/seam',
                                           'coordinator/plan/water', 'coordinator/state', 'coordinator/report'],
                                ['absl', 'eigen', 'grpc', 'protobuf']),
    'coordinator': rule(SERVICE + ['coordinator/service'], ['absl', 'grpc']),
    # `tilemend run` holds a coordinator and a worker; it is the one place where the two meet.
    'client': rule(SERVICE + ['coordinator/plan', 'coordinator/plan/types', 'coordinator/plan/seam', 'coordinator/report',
                              'coordinator/service', 'worker/service', 'worker/survey', 'worker/fill', 'worker/fill/hole',
                              'worker/fill/shape', 'worker/fill/space', 'worker/assemble'],
                   ['absl', 'eigen', 'json', 'grpc', 'protobuf']),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
OURS = ('common/', 'worker/', 'coordinator/', 'client/', 'tests/')


def rule_of(folder):
    """The name of the rule for a folder, None if there is none."""
    return folder if folder in RULES else None


def library_of(header):
    matches = [prefix for prefix in LIBRARIES if header.startswith(prefix)]
    return LIBRARIES[max(matches, key=len)] if matches else None


def fault(name, header, quoted):
    """Why the folder of rule `name` may not include `header`; None if it may."""
    allowed = RULES[name]
    if header.startswith(OURS):
        target = rule_of(os.path.dirname(header))
        if target == name or target in allowed['folders']:
            return None
        return f'{name} may not include {os.path.dirname(header)}'
    library = library_of(header)
    if allowed['pure'] and (header in IMPURE or header.startswith(IMPURE_ABSL)):
        return f'{name} is pure: no files, threads or clocks'
    if library:
        return None if library in allowed['libraries'] else f'{name} may not use {library}'
    if quoted:
        return 'not a path from the root of the repository'
    # What is left is the standard library or the system: no folder but in `sys/` and the like.
    if '/' in header and not header.startswith(('sys/', 'netinet/', 'arpa/', 'linux/')):
        return 'a library that no rule names'
    return None


def check_text(path, text):
    """The faults of one file, as lines."""
    name = rule_of(os.path.dirname(path))
    if name is None:
        return [f'{path}: no rule for this folder; add it to tests/layering_test.py']
    faults = []
    for match in INCLUDE.finditer(text):
        reason = fault(name, match.group(2), match.group(1) == '"')
        if reason:
            line = text.count('\n', 0, match.start(2)) + 1
            faults.append(f'{path}:{line}: {match.group(2)}: {reason}')
    return faults


def sources(root):
    for top in ('common', 'worker', 'coordinator', 'client'):
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in sorted(names):
                if name.endswith(('.cc', '.h')):
                    yield os.path.relpath(os.path.join(folder, name), root)


FORBIDDEN = [
    ('common/util/files.cc', 'common/mesh/tri_mesh.h'), ('common/mesh/a.h', 'common/grid/scene.h'),
    ('common/mesh/a.h', 'draco/mesh/mesh.h'), ('common/grid/a.cc', 'common/codec/mesh_file.h'),
    ('common/codec/a.cc', 'common/grid/scene.h'), ('worker/fill/a.cc', 'grpcpp/grpcpp.h'),
    ('worker/survey/a.cc', 'OpenMesh/Core/Mesh/PolyConnectivity.hh'), ('worker/survey/a.cc', 'worker/fill/a.h'),
    ('worker/survey/a.cc', 'prometheus/counter.h'), ('worker/assemble/a.cc', 'worker/service/a.h'),
    ('worker/fill/a.cc', 'common/rpc/a.h'), ('worker/fill/a.cc', 'common/metrics/a.h'),
    ('worker/service/a.cc', 'coordinator/state/a.h'), ('coordinator/service/a.cc', 'worker/fill/a.h'),
    ('coordinator/plan/a.cc', 'filesystem'), ('coordinator/plan/a.cc', 'common/codec/mesh_file.h'),
    ('coordinator/state/a.cc', 'thread'), ('coordinator/state/a.h', 'absl/synchronization/mutex.h'),
    ('coordinator/state/a.cc', 'tilemend/v1/job.pb.h'), ('coordinator/state/a.cc', 'coordinator/service/a.h'),
    ('common/grid/a.cc', 'tests/support/scene_maker.h'), ('common/grid/a.cc', 'boost/graph.hpp'),
    ('common/newcomer/a.cc', 'vector'), ('worker/fill/hole/a.cc', 'worker/fill/fill_holes.h'),
    ('coordinator/plan/rim/a.cc', 'coordinator/plan/hole/a.h'), ('coordinator/plan/types/a.h', 'coordinator/plan/plan.h'),
    ('worker/fill/newcomer/a.cc', 'vector'),
]
ALLOWED = [
    ('common/mesh/a.h', 'Eigen/Core'), ('common/grid/a.cc', 'common/mesh/tri_mesh.h'), ('common/util/a.cc', 'sys/stat.h'),
    ('worker/fill/a.cc', 'worker/fill/hole/a.h'), ('worker/fill/a.cc', 'filesystem'), ('coordinator/plan/a.cc', 'map'),
    ('coordinator/plan/water/a.cc', 'coordinator/plan/seam/a.h'), ('worker/main.cc', 'worker/service/a.h'),
    ('client/a.cc', 'coordinator/service/a.h'), ('client/a.cc', 'worker/service/a.h'),
]


def check_itself():
    """Faults of this test: forbidden includes that it lets pass, and the other way round."""
    faults = []
    for forms in ('#include <{}>\n', '#include "{}"\n', '// first\n  #  include <{}>  // why\n'):
        for path, header in FORBIDDEN:
            if not check_text(path, forms.format(header)):
                faults.append(f'self-check: {path} could include {header}')
    for path, header in ALLOWED:
        faults += [f'self-check: {f}' for f in check_text(path, f'#include <{header}>\n')]
    return faults


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    faults, count = check_itself(), 0
    for path in sources(root):
        with open(os.path.join(root, path), encoding='utf-8') as file:
            faults += check_text(path, file.read())
        count += 1
    if not count:
        faults.append(f'{root}: no sources found')
    for line in faults:
        print(line)
    print(f'{count} files, {len(faults)} faults')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
