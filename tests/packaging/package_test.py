#!/usr/bin/env python3
"""Makes the Debian package, installs it on a system with a systemd of its own, runs the units, and removes it.

    package_test.py BUILD

The system is this machine's, seen through an overlay: what is written there is gone with the test. In it systemd is
process 1, in namespaces of its own. The units fill a scene with the bytes of `tilemend run`, are started again when they
hang or are killed, and can write nowhere but where they should. Removing the package stops them and leaves the jobs.
Exit code 77 (skipped, and says so) without root, overlayfs, systemd or what packs.
"""
import filecmp
import glob
import os
import shutil
import subprocess
import sys
import tempfile

BOOT = r'''
set -e
mount -t tmpfs none "$TRIAL/space"
mkdir "$TRIAL/space/upper" "$TRIAL/space/work"
mount -t overlay overlay -o "lowerdir=/,upperdir=$TRIAL/space/upper,workdir=$TRIAL/space/work" "$TRIAL/root"
rm -rf "$TRIAL/root/etc/systemd/system"/*.wants "$TRIAL/root/data"
cp "$TRIAL"/tilemend_*.deb "$TRIAL/root/tilemend.deb"
cp -r "$TRIAL/data" "$TRIAL/root/data"
cp "$TRIAL/trial.sh" "$TRIAL/root/"
cp "$TRIAL/trial.service" "$TRIAL/trial.target" "$TRIAL/root/etc/systemd/system/"
mkdir -p "$TRIAL/root/old"
mount -t cgroup2 none "$TRIAL/cgroup"
mkdir "$TRIAL/cgroup/$NAME"
echo $$ > "$TRIAL/cgroup/$NAME/cgroup.procs"
unshare --mount --pid --cgroup --uts --ipc --net --fork --kill-child bash -c '
  set -e
  cd "$TRIAL/root"
  mount -t proc proc proc; mount -t sysfs sysfs sys; mount -t cgroup2 none sys/fs/cgroup
  mount -t tmpfs none run; mount -t tmpfs none tmp; mount -t devtmpfs none dev
  pivot_root . old; umount -l /old
  exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin container=trial /lib/systemd/systemd --unit=trial.target --log-target=null
' || true
echo $$ > "$TRIAL/cgroup/cgroup.procs"
find "$TRIAL/cgroup/$NAME" -depth -type d -exec rmdir {} \;
cp -r "$TRIAL/space/upper/data" "$TRIAL/filled"
cp "$TRIAL/space/upper/trial.log" "$TRIAL/log" || true
'''

SERVICE = '''[Unit]
After=basic.target
[Service]
Type=oneshot
ExecStart=/bin/bash -e /trial.sh
StandardOutput=file:/trial.log
StandardError=file:/trial.log
ExecStopPost=systemctl exit
'''

# Runs in the system of the trial.
TRIAL = r'''
expect() { if ! "${@:2}"; then echo "FAILED: $1: ${*:2}"; exit 1; fi; }
await() { for ((i = 0; i < 100; ++i)); do "$@" && return; sleep 0.2; done; false; }
shows() { [[ $(systemctl show -P "$2" "tilemend-$1") == "$3" ]]; }
export DEBIAN_FRONTEND=noninteractive

dpkg -i /tilemend.deb >/dev/null
chown -R tilemend /data
expect 'the page' man -w tilemend-worker >/dev/null
systemctl start tilemend-coordinator tilemend-worker
expect 'both run' systemctl is-active -q tilemend-coordinator tilemend-worker
expect 'the worker says what it does' await shows worker StatusText connected

expect 'a scene is filled' tilemend submit /data/scene --out /data/out --wait &>/dev/null
expect 'no other folder is written to' bash -c '! tilemend submit /data/scene --out /srv/out --wait 2>/dev/null' >/dev/null
expect 'no capability' grep -q 'CapBnd:.0000000000000000' "/proc/$(systemctl show -P MainPID tilemend-worker)/status"
expect 'no new rights' grep -q 'NoNewPrivs:.1' "/proc/$(systemctl show -P MainPID tilemend-worker)/status"
echo 'a scene filled by the units'

mkdir /run/systemd/system/tilemend-worker.service.d
printf '[Service]\nWatchdogSec=1\n' > /run/systemd/system/tilemend-worker.service.d/short.conf
systemctl daemon-reload
systemctl restart tilemend-worker
kill -STOP "$(systemctl show -P MainPID tilemend-worker)"
expect 'the watchdog bites' await shows worker NRestarts 1
kill -KILL "$(systemctl show -P MainPID tilemend-coordinator)"
expect 'the coordinator is started again' await shows coordinator NRestarts 1
expect 'both run again' await systemctl is-active -q tilemend-coordinator tilemend-worker
expect 'the job is known' bash -c 'tilemend list | grep -q "done.*/data/out"'
echo 'hung and killed programs were started again'

dpkg --remove tilemend >/dev/null
expect 'the units are stopped' bash -c '! pgrep "^tilemend-"'
expect 'its files are gone' bash -c '! compgen -G "/usr/bin/tilemend*" && ! compgen -G "/usr/share/*/*/*tilemend*" && [[ ! -e /usr/lib/tilemend ]]'
expect 'settings and jobs stay' test -e /etc/tilemend/worker.conf -a -e /var/lib/tilemend/journal.sqlite
dpkg --purge tilemend >/dev/null
expect 'settings are gone' test ! -e /etc/tilemend
expect 'jobs stay' test -e /var/lib/tilemend/journal.sqlite
echo 'removed'
echo PASSED
'''


def skip(why):
    print(f'SKIPPED: {why}')
    sys.exit(77)


def run(*words, **more):
    done = subprocess.run(words, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    if done.returncode:
        raise SystemExit(f'FAILED: {" ".join(words)}: {done.stdout}')
    return done.stdout


def check_machine():
    if os.getuid() != 0:
        skip('only root makes a system in namespaces')
    for name in ('cpack', 'dpkg-shlibdeps', 'unshare'):
        if not shutil.which(name):
            skip(f'there is no {name}')
    if not os.path.exists('/lib/systemd/systemd'):
        skip('there is no systemd')
    probe = 'd=$(mktemp -d) && mount -t tmpfs none $d && mkdir $d/u $d/w $d/r && mount -t cgroup2 none $d/r && umount $d/r && ' \
            'mount -t overlay overlay -o lowerdir=/,upperdir=$d/u,workdir=$d/w $d/r; r=$?; umount -l $d; rmdir $d; exit $r'
    done = subprocess.run(['unshare', '--mount', 'bash', '-c', probe], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        skip(f'no overlay or no cgroups here: {done.stdout}')


def write(path, text):
    with open(path, 'w') as file:
        file.write(text)


def main():
    build = os.path.abspath(sys.argv[1])
    check_machine()
    with tempfile.TemporaryDirectory(prefix='tilemend-package-') as folder:
        run('cpack', '-G', 'DEB', '--config', os.path.join(build, 'CPackConfig.cmake'), '-B', folder, cwd=build)
        (package,) = glob.glob(os.path.join(folder, '*.deb'))
        print(os.path.basename(package), os.path.getsize(package), 'bytes')
        for name in ('space', 'root', 'cgroup', 'data'):
            os.mkdir(os.path.join(folder, name))
        scene = os.path.join(folder, 'data', 'scene')
        run(os.path.join(build, 'bin/tilemend-make-scene'), scene, '--cols', '3', '--rows', '2', '--holes', 'lakes,small')
        run(os.path.join(build, 'bin/tilemend'), 'run', scene, '--out', os.path.join(folder, 'expected'))
        write(os.path.join(folder, 'trial.sh'), TRIAL)
        write(os.path.join(folder, 'trial.service'), SERVICE)
        write(os.path.join(folder, 'trial.target'), '[Unit]\nWants=trial.service\n')
        env = dict(os.environ, TRIAL=folder, NAME=os.path.basename(folder))
        said = run('timeout', '--kill-after=5', '150', 'unshare', '--mount', '--propagation', 'private', 'bash', '-c', BOOT, env=env)
        log_path = os.path.join(folder, 'log')
        log = open(log_path).read() if os.path.exists(log_path) else said
        print(log.strip())
        if 'PASSED' not in log:
            raise SystemExit('FAILED')
        expected, filled = os.path.join(folder, 'expected/tiles'), os.path.join(folder, 'filled/out/tiles')
        names = sorted(os.listdir(expected))
        if names != sorted(os.listdir(filled)) or filecmp.cmpfiles(expected, filled, names, shallow=False)[0] != names:
            raise SystemExit('FAILED: other tiles than `run`')
        print(f'{len(names)} tiles with the bytes of `run`')


if __name__ == '__main__':
    main()
