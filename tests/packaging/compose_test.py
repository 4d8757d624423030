#!/usr/bin/env python3
"""Runs the cluster of docker/compose.yaml for real, and disturbs it.

    compose_test.py BIN TOOLS [--image IMAGE] [--answers FILE]

A coordinator and one worker begin to fill a scene. Then there are three workers, one is killed, the coordinator is
started again, all certificates are renewed. The output must have the bytes of `tilemend run`, and Prometheus, which
reads the metrics over TLS with a token, must answer every query of the dashboard.

The image has the programs of BIN, and is made here, unless --image names one. So is Prometheus', of Debian's package,
unless PROMETHEUS_IMAGE names one. Exit code 77 (skipped, and says so) without a Docker engine that can build,
docker-compose or the image debian:12-slim. Where no registry is at hand, this makes that one:

    debootstrap --variant=minbase bookworm base && tar -C base -c . | docker import - debian:12-slim

BIN has tilemend and tilemend-make-scene; TOOLS/../scenes/table3.json is the scene's layout, if it is there.
"""
import argparse
import filecmp
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.parse
import urllib.request

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TRIAL = os.path.join(ROOT, 'docker', 'trial.sh')


def skip(why):
    print(f'SKIPPED: {why}')
    sys.exit(77)


def run(*words, env=None, check=True):
    done = subprocess.run(words, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if check and done.returncode:
        raise SystemExit(f'FAILED: {" ".join(words)}: code {done.returncode}\n{done.stdout}{done.stderr}')
    return done


def await_(what, condition, seconds=120):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.2)
    raise SystemExit(f'FAILED: waited {seconds} s in vain for {what}')


BASE = 'debian:12-slim'
PROGRAMS = 'FROM scratch\nCOPY installed /installed\n'
PROMETHEUS = f'''FROM {BASE}
RUN apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends prometheus \\
    && install -d -o nobody /prometheus
USER nobody
ENTRYPOINT ["prometheus"]
'''


def build_image(name, *words, text=None):
    done = subprocess.run(['docker', 'build', '-t', name, *words], env=dict(os.environ, DOCKER_BUILDKIT='1'), input=text,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise SystemExit(f'FAILED: docker build -t {name}: {done.stdout[-4000:]}')
    return name


def image_of(build):
    """With the programs of a build tree in place of those that the first stage would compile."""
    with tempfile.TemporaryDirectory() as folder:
        for component in ((), ('--component', 'trial')):
            run('cmake', '--install', build, '--prefix', '/usr', '--strip', *component,
                env=dict(os.environ, DESTDIR=os.path.join(folder, 'installed')))
        with open(os.path.join(folder, 'Dockerfile'), 'w') as file:
            file.write(PROGRAMS)
        build_image('tilemend-test-programs', folder)
    return build_image('tilemend-test', '-f', os.path.join(ROOT, 'docker/Dockerfile'), '--build-arg',
                       'PROGRAMS=tilemend-test-programs', ROOT)


def check_libraries(image):
    """All that the programs load is in the image."""
    script = 'ldd /usr/bin/tilemend* /usr/lib/tilemend/tilemend-gdal'
    listed = run('docker', 'run', '--rm', '--entrypoint', 'sh', image, '-c', script).stdout
    missing = [line.strip() for line in listed.splitlines() if 'not found' in line]
    if missing or 'libssl' not in listed:
        raise SystemExit(f'FAILED: docker/runtime_packages.txt: {missing or listed}')


class Cluster:
    def __init__(self, folder, image):
        self.folder, self.data = folder, os.path.join(folder, 'data')
        self.port = '19090'
        self.env = dict(os.environ, TRIAL=folder, TILEMEND_IMAGE=image, TILEMEND_LEASE='5', PROMETHEUS_PORT=self.port)

    def trial(self, *words):
        return run(TRIAL, *words, env=self.env).stdout

    def client(self, *words):
        return self.trial('client', *words)

    def job(self, name):
        return json.loads(self.client('get', name, '-o', 'json'))

    def containers(self, service):
        return run('docker', 'ps', '-q', '--filter', f'label=com.docker.compose.service={service}', '--filter',
                   'label=com.docker.compose.project=tilemend').stdout.split()

    def workers(self):
        return json.loads(self.client('workers', '-o', 'json'))

    def slow_down(self):
        for container in self.containers('worker'):
            run('docker', 'update', '--cpus', '0.08', container)

    def ask(self, query):
        url = f'http://127.0.0.1:{self.port}/api/v1/query?' + urllib.parse.urlencode({'query': query})
        with urllib.request.urlopen(url) as answer:
            return json.load(answer)['data']['result']

    def ask_range(self, query, start, end, step):
        words = urllib.parse.urlencode({'query': query, 'start': start, 'end': end, 'step': step})
        with urllib.request.urlopen(f'http://127.0.0.1:{self.port}/api/v1/query_range?{words}') as answer:
            return json.load(answer)['data']['result']


def submit_paused(cluster):
    """The name of a job that waits. Its only worker is frozen until then, so that it does no task, however long it takes to
    start the client's container."""
    (worker,) = cluster.containers('worker')
    run('docker', 'pause', worker)
    name = json.loads(cluster.client('submit', '/data/scene', '--out', '/data/out', '-o', 'json'))['name']
    cluster.client('pause', name)
    run('docker', 'unpause', worker)
    return name


def disturb(cluster, name):
    """While the job runs. It is paused until all is ready for the faults."""
    cluster.trial('scale', '3')
    cluster.slow_down()
    await_('three workers', lambda: len(cluster.workers()) == 3)
    cluster.trial('renew')
    print('three workers, and new certificates')
    cluster.client('resume', name)
    time.sleep(3)  # some of its tasks
    (coordinator,), worker = cluster.containers('coordinator'), cluster.containers('worker')[0]
    with subprocess.Popen(['docker', 'restart', '-t', '5', coordinator], stdout=subprocess.DEVNULL):
        run('docker', 'kill', worker)
    await_('the coordinator', lambda: run(TRIAL, 'client', 'get', name, env=cluster.env, check=False).returncode == 0)
    job = cluster.job(name)
    print(f'killed a worker and started the coordinator again: {job["state"]}, {job["progress"]["tasks_done"]} tasks')
    if '"event":"job goes on"' not in cluster.trial('logs', 'coordinator'):
        raise SystemExit('FAILED: the job was over before the coordinator ended')


def same_tiles(one, other):
    names = sorted(os.listdir(one))
    if names != sorted(os.listdir(other)):
        raise SystemExit('FAILED: not the same tiles')
    wrong = [n for n in names if not filecmp.cmp(os.path.join(one, n), os.path.join(other, n), shallow=False)]
    if wrong:
        raise SystemExit(f'FAILED: other bytes than `run`: {wrong}')
    return len(names)


def ask_dashboard(cluster, start, answers_file):
    """Every query of every panel, over the time of the job."""
    with open(os.path.join(ROOT, 'deploy/grafana/tilemend.json')) as file:
        panels = [p for p in json.load(file)['panels'] if p['type'] != 'row']
    end, answers, empty = time.time(), [], []
    for panel in panels:
        for target in panel['targets']:
            result = cluster.ask_range(target['expr'], start, end, 2)
            answers.append({'panel': panel['title'], 'unit': panel['fieldConfig']['defaults']['unit'],
                            'legend': target['legendFormat'], 'result': result})
            if not result:
                empty.append(f'{panel["title"]}: {target["expr"]}')
    if answers_file:
        with open(answers_file, 'w') as file:
            json.dump(answers, file)
    if empty:
        raise SystemExit('FAILED: no answer to\n' + '\n'.join(empty))
    return len(answers)


def check_alerts(cluster):
    """A worker that is killed while nothing else happens wakes somebody, and nothing else does."""
    run('docker', 'kill', cluster.containers('worker')[0])
    lost = await_('the alert of the lost worker', lambda: cluster.ask('ALERTS{alertname="TilemendWorkerLost",alertstate="firing"}'))
    others = [a['metric']['alertname'] for a in cluster.ask('ALERTS{alertstate="firing"}') if a not in lost]
    if set(others) - {'TilemendWorkerLost'}:
        raise SystemExit(f'FAILED: alerts without a reason: {others}')
    print('a lost worker fires its alert, and no other')


def check_metrics_are_guarded(cluster):
    """Nobody reads them without the token, and not in plain text."""
    (coordinator,) = cluster.containers('coordinator')
    ask = "printf 'GET /metrics HTTP/1.1\\r\\nHost: a\\r\\n\\r\\n' | timeout 9 "
    say = lambda how: run('docker', 'exec', coordinator, 'bash', '-c', ask + how, check=False).stdout
    encrypted = say('openssl s_client -quiet -connect 127.0.0.1:9100 2>/dev/null')
    plain = say("bash -c 'exec 3<>/dev/tcp/127.0.0.1/9100; cat >&3; cat <&3'")
    if ' 401 ' not in encrypted or 'tilemend_' in encrypted + plain:
        raise SystemExit(f'FAILED: metrics without a token: {encrypted}{plain}')
    print('metrics are refused without the token')


def check_engine():
    if not shutil.which('docker') or not shutil.which('docker-compose'):
        skip('there is no docker or no docker-compose')
    if run('docker', 'info', check=False).returncode:
        skip('no Docker engine runs')
    if run('docker', 'image', 'inspect', BASE, check=False).returncode and run('docker', 'pull', BASE, check=False).returncode:
        skip(f'there is no image {BASE}; see the head of this file')
    trial = subprocess.run(['docker', 'build', '-'], env=dict(os.environ, DOCKER_BUILDKIT='1'), input='FROM scratch\nLABEL a=b\n',
                           text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if trial.returncode:
        skip(f'docker cannot build: {trial.stdout.strip()}')


def play(cluster, scene, options):
    expected = run(os.path.join(options.bin, 'tilemend'), 'run', scene, '--out', os.path.join(cluster.folder, 'expected'),
                   check=False).returncode
    cluster.trial('up', '1')
    start = time.time()
    name = submit_paused(cluster)
    disturb(cluster, name)
    ended = run(TRIAL, 'client', 'watch', name, '-o', 'json', env=cluster.env, check=False)
    if ended.returncode != expected:
        raise SystemExit(f'FAILED: watch ended with {ended.returncode}, run with {expected}: {ended.stderr}')
    print(f'job ended: {json.loads(ended.stdout)["message"]}, {time.time() - start:.0f} s')
    tiles = same_tiles(os.path.join(cluster.folder, 'expected', 'tiles'), os.path.join(cluster.data, 'out', 'tiles'))
    print(f'{tiles} tiles with the bytes of `tilemend run`')
    time.sleep(6)  # a scrape of the end
    check_metrics_are_guarded(cluster)
    check_alerts(cluster)
    print(f'{ask_dashboard(cluster, start, options.answers)} queries of the dashboard answered')


def read_options():
    parser = argparse.ArgumentParser()
    parser.add_argument('bin')
    parser.add_argument('tools')
    parser.add_argument('--image')
    parser.add_argument('--answers')
    parser.add_argument('--spacing', default='0.5')
    return parser.parse_args()


def main():
    options = read_options()
    check_engine()
    image = options.image or image_of(os.path.dirname(os.path.abspath(options.bin)))
    check_libraries(image)
    if 'PROMETHEUS_IMAGE' not in os.environ:
        os.environ['PROMETHEUS_IMAGE'] = build_image('tilemend-test-prometheus', '-', text=PROMETHEUS)
    layout = os.path.join(options.tools, '..', 'scenes', 'table3.json')
    shape = ['--layout', layout] if os.path.exists(layout) else ['--cols', '8', '--rows', '4', '--holes', 'lakes,small']
    with tempfile.TemporaryDirectory(prefix='tilemend-compose-') as folder:
        cluster = Cluster(folder, image)
        os.chmod(folder, 0o755)
        os.makedirs(cluster.data)
        scene = os.path.join(cluster.data, 'scene')
        run(os.path.join(options.bin, 'tilemend-make-scene'), scene, '--cell', '250', '--spacing', options.spacing, *shape)
        try:
            play(cluster, scene, options)
        except SystemExit:
            print(cluster.trial('logs', 'coordinator')[-4000:])
            raise
        finally:
            cluster.trial('down', '-v')
    print('1 passed, 0 failed')


if __name__ == '__main__':
    main()
