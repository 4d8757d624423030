#!/usr/bin/env python3
"""Runs deploy/slurm/workers.sbatch on a real Slurm of one node, which the test starts: slurm_test.py BIN

Two elements of the array run at once, for three minutes each by the clock of Slurm, which sends them SIGTERM two minutes
before. Jobs are submitted one after the other until workers of two elements have left by that signal; those that come
after them do the rest. Every output must have the bytes of `tilemend run`, and no worker may have been lost. Exit code 77
(skipped, and says so) without slurmctld, slurmd and munged, or where they do not start.
"""
import filecmp
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, 'deploy/slurm/workers.sbatch')
CONFIGURATION = """
ClusterName=trial
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
StateSaveLocation={folder}
SlurmdSpoolDir={folder}/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
MpiDefault=none
ReturnToService=2
KillWait=10
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def skip(why):
    print(f'SKIPPED: {why}')
    sys.exit(77)


def free_port():
    with socket.socket() as s:
        s.bind(('127.0.0.1', 0))
        return s.getsockname()[1]


def await_(what, condition, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.2)
    raise SystemExit(f'FAILED: waited {seconds} s in vain for {what}')


class Slurm:
    """Daemons of the test's own, in a folder of its own."""

    def __init__(self, folder):
        self.folder, self.programs = folder, []
        conf = os.path.join(folder, 'slurm.conf')
        with open(conf, 'w') as file:
            file.write(CONFIGURATION.format(host=socket.gethostname().split('.')[0], folder=folder, user=os.environ.get('USER', 'root'),
                                            ports=[free_port(), free_port()]))
        self.env = dict(os.environ, SLURM_CONF=conf)

    def start(self):
        key = os.path.join(self.folder, 'munge.key')
        with open(key, 'wb', opener=lambda path, flags: os.open(path, flags, 0o600)) as file:
            file.write(os.urandom(1024))
        names = {'--socket': 'socket', '--pid-file': 'pid', '--log-file': 'log', '--seed-file': 'seed'}
        self.run_daemon('munged', '--foreground', '--force', f'--key-file={key}',
                        *(f'{flag}={self.folder}/munge.{name}' for flag, name in names.items()))
        self.run_daemon('slurmctld', '-D')
        self.run_daemon('slurmd', '-D')
        end = time.monotonic() + 20
        while time.monotonic() < end:
            if any(program.poll() is not None for program in self.programs):
                return False
            if 'idle' in self.ask('sinfo', '-h', '-o', '%t'):
                return True
            time.sleep(0.2)
        return False

    def run_daemon(self, *words):
        log = open(os.path.join(self.folder, words[0] + '.out'), 'w')
        self.programs.append(subprocess.Popen(words, stdout=log, stderr=log, env=self.env))

    def ask(self, *words):
        return subprocess.run(words, env=self.env, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout

    def stop(self):
        if shutil.which('scancel'):
            self.ask('scancel', '--name', 'tilemend-worker')
            end = time.monotonic() + 30
            while self.ask('squeue', '-h').strip() and time.monotonic() < end:
                time.sleep(0.2)
        for program in reversed(self.programs):
            program.terminate()
            program.wait()


class Coordinator:
    def __init__(self, bin_folder, folder):
        self.bin, self.folder = bin_folder, folder
        self.address = f'127.0.0.1:{free_port()}'
        self.log = os.path.join(folder, 'coordinator.log')
        self.program = subprocess.Popen(
            [os.path.join(bin_folder, 'tilemend-coordinator'), '--work', os.path.join(folder, 'work'), '--listen', self.address],
            stderr=open(self.log, 'w'))
        await_('the coordinator', lambda: self.events('listening'), 30)

    def events(self, name):
        with open(self.log) as log:
            return [entry for entry in map(json.loads, log) if entry['event'] == name]

    def fill(self, scene, out):
        return subprocess.run([os.path.join(self.bin, 'tilemend'), 'submit', scene, '--out', out, '--overwrite', '--wait',
                               '--coordinator', self.address], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def submit_array(slurm, folder, coordinator):
    settings = os.path.join(folder, 'worker.conf')
    with open(settings, 'w') as file:
        file.write(f'coordinator = {coordinator.address}\nlog = json\n')
    env = dict(slurm.env, TILEMEND_CONFIG=settings, PATH=coordinator.bin + os.pathsep + os.environ['PATH'])
    done = subprocess.run(['sbatch', '--array=1-8%2', '--time=3', '--cpus-per-task=1', '--mem-per-cpu=300',
                           f'--output={folder}/worker-%a.log', SCRIPT], env=env, text=True, cwd=folder,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode:
        raise SystemExit(f'FAILED: sbatch: {done.stderr}')


def same_tiles(one, other):
    names = sorted(os.listdir(one))
    wrong = [n for n in names if not filecmp.cmp(os.path.join(one, n), os.path.join(other, n), shallow=False)]
    if wrong or names != sorted(os.listdir(other)):
        raise SystemExit(f'FAILED: other tiles than `run`: {wrong}')


def check_run(bin_folder, slurm, folder):
    scene, expected = os.path.join(folder, 'scene'), os.path.join(folder, 'expected')
    subprocess.run([os.path.join(bin_folder, 'tilemend-make-scene'), scene, '--cols', '6', '--rows', '3', '--holes', 'lakes,small'],
                   check=True, stdout=subprocess.DEVNULL)
    code = subprocess.run([os.path.join(bin_folder, 'tilemend'), 'run', scene, '--out', expected], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode
    coordinator = Coordinator(bin_folder, folder)
    try:
        submit_array(slurm, folder, coordinator)
        await_('two workers', lambda: len(coordinator.events('worker came')) >= 2, 60)
        jobs, end = 0, time.monotonic() + 150
        while len(coordinator.events('worker left')) < 2 or len(coordinator.events('worker came')) < 4:
            if time.monotonic() > end:
                raise SystemExit(f'FAILED: no workers left and came: {slurm.ask("squeue")}')
            out = os.path.join(folder, 'out')
            done = coordinator.fill(scene, out)
            if done.returncode != code:
                raise SystemExit(f'FAILED: a job ended with {done.returncode}: {done.stderr}')
            same_tiles(os.path.join(expected, 'tiles'), os.path.join(out, 'tiles'))
            jobs += 1
        lost = coordinator.events('worker lost')
        if lost:
            raise SystemExit(f'FAILED: workers were lost: {lost}')
        print(f'{jobs} jobs with the bytes of `run`; {len(coordinator.events("worker came"))} workers came, '
              f'{len(coordinator.events("worker left"))} left at their time, 0 were lost')
    finally:
        slurm.stop()
        coordinator.program.terminate()
        coordinator.program.wait()


def main():
    missing = [name for name in ('munged', 'slurmctld', 'slurmd', 'sbatch', 'srun') if not shutil.which(name, path='/usr/sbin:/usr/bin:' + os.environ['PATH'])]
    if missing:
        skip(f'there is no {", ".join(missing)} (apt-get install slurm-wlm munge)')
    os.environ['PATH'] += os.pathsep + '/usr/sbin'
    os.environ['USER'] = subprocess.run(['id', '-un'], text=True, stdout=subprocess.PIPE, check=True).stdout.strip()
    with tempfile.TemporaryDirectory(prefix='tilemend-slurm-') as folder:
        os.chmod(folder, 0o755)  # munged wants nobody else to write there
        slurm = Slurm(folder)
        try:
            if not slurm.start():
                skip('Slurm does not start here: ' + slurm.ask('tail', '-n', '3', *(os.path.join(folder, n) for n in os.listdir(folder) if n.endswith('.out'))))
            check_run(os.path.abspath(sys.argv[1]), slurm, folder)
        finally:
            slurm.stop()


if __name__ == '__main__':
    main()
