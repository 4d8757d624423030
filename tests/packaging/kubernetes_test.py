#!/usr/bin/env python3
"""Holds the manifests of deploy/kubernetes to themselves, to the programs and to what they say of KEDA.

    kubernetes_test.py BIN

Builds both folders as Kustomize does (with kubectl, if it is there, as well), checks that everything that is named is
there, and runs the commands of the pods on this machine: a coordinator and a worker with certificates of the trial,
with the probes of the manifests, a client in KEDA's words, and the end of a pod. Exit code 77 (skipped, and says so)
without Debian's python3-yaml or openssl.
"""
import importlib.util
import json
import os
import re
import shutil
import signal
import ssl
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER = os.path.join(ROOT, 'deploy/kubernetes')
SECRET_KEYS = {'ca.crt', 'tls.crt', 'tls.key'}
faults = []


def check(condition, text):
    if not condition:
        faults.append(text)


def load(path):
    import yaml
    with open(path) as file:
        return [document for document in yaml.safe_load_all(file) if document]


def build(folder):
    """All objects of a kustomization, with its namespace, images and secrets, as far as ours go."""
    (kustomization,) = load(os.path.join(folder, 'kustomization.yaml'))
    known = {'apiVersion', 'kind', 'namespace', 'resources', 'labels', 'images', 'generatorOptions', 'secretGenerator'}
    check(set(kustomization) <= known, f'{folder}: this test does not know {set(kustomization) - known}')
    objects = []
    for name in kustomization['resources']:
        path = os.path.normpath(os.path.join(folder, name))
        check(os.path.exists(path), f'{path}: is not there')
        objects += build(path) if os.path.isdir(path) else load(path)
    listed = {os.path.normpath(os.path.join(folder, name)) for name in kustomization['resources']}
    for name in os.listdir(folder):
        path = os.path.normpath(os.path.join(folder, name))
        if name.endswith('.yaml') and name != 'kustomization.yaml':
            check(path in listed, f'{path}: no resource of its kustomization')
    for generator in kustomization.get('secretGenerator', []):
        objects.append({'kind': 'Secret', 'metadata': {'name': generator['name']}, 'type': generator['type'],
                        'keys': {file.split('=')[0] for file in generator['files']}})
    for one in objects:
        if one['kind'] != 'Namespace':
            one['metadata'].setdefault('namespace', kustomization['namespace'])
    return objects


def matches(selector, labels):
    """Whether a selector of labels takes a pod."""
    for key, value in selector.get('matchLabels', {}).items():
        if labels.get(key) != value:
            return False
    return all(labels.get(e['key']) in e['values'] for e in selector.get('matchExpressions', []))


def of_kind(objects, kind):
    return {o['metadata']['name']: o for o in objects if o['kind'] == kind}


def pods_of(objects):
    return {name: o for kind in ('StatefulSet', 'Deployment') for name, o in of_kind(objects, kind).items()}


def check_owner(name, owner, objects):
    template = owner['spec']['template']
    check(matches(owner['spec']['selector'], template['metadata']['labels']), f'{name}: its selector does not take its own pods')
    check_pod(name, template['spec'], owner['spec'].get('volumeClaimTemplates', []), objects)


def check_pod(name, pod, own_claims, objects):
    volumes = {v['name']: v for v in pod['volumes']}
    volumes.update({c['metadata']['name']: c for c in own_claims})
    (container,) = pod['containers']
    mounted = {m['name'] for m in container['volumeMounts']}
    check(mounted == set(volumes), f'{name}: volumes {set(volumes)}, mounted {mounted}')
    for volume in volumes.values():
        if 'persistentVolumeClaim' in volume:
            claim = volume['persistentVolumeClaim']['claimName']
            check(claim in of_kind(objects, 'PersistentVolumeClaim'), f'{name}: no claim {claim}')
        if 'secret' in volume:
            secret = of_kind(objects, 'Secret').get(volume['secret']['secretName'])
            check(secret and secret['keys'] == SECRET_KEYS, f'{name}: no secret {volume["secret"]["secretName"]}')
    check_security(name, pod, container)
    check_ports(name, container)
    check(container['image'] == 'tilemend', f'{name}: image {container["image"]}')


def check_security(name, pod, container):
    rules, own = pod['securityContext'], container['securityContext']
    check(rules['runAsNonRoot'] and rules['runAsUser'] == 10001, f'{name}: runs as root')
    check(rules['seccompProfile'] == {'type': 'RuntimeDefault'}, f'{name}: no seccomp profile')
    check(own == {'allowPrivilegeEscalation': False, 'readOnlyRootFilesystem': True, 'capabilities': {'drop': ['ALL']}},
          f'{name}: {own}')
    check(not pod['automountServiceAccountToken'], f'{name}: has a token of the cluster')
    check('memory' in container['resources']['limits'], f'{name}: no limit of memory')


def check_ports(name, container):
    ports = {p['name']: p['containerPort'] for p in container.get('ports', [])}
    flags = flags_of(container)
    for flag, port in (('listen', 'grpc'), ('metrics', 'metrics')):
        if flag in flags:
            check(flags[flag].endswith(f':{ports.get(port)}'), f'{name}: --{flag} {flags[flag]}, port {ports.get(port)}')
    for probe in ('startupProbe', 'livenessProbe', 'readinessProbe'):
        if probe in container:
            get = container[probe]['httpGet']
            check(get['port'] in ports and get['path'] in ('/healthz', '/readyz'), f'{name}: {probe} {get}')
            check((get['scheme'] == 'HTTPS') == ('metrics-tls' in flags), f'{name}: {probe}: scheme')
    paths = [m['mountPath'] for m in container['volumeMounts']]
    for flag in ('work', 'root', 'tls-ca', 'tls-cert', 'tls-key'):
        if flag in flags:
            check(any(flags[flag].startswith(path) for path in paths), f'{name}: --{flag} {flags[flag]}: not mounted')
    variables = {v['name']: v['value'] for v in container.get('env', [])}
    temporary = variables.get('TMPDIR', '/work')  # as docker/Dockerfile
    check(temporary in paths, f'{name}: TMPDIR {temporary}: not mounted')


def flags_of(container):
    words = [argument[2:].partition('=') for argument in container.get('args', [])]
    return {name: value for name, _, value in words}


def check_names(objects):
    """Selectors, names and ports that one object has of another."""
    pods = pods_of(objects)
    labels = {name: o['spec']['template']['metadata']['labels'] for name, o in pods.items()}
    ports = {name: {p['name']: p['containerPort'] for p in o['spec']['template']['spec']['containers'][0]['ports']}
             for name, o in pods.items()}
    for name, service in of_kind(objects, 'Service').items():
        taken = [pod for pod in pods if matches({'matchLabels': service['spec']['selector']}, labels[pod])]
        check(taken == [name], f'service {name} takes {taken}')
        for port in service['spec']['ports']:
            check(ports[name].get(port['targetPort']) == port['port'], f'service {name}: port {port}')
    for name, budget in of_kind(objects, 'PodDisruptionBudget').items():
        check([p for p in pods if matches(budget['spec']['selector'], labels[p])] == [name], f'budget {name}')
    for name, policy in of_kind(objects, 'NetworkPolicy').items():
        spec = policy['spec']
        taken = [pod for pod in pods if matches(spec['podSelector'], labels[pod])]
        check(taken, f'policy {name} takes no pod')
        for rule in spec.get('ingress', []):
            for port in rule['ports']:
                check(all(port['port'] in ports[pod] for pod in taken), f'policy {name}: port {port["port"]}')
    policies = of_kind(objects, 'NetworkPolicy')
    check(set(policies['tilemend-none']['spec']) == {'podSelector', 'policyTypes'}, 'policy tilemend-none lets some in')
    for name, one in of_kind(objects, 'StatefulSet').items():
        check(one['spec']['serviceName'] in of_kind(objects, 'Service'), f'{name}: no service')


def check_scaling(objects):
    (scaled,) = of_kind(objects, 'ScaledObject').values()
    target = of_kind(objects, scaled['spec']['scaleTargetRef']['kind']).get(scaled['spec']['scaleTargetRef']['name'])
    check(target, 'the scaled object has no target')
    check('replicas' not in target['spec'], 'both KEDA and the deployment say how many workers there are')
    (trigger,) = scaled['spec']['triggers']
    (worker,) = target['spec']['template']['spec']['containers']
    check(trigger['type'] == 'external-push', 'trigger')
    check(trigger['metadata']['slots'] == flags_of(worker)['threads'], 'slots are not the threads of a worker')
    host, port = trigger['metadata']['scalerAddress'].rsplit(':', 1)
    name, namespace, _ = host.split('.')
    service = of_kind(objects, 'Service').get(name)
    check(service and service['metadata']['namespace'] == namespace, f'no service {host}')
    check(int(port) in [p['port'] for p in service['spec']['ports']], f'no port {port}')
    check(flags_of(worker)['coordinator'] == f'{name}:{port}', 'workers call another coordinator')
    auth = of_kind(objects, 'TriggerAuthentication')[trigger['authenticationRef']['name']]
    secrets = of_kind(objects, 'Secret')
    for reference in auth['spec']['secretTargetRef']:
        check(reference['key'] in secrets[reference['name']]['keys'], f'{reference}')
    check({r['parameter'] for r in auth['spec']['secretTargetRef']} == {'caCert', 'tlsClientCert', 'tlsClientKey'},
          'KEDA has no certificate')
    hook = worker['lifecycle']['preStop']['exec']['command']
    check(int(hook[1]) < target['spec']['template']['spec']['terminationGracePeriodSeconds'],
          'the grace period ends before the hook')
    with open(os.path.join(ROOT, 'CMakeLists.txt')) as file:
        check(os.path.basename(hook[0]) in re.findall(r'docker/(\w+)', file.read()), f'{hook[0]} is not installed')


def check_against_kubectl(folder, objects):
    if not shutil.which('kubectl'):
        print('SKIPPED in part: no kubectl, which builds kustomizations')
        return
    import yaml
    done = subprocess.run(['kubectl', 'kustomize', folder], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    check(done.returncode == 0, f'kubectl kustomize {folder}: {done.stderr}')
    built = [d for d in yaml.safe_load_all(done.stdout) if d]
    names = lambda them: sorted((o['kind'], o['metadata'].get('namespace', ''), o['metadata']['name']) for o in them)
    check(names(built) == names(objects), f'kubectl builds {names(built)}, not {names(objects)}')
    check(not re.search(r'image: tilemend\b', done.stdout), f'{folder}: an image without its registry')


class Pod:
    """The command of a pod, with its folders and ports elsewhere."""

    def __init__(self, container, bin_folder, folders, changes):
        words = []
        for argument in container['args']:
            name, equals, value = argument.partition('=')
            for path, folder in folders.items():
                if value.startswith(path):
                    value = folder + value[len(path):]
            words.append(name + equals + changes.get(name, value))
        self.program = subprocess.Popen([os.path.join(bin_folder, container['command'][0]), *words],
                                        stderr=subprocess.PIPE, text=True)
        self.container, self.ports = container, {}

    def await_events(self, *events):
        """Takes the addresses that the log tells."""
        wanted = set(events)
        for line in self.program.stderr:
            entry = json.loads(line)
            if 'address' in entry:
                self.ports[entry['event']] = entry['address'].rsplit(':', 1)[1]
            wanted.discard(entry['event'])
            if not wanted:
                return
        raise SystemExit(f'FAILED: {self.container["name"]} ended before {wanted}')

    def probe(self, name):
        """The status of a probe: as the kubelet, without looking at the certificate."""
        get = self.container[name]['httpGet']
        context = ssl.create_default_context()
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
        url = f'{get["scheme"].lower()}://127.0.0.1:{self.ports["metrics served"]}{get["path"]}'
        try:
            return urllib.request.urlopen(url, context=context, timeout=5).status
        except urllib.error.HTTPError as error:
            return error.code

    def await_probe(self, name):
        end = time.monotonic() + 30
        while time.monotonic() < end:
            if self.probe(name) == 200:
                return
            time.sleep(0.1)
        check(False, f'{self.container["name"]}: {name} never said yes')


def ask_as_keda(address, tls):
    """(whether it is active, the metric's value, a worker's share), over mutual TLS with the certificate of KEDA."""
    plugin = shutil.which('grpc_python_plugin')
    if not plugin or any(importlib.util.find_spec(name) is None for name in ('grpc', 'google.protobuf')):
        print('SKIPPED in part: KEDA\'s client needs protoc\'s plugin for Python, grpc and protobuf')
        return (False, 0, 4)
    import grpc
    generated = tempfile.mkdtemp(dir=tls)
    subprocess.run(['protoc', '-I', os.path.join(ROOT, 'proto/externalscaler'), f'--python_out={generated}',
                    f'--grpc_out={generated}', f'--plugin=protoc-gen-grpc={plugin}', 'externalscaler.proto'], check=True)
    sys.path.insert(0, generated)
    import externalscaler_pb2 as messages
    import externalscaler_pb2_grpc as service
    read = lambda name: open(os.path.join(tls, name), 'rb').read()
    credentials = grpc.ssl_channel_credentials(read('ca.pem'), read('scale.key'), read('scale.pem'))
    with grpc.secure_channel(address, credentials) as channel:
        scaler = service.ExternalScalerStub(channel)
        target = messages.ScaledObjectRef(name='tilemend-worker', namespace='tilemend', scalerMetadata={'slots': '4'})
        (spec,) = scaler.GetMetricSpec(target).metricSpecs
        request = messages.GetMetricsRequest(scaledObjectRef=target, metricName=spec.metricName)
        (value,) = scaler.GetMetrics(request).metricValues
        return (scaler.IsActive(target).result, value.metricValueFloat, spec.targetSizeFloat)


def run_pods(bin_folder, objects):
    containers = {n: o['spec']['template']['spec']['containers'][0] for n, o in pods_of(objects).items()}
    with tempfile.TemporaryDirectory(prefix='tilemend-pods-') as folder:
        tls = os.path.join(folder, 'authority')
        subprocess.run([os.path.join(ROOT, 'scripts/make_certificates.sh'), tls], check=True,
                       stderr=subprocess.DEVNULL)
        for pod, name in (('coordinator', 'coordinator'), ('worker', 'worker')):
            mount = os.path.join(folder, pod, 'tls')
            os.makedirs(mount)
            for key, file in (('ca.crt', 'ca.pem'), ('tls.crt', f'{name}.pem'), ('tls.key', f'{name}.key')):
                shutil.copy(os.path.join(tls, file), os.path.join(mount, key))
        data = os.path.join(folder, 'data')
        os.makedirs(data)
        folders = lambda pod: {'/tls': os.path.join(folder, pod, 'tls'), '/data': data,
                               '/work': os.path.join(folder, pod, 'work')}
        pods = []
        try:
            run_cluster(bin_folder, containers, folders, tls, pods)
        finally:
            for pod in pods:
                pod.program.kill()
                pod.program.wait()


def run_cluster(bin_folder, containers, folders, tls, pods):
    local = {'--listen': '127.0.0.1:0', '--metrics': '127.0.0.1:0'}
    coordinator = Pod(containers['tilemend-coordinator'], bin_folder, folders('coordinator'), local)
    pods.append(coordinator)
    coordinator.await_events('metrics served', 'listening')
    for probe in ('startupProbe', 'livenessProbe', 'readinessProbe'):
        coordinator.await_probe(probe)
    port = coordinator.ports['listening']
    answer = ask_as_keda(f'localhost:{port}', tls)
    check(answer == (False, 0, 4), f'KEDA hears {answer} of a cluster without jobs')
    worker = Pod(containers['tilemend-worker'], bin_folder, folders('worker'),
                 dict(local, **{'--coordinator': f'localhost:{port}'}))
    pods.append(worker)
    worker.await_events('metrics served')
    for probe in ('livenessProbe', 'readinessProbe'):
        worker.await_probe(probe)
    hook = containers['tilemend-worker']['lifecycle']['preStop']['exec']['command']
    script = os.path.join(ROOT, 'docker', os.path.basename(hook[0]))
    with subprocess.Popen([script, hook[1], str(worker.program.pid)]) as ending:
        check(worker.program.wait(30) == 0, 'a worker with nothing to do does not leave in good order')
        check(ending.wait(30) == 0, 'the hook does not end with the worker')
    coordinator.program.send_signal(signal.SIGTERM)
    check(coordinator.program.wait(30) == 0, 'the coordinator does not end in good order')


def main():
    if importlib.util.find_spec('yaml') is None or not shutil.which('openssl'):
        print('SKIPPED: needs python3-yaml and openssl')
        sys.exit(77)
    bin_folder = sys.argv[1]
    with tempfile.TemporaryDirectory(prefix='tilemend-kubernetes-') as folder:
        # A copy, which gets certificates.
        for part in ('deploy', 'scripts'):
            shutil.copytree(os.path.join(ROOT, part), os.path.join(folder, part))
        here = os.path.join(folder, 'deploy/kubernetes')
        subprocess.run([os.path.join(here, 'trial/certificates.sh')], check=True, stderr=subprocess.DEVNULL)
        objects = build(os.path.join(here, 'trial'))
        check_against_kubectl(os.path.join(here, 'trial'), objects)
    for name, owner in pods_of(objects).items():
        check_owner(name, owner, objects)
    for name, pod in of_kind(objects, 'Pod').items():
        check_pod(name, pod['spec'], [], objects)
    check_names(objects)
    check_scaling(objects)
    if not faults:
        run_pods(bin_folder, objects)
    if faults:
        sys.exit('FAILED\n' + '\n'.join(faults))
    print(f'{len(objects)} objects, 0 faults')


if __name__ == '__main__':
    main()
