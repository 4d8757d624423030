#!/usr/bin/env python3
"""Holds docs/api.md to the protocol, to the table of roles and to the errors that the sources make."""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SOURCES = ('common', 'worker', 'coordinator')
faults = []


def read(*path):
    with open(os.path.join(ROOT, *path)) as file:
        return file.read()


def files(top, ending):
    for base, _, names in os.walk(os.path.join(ROOT, top)):
        for name in sorted(names):
            if name.endswith(ending):
                yield os.path.relpath(os.path.join(base, name), ROOT)


def call_items(page):
    """{call: (role, what is said, errors)} of the items under "Calls"."""
    found = re.findall(r'^- `([\w.]+/\w+)` \((\w+)\): (.+?)(?:\. Errors: (.+))?$', page, re.M)
    return {call: (role, what, errors) for call, role, what, errors in found}


def error_items(page):
    """{reason: (code, facts, what is said)} of the items under "Errors"."""
    found = re.findall(r'^- `([A-Z_]+)` \(([A-Z_]+)(?:; ([^)]*))?\): (.+)$', page, re.M)
    return {reason: (code, facts, what) for reason, code, facts, what in found}


def quoted(text):
    return re.findall(r'`([^`]+)`', text)


def rpcs():
    """{call: reasons in its comment} of all services."""
    found = {}
    for path in files('proto', '.proto'):
        text = read(path)
        package = re.search(r'package ([\w.]+);', text).group(1)
        for service, body in re.findall(r'service (\w+) \{(.*?)\n\}', text, re.S):
            for comment, name in re.findall(r'((?:  //[^\n]*\n)+)  rpc (\w+)', body):
                found[f'{package}.{service}/{name}'] = set(re.findall(r'\b[A-Z]+_[A-Z_]+\b', comment)) & set(reasons())
    return found


def reasons():
    """{reason: (codes, facts)} as the sources attach them."""
    found = {}
    for path in (path for top in SOURCES for path in files(top, ('.cc', '.h'))):
        text = read(path)
        for match in re.finditer(r'\{"([A-Z]{3,}[A-Z_]*)",\s*\{', text):
            made = re.findall(r'absl::(\w+)Error\(', text[:match.start()])
            facts = re.findall(r'\{"(\w+)",', text[match.end() - 1:text.index(';', match.end())])
            codes, all_facts = found.setdefault(match.group(1), (set(), set()))
            codes.add(re.sub(r'(?<=[a-z])(?=[A-Z])', '_', made[-1]).upper())
            all_facts.update(facts)
    return found


def check(condition, text):
    if not condition:
        faults.append(text)


def main():
    page, known, calls = read('docs/api.md'), reasons(), rpcs()
    roles = dict(re.findall(r'\{"([\w.]+/\w+)", Role::k(\w+)\}', read('coordinator/api/access.cc')))
    listed = call_items(page)
    check(set(listed) == set(calls), f'calls: {set(listed) ^ set(calls)}')
    for call in set(listed) & set(calls):
        role, what, errors = listed[call]
        check(role == roles[call].lower(), f'{call}: role {role}, not {roles[call]}')
        check(what, f'{call}: nothing is said of it')
        check(set(quoted(errors)) <= set(known), f'{call}: {set(quoted(errors)) - set(known)}')
        check(calls[call] <= set(quoted(errors)), f'{call}: the protocol has {calls[call] - set(quoted(errors))} as well')
    errors = error_items(page)
    check(set(errors) == set(known), f'reasons: {set(errors) ^ set(known)}')
    for reason in set(errors) & set(known):
        code, facts, what = errors[reason]
        codes, attached = known[reason]
        check({code} == codes, f'{reason}: code {code}, not {codes}')
        check(set(facts.split(', ')) - {''} == attached, f'{reason}: facts {facts}, not {attached}')
        check(what, f'{reason}: nothing is said of it')
    comment = read('proto/tilemend/v1/error_info.proto')
    in_proto = set(re.findall(r'^//   ([A-Z_]+) ', comment, re.M))
    local = {r for r, (_, _, what) in errors.items() if what.startswith('of the program')}
    check(in_proto == set(known) - local, f'error_info.proto: {in_proto ^ (set(known) - local)}')
    if faults:
        sys.exit('FAILED\n' + '\n'.join(faults))
    print(f'{len(calls)} calls, {len(known)} reasons: passed')


if __name__ == '__main__':
    main()
