#!/usr/bin/env python3
"""Reads the #include lines of every source and fails on one that points against the layers.

    layering_test.py ROOT        checks the sources below ROOT, after checking itself

All third-party headers share one include path, so that the compiler finds a forbidden one as easily as an allowed one.
RULES says for each folder which of our folders and which third-party libraries it may include. A folder without a rule is an
error: a new folder needs a decision. So is a rule that no source needs, a permission that no include uses, and a circle
of folders that include each other. Tests may include everything.
"""
import os
import re
import sys

# Third-party libraries by the beginning of an include path. Longer beginnings are tried first.
LIBRARIES = {
    'absl/': 'absl', 'Eigen/': 'eigen', 'unsupported/Eigen/': 'eigen', 'OpenMesh/': 'openmesh', 'draco/': 'draco', 'fast_float/': 'fast_float', 'meshoptimizer': 'meshoptimizer',
    'nlohmann/': 'json', 'pugixml': 'pugixml', 'curl/': 'curl', 'openssl/': 'openssl', 'grpc/': 'grpc', 'grpcpp/': 'grpc',
    'google/protobuf/': 'protobuf', 'google/rpc/': 'protobuf', 'prometheus/': 'prometheus', 'httplib': 'httplib', 'systemd/': 'systemd', 'gtest/': 'gtest',
    'gmock/': 'gtest', 'gdal': 'gdal', 'ogr': 'gdal', 'cpl_': 'gdal',
    'CLI/': 'cli11', 'turbojpeg': 'jpeg', 'png.h': 'png', 'polyclipping/': 'clipper', 'sqlite3': 'sqlite', 'SQLiteCpp/': 'sqlite', 'libpq-fe.h': 'postgres', 'xxhash': 'xxhash', 'zlib.h': 'zlib', 'pybind11/': 'pybind11', 'proto/': 'protobuf', 'tilemend/v1/': 'protobuf', 'externalscaler/': 'protobuf',
}
# Standard and system headers that a pure folder may not use: it has no files, no threads and no clock of its own.
IMPURE = {'filesystem', 'fstream', 'thread', 'mutex', 'shared_mutex', 'condition_variable', 'future', 'stop_token',
          'semaphore', 'latch', 'barrier', 'atomic', 'iostream', 'cstdio', 'unistd.h', 'fcntl.h', 'stdio.h', 'pthread.h'}
IMPURE_ABSL = ('absl/synchronization/', 'absl/time/clock')


def rule(folders, libraries, pure=False):
    return {'folders': set(folders), 'libraries': set(libraries), 'pure': pure}


# Each folder may include itself. Every folder has a rule of its own, which names what it includes and no more.
RULES = {
    'common/util': rule([], ['absl', 'cli11']),

    'common/mesh': rule([], ['eigen']),

    'common/mesh/triangulation': rule(['common/mesh'], ['eigen']),

    'common/mesh/winding': rule(['common/mesh'], ['clipper']),

    'common/grid': rule(['common/util', 'common/mesh'], ['absl', 'json', 'pugixml']),

    'common/gis': rule(['common/util', 'common/mesh', 'common/grid'], ['absl', 'gdal']),

    'common/records': rule(['common/util', 'common/mesh', 'common/grid'], ['absl', 'eigen']),

    'common/codec': rule(['common/util', 'common/mesh', 'common/mesh/triangulation', 'common/codec/tree'], ['absl', 'draco', 'fast_float']),

    'common/codec/osgb': rule(['common/util', 'common/mesh'], ['absl', 'eigen']),

    'common/codec/gltf': rule(['common/util', 'common/mesh'], ['absl', 'draco', 'eigen', 'json', 'meshoptimizer']),

    'common/codec/tiles3d': rule(['common/util', 'common/mesh', 'common/codec/gltf'], ['absl', 'eigen']),

    'common/codec/tree': rule(
        ['common/util', 'common/mesh', 'common/codec/osgb', 'common/codec/tiles3d'], ['absl']),

    'common/assemble': rule(
        ['common/util', 'common/mesh', 'common/mesh/triangulation', 'common/mesh/winding', 'common/records', 'common/codec',
         'common/codec/tree'],
        ['absl', 'eigen']),

    'common/image': rule(['common/util'], ['absl', 'jpeg', 'png']),

    'common/store': rule(['common/util'], ['absl', 'openssl', 'xxhash', 'zlib']),

    'common/s3': rule(['common/util', 'common/store'], ['absl', 'curl', 'json', 'openssl', 'pugixml']),

    'common/http': rule([], ['absl', 'httplib', 'openssl']),

    'common/metrics': rule(['common/http', 'common/util'], ['absl', 'openssl', 'prometheus']),

    'common/service': rule([], ['systemd']),

    'common/options': rule(['common/util', 'common/grid', 'common/records'], ['absl', 'protobuf']),

    'common/rpc': rule(['common/util', 'common/metrics', 'common/mesh', 'common/records', 'common/codec', 'common/assemble', 'common/store'], ['absl', 'grpc', 'openssl', 'protobuf']),

    'worker/ground': rule(['common/mesh', 'common/records'], ['eigen'], pure=True),

    'worker/survey': rule(['common/mesh', 'common/records'], []),

    'worker/fill/mesh': rule(['common/mesh'], ['openmesh']),

    'worker/fill/region': rule(['common/mesh', 'common/mesh/triangulation'], []),

    'worker/fill/hole': rule(
        ['common/mesh', 'common/mesh/triangulation', 'common/records', 'worker/fill/region'],
        ['eigen']),

    'worker/fill/surface': rule(
        ['common/mesh', 'common/mesh/triangulation', 'common/records', 'worker/fill/hole'],
        ['eigen']),

    'worker/fill/shape': rule(
        ['common/mesh', 'common/mesh/triangulation', 'common/records', 'worker/fill/mesh', 'worker/fill/region'],
        ['eigen']),

    'worker/fill/space': rule(
        ['common/mesh', 'common/records', 'worker/fill/mesh', 'worker/fill/region', 'worker/fill/hole',
         'worker/fill/surface', 'worker/fill/shape'],
        ['eigen']),

    'worker/fill/plane': rule(
        ['common/mesh', 'common/mesh/winding', 'common/records', 'worker/fill/region', 'worker/fill/hole', 'worker/fill/surface',
         'worker/fill/shape', 'worker/fill/space'],
        []),

    'worker/fill/crease': rule(
        ['common/mesh', 'worker/fill/region', 'worker/fill/hole', 'worker/fill/space', 'worker/fill/plane'],
        ['eigen']),

    'worker/fill/seam': rule(
        ['common/mesh', 'common/mesh/winding', 'common/records', 'worker/fill/region', 'worker/fill/hole',
         'worker/fill/surface'],
        ['eigen']),

    'worker/fill': rule(
        ['common/records', 'worker/fill/hole', 'worker/fill/space', 'worker/fill/plane',
         'worker/fill/crease', 'worker/fill/seam'],
        []),

    # Production includes nothing of the papers; the programs hand them over (FillOptions::published).
    'worker/papers/wang': rule(
        ['common/mesh', 'common/mesh/triangulation', 'worker/fill/mesh', 'worker/fill/region', 'worker/fill/hole',
         'worker/fill/surface', 'worker/fill/shape', 'worker/fill/space'],
        ['eigen']),

    'worker/papers/front': rule(
        ['common/mesh', 'common/records', 'worker/fill/mesh', 'worker/fill/hole'],
        ['eigen']),

    'worker/papers': rule(['worker/fill/hole', 'worker/papers/front', 'worker/papers/wang'], []),

    'worker/check': rule(['common/mesh', 'worker/fill/space'], ['eigen'], pure=True),

    'worker/propose': rule(['common/mesh', 'common/records', 'worker/ground'], ['eigen'], pure=True),

    'worker/weld': rule(['common/mesh', 'common/records', 'worker/survey'], ['eigen'], pure=True),

    'worker/materials': rule(
        ['common/util', 'common/mesh', 'common/records', 'common/store', 'common/codec', 'common/codec/tree', 'common/image', 'worker/survey', 'worker/ground'],
        ['absl']),

    'worker/delivery': rule(
        ['common/util', 'common/mesh', 'common/image', 'common/codec', 'common/codec/gltf', 'common/codec/osgb', 'common/codec/tiles3d',
         'common/codec/tree', 'worker/materials'],
        ['absl', 'eigen']),

    'worker/texture': rule(['common/util', 'common/mesh', 'common/image'], ['eigen'], pure=True),

    'worker/service': rule(
        ['common/util', 'common/mesh', 'common/options', 'common/records', 'common/codec', 'common/store', 'common/metrics', 'common/rpc', 'worker/delivery', 'worker/papers', 'worker/survey', 'worker/ground',
         'worker/fill/hole', 'worker/fill/shape', 'worker/fill/space', 'worker/fill/seam', 'worker/fill', 'worker/materials', 'worker/texture', 'common/image'],
        ['absl', 'eigen', 'grpc', 'protobuf']),

    'worker': rule(['common/util', 'common/metrics', 'common/rpc', 'common/s3', 'common/service', 'worker/service'], ['absl']),

    'coordinator/plan/types': rule(['common/grid', 'common/records'], [], pure=True),

    'coordinator/plan/rim': rule(['common/mesh', 'common/records', 'coordinator/plan/types'], ['eigen'], pure=True),

    'coordinator/plan/seam': rule(
        ['common/mesh', 'common/mesh/winding', 'coordinator/plan/types', 'coordinator/plan/rim'], ['absl'], pure=True),

    'coordinator/plan/hole': rule(
        ['common/mesh', 'common/mesh/triangulation', 'common/records', 'coordinator/plan/types', 'coordinator/plan/rim'],
        ['eigen'], pure=True),

    'coordinator/plan/mesh': rule(
        ['common/mesh', 'common/records', 'coordinator/plan/types', 'coordinator/plan/rim', 'coordinator/plan/hole'],
        ['eigen'], pure=True),

    'coordinator/plan/overlap': rule(
        ['common/mesh', 'common/mesh/winding', 'common/records', 'coordinator/plan/types', 'coordinator/plan/rim',
         'coordinator/plan/seam'],
        ['eigen'], pure=True),

    'coordinator/plan/water': rule(
        ['common/mesh', 'common/grid', 'common/records', 'coordinator/plan/types', 'coordinator/plan/seam'],
        ['eigen'], pure=True),

    'coordinator/plan/colour': rule(['common/records', 'common/util', 'coordinator/plan/types'], [], pure=True),

    'coordinator/plan': rule(
        ['common/mesh', 'common/records', 'coordinator/plan/types', 'coordinator/plan/rim', 'coordinator/plan/seam',
         'coordinator/plan/hole', 'coordinator/plan/mesh', 'coordinator/plan/overlap', 'coordinator/plan/water'],
        [], pure=True),

    'coordinator/state': rule(['common/util', 'common/grid'], ['absl'], pure=True),

    'coordinator/journal': rule(
        ['common/util', 'common/store', 'common/grid', 'coordinator/state'], ['absl', 'postgres', 'sqlite']),

    'coordinator/waves': rule(
        ['common/mesh', 'common/grid', 'common/records', 'coordinator/plan/types', 'coordinator/plan/rim',
         'coordinator/plan/seam', 'coordinator/plan/water', 'coordinator/plan/colour', 'coordinator/plan'],
        ['absl', 'eigen'], pure=True),

    'coordinator/check': rule(['common/util', 'common/mesh', 'common/records'], ['absl', 'eigen'], pure=True),

    'coordinator/report': rule(
        ['common/util', 'common/mesh', 'common/mesh/winding', 'common/grid', 'common/gis', 'common/options', 'common/records', 'common/codec', 'common/codec/tiles3d', 'common/store',
         'coordinator/plan/types',
         'coordinator/waves'],
        ['absl', 'json']),

    'coordinator/store': rule(
        ['common/util', 'common/grid', 'common/records', 'common/store', 'common/rpc'], ['absl']),

    'coordinator/jobs': rule(
        ['common/util', 'common/mesh', 'common/grid', 'common/gis', 'common/options', 'common/records', 'common/codec', 'common/codec/tiles3d', 'common/store', 'common/metrics',
         'common/rpc', 'coordinator/state', 'coordinator/journal', 'coordinator/check', 'coordinator/waves', 'coordinator/report',
         'coordinator/store'],
        ['absl', 'eigen', 'protobuf']),

    'coordinator/api': rule(
        ['common/util', 'common/options', 'common/store', 'common/metrics', 'common/rpc', 'coordinator/state', 'coordinator/journal',
         'coordinator/store', 'coordinator/jobs'],
        ['absl', 'grpc', 'protobuf']),

    'coordinator/web': rule(
        ['common/util', 'common/http', 'common/grid', 'common/rpc', 'common/store', 'coordinator/api', 'coordinator/report'], ['absl', 'json', 'protobuf']),

    'coordinator': rule(
        ['common/util', 'common/metrics', 'common/rpc', 'common/s3', 'common/service', 'coordinator/journal', 'coordinator/jobs', 'coordinator/api', 'coordinator/web'],
        ['absl']),

    # One mesh in this process: geometry without a service. The Python module includes it as well.
    'client/mesh': rule(
        ['common/util', 'common/mesh', 'common/grid', 'common/options', 'common/records', 'common/codec', 'common/assemble',
         'worker/papers', 'worker/survey', 'worker/fill/shape', 'worker/fill/space', 'worker/fill', 'worker/check', 'worker/weld',
         'worker/materials', 'worker/service', 'coordinator/waves', 'coordinator/report'],
        ['absl', 'protobuf']),

    'python/binding': rule(['common/util', 'common/options', 'coordinator/report', 'client/mesh'], ['absl', 'pybind11']),

    # `tilemend run` holds a coordinator and a worker; it is the one place where the two meet.
    'client': rule(
        ['common/util', 'common/mesh', 'common/grid', 'common/gis', 'common/options', 'common/records', 'common/codec', 'common/codec/tiles3d', 'common/codec/tree', 'common/image', 'common/store', 'common/assemble', 'common/rpc', 'common/s3', 'worker/survey', 'worker/ground', 'worker/propose',
         'worker/check', 'worker/delivery', 'worker/materials', 'worker/service', 'client/mesh', 'coordinator/plan/rim', 'coordinator/waves', 'coordinator/report',
         'coordinator/jobs', 'coordinator/api'],
        ['absl', 'eigen', 'grpc', 'json', 'protobuf']),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
OURS = ('common/', 'worker/', 'coordinator/', 'client/', 'python/', 'tests/')


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


def arrows(files):
    """What is used: {rule: its folders' and libraries' names that an include points to}; of files as (path, text)."""
    used = {}
    for path, text in files:
        name = rule_of(os.path.dirname(path))
        targets = used.setdefault(name, set())
        for match in INCLUDE.finditer(text):
            header = match.group(2)
            target = rule_of(os.path.dirname(header)) if header.startswith(OURS) else library_of(header)
            if target and target != name:
                targets.add(target)
    return used


def check_unused(rules, used):
    """The rules without a source and the permissions that no include uses, as lines."""
    faults = [f'{name}: a rule without a source' for name in rules if name not in used]
    for name, targets in used.items():
        for target in sorted((rules[name]['folders'] | rules[name]['libraries']) - targets if name in rules else ()):
            faults.append(f'{name}: may include {target}, which no source does; take the permission away')
    return faults


def check_circles(used):
    """The circles of folders that include each other, as lines: from every folder back to itself, the shortest way."""
    faults = []
    for start in sorted(name for name in used if name):
        way = {target: [start] for target in sorted(used[start])}
        open_ends = sorted(used[start])
        for name in open_ends:
            for target in sorted(used.get(name, ())):
                if target not in way:
                    way[target] = way[name] + [name]
                    open_ends.append(target)
        if start in way and start == min(way[start]):  # each circle once
            faults.append('a circle of folders: ' + ' -> '.join(way[start] + [start]))
    return faults


def sources(root):
    for top in ('common', 'worker', 'coordinator', 'client', 'python'):
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in sorted(names):
                if name.endswith(('.cc', '.h')):
                    yield os.path.relpath(os.path.join(folder, name), root)


FORBIDDEN = [
    ('common/util/files.cc', 'common/mesh/tri_mesh.h'), ('common/mesh/a.h', 'common/grid/scene.h'),
    ('common/mesh/a.h', 'draco/mesh/mesh.h'), ('common/grid/a.cc', 'common/codec/mesh_file.h'),
    ('common/codec/a.cc', 'common/grid/scene.h'), ('worker/fill/a.cc', 'grpcpp/grpcpp.h'),
    ('worker/survey/a.cc', 'OpenMesh/Core/Mesh/PolyConnectivity.hh'), ('worker/survey/a.cc', 'worker/fill/a.h'),
    ('worker/survey/a.cc', 'prometheus/counter.h'), ('common/assemble/a.cc', 'worker/service/a.h'),
    ('worker/fill/a.cc', 'common/rpc/a.h'), ('worker/fill/a.cc', 'common/metrics/a.h'),
    ('worker/service/a.cc', 'coordinator/state/a.h'), ('coordinator/jobs/a.cc', 'worker/fill/a.h'),
    ('coordinator/plan/a.cc', 'filesystem'), ('coordinator/plan/a.cc', 'common/codec/mesh_file.h'),
    ('coordinator/state/a.cc', 'thread'), ('coordinator/state/a.h', 'absl/synchronization/mutex.h'),
    ('coordinator/state/a.cc', 'tilemend/v1/job.pb.h'), ('coordinator/state/a.cc', 'coordinator/jobs/a.h'),
    ('coordinator/jobs/a.cc', 'coordinator/api/a.h'), ('coordinator/store/a.cc', 'coordinator/jobs/a.h'),
    ('common/grid/a.cc', 'tests/support/scene_maker.h'), ('common/grid/a.cc', 'boost/graph.hpp'),
    ('common/newcomer/a.cc', 'vector'), ('worker/fill/hole/a.cc', 'worker/fill/fill_holes.h'),
    ('coordinator/plan/rim/a.cc', 'coordinator/plan/hole/a.h'), ('coordinator/plan/types/a.h', 'coordinator/plan/plan.h'),
    ('worker/fill/newcomer/a.cc', 'vector'),
]
ALLOWED = [
    ('common/mesh/a.h', 'Eigen/Core'), ('common/grid/a.cc', 'common/mesh/tri_mesh.h'), ('common/util/a.cc', 'sys/stat.h'),
    ('worker/fill/a.cc', 'worker/fill/hole/a.h'), ('worker/fill/a.cc', 'filesystem'), ('coordinator/plan/a.cc', 'map'),
    ('coordinator/plan/water/a.cc', 'coordinator/plan/seam/a.h'), ('worker/main.cc', 'worker/service/a.h'),
    ('client/a.cc', 'coordinator/api/a.h'), ('client/a.cc', 'worker/service/a.h'),
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
    return faults + check_arrows_itself()


def check_arrows_itself():
    text = '#include "common/grid/b.h"\n#include <Eigen/Core>\n#include <vector>\n#include "worker/survey/own.h"\n'
    used = arrows([('worker/survey/a.cc', text), ('worker/survey/a.h', ''), ('common/grid/a.cc', '')])
    faults = []
    if used != {'worker/survey': {'common/grid', 'eigen'}, 'common/grid': set()}:
        faults.append(f'self-check: arrows {used}')
    rules = {'worker/survey': rule(['common/grid', 'common/mesh'], ['eigen', 'absl']), 'common/grid': rule([], []),
             'client': rule([], [])}
    if (found := [f.split(':')[0] + f.split('include')[-1][:12] for f in check_unused(rules, used)]) != [
            'clientclient: a ru', 'worker/survey absl, which', 'worker/survey common/mesh']:
        faults.append(f'self-check: unused {found}')
    circles = check_circles({'a': {'b', 'd'}, 'b': {'c'}, 'c': {'a', 'd'}, 'd': {'e'}, 'e': set(), 'f': {'g'}, 'g': {'f'}})
    if circles != ['a circle of folders: a -> b -> c -> a', 'a circle of folders: f -> g -> f']:
        faults.append(f'self-check: circles {circles}')
    return faults


def check_names(files):
    """A type of one name in two headers: programs with both would mix their functions without a word."""
    where = {}
    for path, text in files:
        if path.endswith('.h'):
            for name in re.findall(r'^(?:struct|class|enum class) (\w+)[^;\n]*\{', text, re.M):
                where.setdefault(name, []).append(path)
    return [f'{" and ".join(paths)}: {name} is two types' for name, paths in sorted(where.items()) if len(paths) > 1]


def check_names_itself():
    found = check_names([('a.h', 'struct A {\nclass B final : public A {\nenum class C : int { k };\n'),
                         ('b.h', 'class A;\nclass B {\n  struct A {\n'), ('b.cc', 'enum class C {\n')])
    return [] if found == ['a.h and b.h: B is two types'] else [f'self-check: names {found}']


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    faults, files = check_itself(), []
    for path in sources(root):
        with open(os.path.join(root, path), encoding='utf-8') as file:
            files.append((path, file.read()))
    for path, text in files:
        faults += check_text(path, text)
    used = arrows(files)
    faults += check_unused(RULES, used) + check_circles(used) + check_names(files) + check_names_itself()
    if not files:
        faults.append(f'{root}: no sources found')
    for line in faults:
        print(line)
    print(f'{len(files)} files, {len(faults)} faults')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
