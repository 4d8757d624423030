#!/usr/bin/env python3
"""Holds the manifests of deploy/kubernetes and the dashboard to the schemas that Kubernetes, KEDA and Grafana publish.

    schemas_test.py FOLDER

The schemas are packages of npm, in the versions of schemas/package-lock.json; FOLDER gets them and keeps them. Types
are checked by the TypeScript compiler, which knows no field that a schema has not, and values by Kubernetes' own
validation. Before that, faults are put into copies, and each must be found. Exit code 77 (skipped, and says so) without
npm, its registry or python3-yaml.
"""
import copy
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PACKAGES = os.path.join(HERE, 'schemas')
sys.path.insert(0, os.path.join(ROOT, 'tests/web'))
from npm_packages import install, skip  # noqa: E402

GROUPS = {'v1': 'kubernetes-models/v1', 'apps/v1': 'kubernetes-models/apps/v1', 'policy/v1': 'kubernetes-models/policy/v1',
          'networking.k8s.io/v1': 'kubernetes-models/networking.k8s.io/v1',
          'keda.sh/v1alpha1': '@kubernetes-models/keda/keda.sh/v1alpha1'}
# The defaults of options may be left out.
GRAFANA = '''import type {Dashboard, VizLegendOptions, TooltipDisplayMode} from '@grafana/schema';
type Options = {legend?: Partial<VizLegendOptions>, tooltip?: {mode?: `${TooltipDisplayMode}`}};
'''


def run(*words, cwd=None, timeout=300):
    return subprocess.run(words, cwd=cwd, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=timeout)


def load_manifests():
    import yaml
    base = os.path.join(ROOT, 'deploy/kubernetes/base')
    with open(os.path.join(base, 'kustomization.yaml')) as file:
        names = yaml.safe_load(file)['resources']
    objects = []
    for name in names:
        with open(os.path.join(base, name)) as file:
            objects += [document for document in yaml.safe_load_all(file) if document]
    return objects


def load_dashboard():
    with open(os.path.join(ROOT, 'deploy/grafana/tilemend.json')) as file:
        return json.load(file)


def program_of(objects, dashboard):
    """TypeScript that is in order where these are; its values are checked when it runs."""
    lines = [GRAFANA]
    for i, one in enumerate(objects):
        kind = one['kind']
        lines.append(f"import {{{kind} as K{i}}} from '{GROUPS[one['apiVersion']]}/{kind}';")
        lines.append(f"import type {{I{kind} as I{i}}} from '{GROUPS[one['apiVersion']]}/{kind}';")
        lines.append(f'const o{i}: I{i} = {json.dumps(one)};\nnew K{i}(o{i}).validate();')
    lines.append(f'export const dashboard: Dashboard = {json.dumps(dashboard)};')
    for panel in dashboard['panels']:
        if 'options' in panel:
            lines.append(f'export const p{panel["id"]}: Options = {json.dumps(panel["options"])};')
    return '\n'.join(lines)


def faults_of(folder, programs):
    """What the compiler says of each program or, of those in order, its values when it runs; '' if nothing."""
    with tempfile.TemporaryDirectory(dir=folder) as inner:
        for name, text in programs.items():
            with open(os.path.join(inner, name + '.ts'), 'w') as file:
                file.write(text)
        compiled = run(os.path.join(folder, 'node_modules/.bin/tsc'), '--strict', '--skipLibCheck', '--module', 'commonjs',
                       '--target', 'es2020', '--moduleResolution', 'node', *(name + '.ts' for name in programs), cwd=inner)
        faults = {name: '\n'.join(re.findall(rf'^{name}\.ts.*', compiled.stdout, re.M)) for name in programs}
        if compiled.returncode and not any(faults.values()):
            sys.exit(f'FAILED: the compiler: {compiled.stdout}')
        for name in programs:
            if not faults[name]:
                ran = run('node', name + '.js', cwd=inner)
                faults[name] = ran.stdout if ran.returncode else ''
    return faults


def spoilt(objects, dashboard):
    """(what was done, manifests, dashboard) with one fault each."""
    def manifest(kind, change):
        them = copy.deepcopy(objects)
        change(next(o for o in them if o['kind'] == kind))
        return them

    def panel(change):
        it = copy.deepcopy(dashboard)
        change(next(p for p in it['panels'] if p['type'] == 'timeseries'))
        return it

    container = lambda o: o['spec']['template']['spec']['containers'][0]
    yield 'a field that there is not', manifest('Deployment', lambda o: container(o).update(readynessProbe={})), dashboard
    yield 'a word for a number', manifest('StatefulSet', lambda o: o['spec'].update(replicas='one')), dashboard
    yield 'a word that is none of those', manifest('Deployment', lambda o: o['spec']['strategy'].update(type='Roling')), dashboard
    yield 'no selector', manifest('Deployment', lambda o: o['spec'].pop('selector')), dashboard
    yield "a field of KEDA's that there is not", manifest('ScaledObject', lambda o: o['spec'].update(minReplicas=0)), dashboard
    yield 'a legend at no side', objects, panel(lambda p: p['options']['legend'].update(placement='middle'))
    yield 'a panel without its kind', objects, panel(lambda p: p.pop('type'))


def main():
    if not shutil.which('npm') or importlib.util.find_spec('yaml') is None:
        skip('there is no npm or no python3-yaml')
    folder = os.path.abspath(sys.argv[1])
    install(folder, PACKAGES)
    objects, dashboard = load_manifests(), load_dashboard()
    cases = {f'fault{i}': case for i, case in enumerate(spoilt(objects, dashboard))}
    programs = {name: program_of(*them) for name, (_, *them) in cases.items()}
    faults = faults_of(folder, dict(programs, ours=program_of(objects, dashboard)))
    ours = faults.pop('ours')
    if ours:
        sys.exit('FAILED\n' + ours)
    missed = [cases[name][0] for name, fault in faults.items() if not fault]
    if missed:
        sys.exit(f'FAILED: not found: {missed}')
    print(f'{len(objects)} manifests and a dashboard of {len(dashboard["panels"])} panels: passed, {len(cases)} faults found')


if __name__ == '__main__':
    main()
