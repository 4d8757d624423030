#!/usr/bin/env python3
"""Lints the protocol by rules that have the names of those of `buf lint`: lint_protos.py [ROOT]

Needs protoc and Debian's python3-protobuf. EXEMPT lists what is as it is for a reason; an exemption that nothing needs is
a fault, too.
"""
import os
import re
import subprocess
import sys
import tempfile

from google.protobuf import descriptor_pb2

# {rule: {what it is for, or the beginning of it followed by *: why}}
KEDA = 'is as KEDA publishes it'
OLD = 'is on the wire and in files already; the enum is small'
AIP = 'gives the resource itself (google.aip.dev/131 to 136)'
EXEMPT = {
    'FIELD_LOWER_SNAKE_CASE': {'externalscaler.*': KEDA},
    'PACKAGE_VERSION_SUFFIX': {'externalscaler': KEDA},
    'RPC_REQUEST_STANDARD_NAME': {'externalscaler.*': KEDA},
    'RPC_RESPONSE_STANDARD_NAME': {
        'externalscaler.*': KEDA, 'tilemend.v1.Jobs.CreateJob': AIP, 'tilemend.v1.Jobs.GetJob': AIP,
        'tilemend.v1.Jobs.WatchJob': AIP, 'tilemend.v1.Jobs.CancelJob': AIP, 'tilemend.v1.Jobs.RetryJob': AIP,
        'tilemend.v1.Jobs.PauseJob': AIP, 'tilemend.v1.Jobs.ResumeJob': AIP, 'tilemend.v1.Jobs.PrioritizeJob': AIP,
        'tilemend.v1.Work.ReadBlob': 'streams chunks'},
    'ENUM_VALUE_PREFIX': {'tilemend.v1.JobState': OLD, 'tilemend.v1.WorkerState': OLD, 'tilemend.v1.Stage': OLD},
    'ENUM_ZERO_VALUE_SUFFIX': {'tilemend.v1.FillWay': 'none is a value, not the want of one'},
}
# Fields of these numbers in google.protobuf's descriptors, for the places of comments.
SERVICE, METHOD, MESSAGE = 6, 2, 4

PASCAL = re.compile(r'[A-Z][A-Za-z0-9]*')
SNAKE = re.compile(r'[a-z][a-z0-9]*(_[a-z0-9]+)*')
UPPER = re.compile(r'[A-Z][A-Z0-9]*(_[A-Z0-9]+)*')


def upper_snake(name):
    return re.sub(r'(?<=[a-z0-9])(?=[A-Z])', '_', name).upper()


def check_package(file):
    yield 'PACKAGE_DIRECTORY_MATCH', file.package, os.path.dirname(file.name) == file.package.replace('.', '/')
    yield 'PACKAGE_VERSION_SUFFIX', file.package, re.search(r'\.v[1-9]\d*$', file.package)
    yield 'FILE_LOWER_SNAKE_CASE', file.name, SNAKE.fullmatch(os.path.basename(file.name).removesuffix('.proto'))
    yield 'SYNTAX_SPECIFIED', file.name, file.syntax == 'proto3'
    yield 'IMPORT_NO_PUBLIC', file.name, not file.public_dependency
    yield 'IMPORT_NO_WEAK', file.name, not file.weak_dependency


def check_message(scope, message):
    name = f'{scope}.{message.name}'
    if message.options.map_entry:
        return
    yield 'MESSAGE_PASCAL_CASE', name, PASCAL.fullmatch(message.name)
    for field in message.field:
        yield 'FIELD_LOWER_SNAKE_CASE', f'{name}.{field.name}', SNAKE.fullmatch(field.name)
        yield 'FIELD_NO_DESCRIPTOR', f'{name}.{field.name}', field.name.strip('_') != 'descriptor'
        yield 'FIELD_NOT_REQUIRED', f'{name}.{field.name}', field.label != field.LABEL_REQUIRED
    for oneof in message.oneof_decl:
        yield 'ONEOF_LOWER_SNAKE_CASE', f'{name}.{oneof.name}', SNAKE.fullmatch(oneof.name.removeprefix('_'))
    for enum in message.enum_type:
        yield from check_enum(name, enum)
    for nested in message.nested_type:
        yield from check_message(name, nested)


def check_enum(scope, enum):
    name = f'{scope}.{enum.name}'
    yield 'ENUM_PASCAL_CASE', name, PASCAL.fullmatch(enum.name)
    yield 'ENUM_NO_ALLOW_ALIAS', name, not enum.options.allow_alias
    yield 'ENUM_FIRST_VALUE_ZERO', name, enum.value[0].number == 0
    yield 'ENUM_ZERO_VALUE_SUFFIX', name, enum.value[0].name.endswith('_UNSPECIFIED')
    yield 'ENUM_VALUE_PREFIX', name, all(v.name.startswith(upper_snake(enum.name) + '_') for v in enum.value)
    for value in enum.value:
        yield 'ENUM_VALUE_UPPER_SNAKE_CASE', f'{name}.{value.name}', UPPER.fullmatch(value.name)


def check_service(file, number, service):
    name = f'{file.package}.{service.name}'
    comments = {tuple(l.path): l.leading_comments for l in file.source_code_info.location}
    yield 'SERVICE_PASCAL_CASE', name, PASCAL.fullmatch(service.name)
    for i, rpc in enumerate(service.method):
        full = f'{name}.{rpc.name}'
        yield 'RPC_PASCAL_CASE', full, PASCAL.fullmatch(rpc.name)
        yield 'RPC_REQUEST_STANDARD_NAME', full, rpc.input_type == f'.{file.package}.{rpc.name}Request'
        yield 'RPC_RESPONSE_STANDARD_NAME', full, rpc.output_type == f'.{file.package}.{rpc.name}Response'
        yield 'COMMENT_RPC', full, comments.get((SERVICE, number, METHOD, i), '').strip()


def check_file(file):
    """(rule, what, whether it keeps to it) for everything in a file."""
    yield 'PACKAGE_DEFINED', file.name, file.package
    yield from check_package(file)
    for message in file.message_type:
        yield from check_message(file.package, message)
    for enum in file.enum_type:
        yield from check_enum(file.package, enum)
    for number, service in enumerate(file.service):
        yield from check_service(file, number, service)


def exemption(rule, what):
    """The name under which `what` need not keep to the rule, None if it must."""
    for name in EXEMPT.get(rule, ()):
        if name == what or (name.endswith('*') and what.startswith(name[:-1])):
            return name
    return None


def check_files(files):
    """Faults as lines, and how many checks there were."""
    faults, checks, used = [], 0, set()
    for file in files:
        for rule, what, good in check_file(file):
            checks += 1
            name = None if good else exemption(rule, what)
            if name:
                used.add((rule, name))
            elif not good:
                faults.append(f'{file.name}: {what}: {rule}')
    for rule, names in EXEMPT.items():
        faults += [f'{rule}: nothing needs the exemption of {name}' for name in names if (rule, name) not in used]
    return faults, checks


def parse(root, names):
    """Descriptors of the files, and what protoc warns of (IMPORT_USED among it)."""
    with tempfile.NamedTemporaryFile() as out:
        done = subprocess.run(['protoc', '-I', root, '--include_source_info', f'--descriptor_set_out={out.name}', *names],
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode:
            sys.exit(done.stdout)
        files = descriptor_pb2.FileDescriptorSet.FromString(out.read()).file
    return [f for f in files if f.name in names], done.stdout.splitlines()


BAD = '''syntax = "proto3";
package wrong;
import "google/protobuf/any.proto";
message bad_name { int32 BadField = 1; }
enum Colour { RED = 0; }
service s { rpc do(bad_name) returns (bad_name); }
'''
OF_BAD = {'PACKAGE_DIRECTORY_MATCH', 'PACKAGE_VERSION_SUFFIX', 'MESSAGE_PASCAL_CASE', 'FIELD_LOWER_SNAKE_CASE',
          'ENUM_ZERO_VALUE_SUFFIX', 'ENUM_VALUE_PREFIX', 'SERVICE_PASCAL_CASE', 'RPC_PASCAL_CASE',
          'RPC_REQUEST_STANDARD_NAME', 'RPC_RESPONSE_STANDARD_NAME', 'COMMENT_RPC'}


def check_itself():
    """Faults of this script: rules that let a bad file pass."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, 'bad.proto'), 'w') as file:
            file.write(BAD)
        files, warnings = parse(folder, ['bad.proto'])
    found = {line.split(': ')[-1] for line in check_files(files)[0]}
    faults = [f'self-check: {rule} lets a bad file pass' for rule in sorted(OF_BAD - found)]
    return faults + ([] if 'is unused' in ''.join(warnings) else ['self-check: an unused import passes'])


def main():
    root = os.path.join(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'proto')
    names = sorted(os.path.relpath(os.path.join(base, name), root)
                   for base, _, files in os.walk(root) for name in files if name.endswith('.proto'))
    files, warnings = parse(root, names)
    faults, checks = check_files(files)
    faults += warnings + check_itself()
    for line in faults:
        print(line)
    print(f'{len(files)} files, {checks} checks, {len(faults)} faults')
    sys.exit(1 if faults or not files else 0)


if __name__ == '__main__':
    main()
