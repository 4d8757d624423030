#!/bin/bash
# A cluster with mutual TLS on this machine, for a trial. Needs a Docker engine, docker-compose and openssl.
#
#   docker/trial.sh up [WORKERS]        certificates, images and a cluster (default: 3 workers of one thread)
#   docker/trial.sh build               the image anew, of other sources; then `up` again
#   docker/trial.sh fill [SCENE]        fills a copy of the folder SCENE on it, or of a scene that it makes
#   docker/trial.sh client COMMAND...   the client: `client submit /data/scene --out /data/out --wait`
#   docker/trial.sh scale WORKERS       more or fewer workers
#   docker/trial.sh renew               new certificates; running programs take them within seconds
#   docker/trial.sh logs [SERVICE]      what the programs say
#   docker/trial.sh down [-v]           stops it; scenes, outputs and jobs stay; -v: not what Prometheus has
#
# TRIAL (default: ./trial) gets data/ (scenes and outputs, /data for the programs), tls/ and work/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(dirname "$here")
[[ $# -gt 0 ]] || { sed -n '2,13p' "$0" | cut -c3-; exit 2; }
trial=$(mkdir -p "${TRIAL:-trial}" && cd "${TRIAL:-trial}" && pwd)

export TILEMEND_DATA=$trial/data TILEMEND_TLS=$trial/tls TILEMEND_WORK=$trial/work
export TILEMEND_IMAGE=${TILEMEND_IMAGE:-tilemend}
# The programs run as who calls this, so that its files are theirs; never as root.
if [[ $(id -u) -eq 0 ]]; then export TILEMEND_USER=10001:10001; else export TILEMEND_USER=$(id -u):$(id -g); fi

fail() { echo "trial.sh: $1" >&2; exit "${2:-5}"; }
for program in docker openssl; do
  command -v "$program" >/dev/null || fail "there is no $program (Debian: apt-get install docker.io docker-compose openssl)"
done
if command -v docker-compose >/dev/null; then
  compose=(docker-compose)
elif docker compose version >/dev/null 2>&1; then
  compose=(docker compose)
else
  fail 'there is neither docker-compose nor `docker compose` (Debian: apt-get install docker-compose)'
fi
docker info >/dev/null 2>&1 || fail 'no Docker engine answers; start it, or ask to be of the group docker'
compose+=(-p tilemend -f "$here/compose.yaml")

# Each program sees its own key alone. What is below trial/tls only this user reaches, and containers that mount it.
certificates() {
  local authority=$trial/authority
  "$root/scripts/make_certificates.sh" "$authority" coordinator
  [[ -e $authority/metrics.token ]] || (umask 077 && openssl rand -hex 32 >"$authority/metrics.token")
  install -d -m 700 "$TILEMEND_TLS"
  for name in coordinator worker submit; do
    install -d -m 700 "$TILEMEND_TLS/$name"
    install -m 400 "$authority/$name.key" "$TILEMEND_TLS/$name/$name.key.new"
    install -m 444 "$authority/ca.pem" "$authority/$name.pem" "$TILEMEND_TLS/$name"
    mv "$TILEMEND_TLS/$name/$name.key.new" "$TILEMEND_TLS/$name/$name.key"
  done
  install -m 400 "$authority/metrics.token" "$TILEMEND_TLS/coordinator"
  install -m 400 "$authority/metrics.token" "$TILEMEND_TLS/worker"
  own "$TILEMEND_TLS"
  install -d -m 755 "$TILEMEND_TLS/prometheus"  # it runs as a user of its own
  install -m 444 "$authority/ca.pem" "$authority/metrics.token" "$TILEMEND_TLS/prometheus"
}

build() { DOCKER_BUILDKIT=1 docker build -f "$here/Dockerfile" -t "$TILEMEND_IMAGE" "$root"; }

own() { if [[ $(id -u) -eq 0 ]]; then chown -R "$TILEMEND_USER" "$@"; fi; }

run_client() {
  local terminal=(-T)
  if [[ -t 0 && -t 1 && -t 2 ]]; then terminal=(); fi
  "${compose[@]}" run --rm "${terminal[@]}" "$@"
}

# The name of the scene in trial/data. A folder that is there already is taken as it is.
take_scene() {
  local scene=$1 name
  name=$(basename "$scene")
  if [[ $(dirname "$scene") != "$TILEMEND_DATA" ]]; then
    if [[ ! -e $TILEMEND_DATA/$name ]]; then
      cp -r --reflink=auto "$scene" "$TILEMEND_DATA/$name"
      own "$TILEMEND_DATA/$name"
    elif ! diff -rq "$scene" "$TILEMEND_DATA/$name" >/dev/null; then
      fail "$TILEMEND_DATA/$name is another scene of that name; move it away" 4
    fi
  fi
  echo "$name"
}

fill() {
  local name=lakes
  if [[ $# -gt 0 && $1 != -* ]]; then
    [[ -d $1 ]] || fail "$1: no folder with a scene" 3
    name=$(take_scene "$(cd "$1" && pwd)")
    shift
  elif [[ ! -e $TILEMEND_DATA/$name ]]; then
    run_client --entrypoint tilemend-make-scene client "/data/$name" --cols 6 --rows 5 --cell 250 --spacing 2.5 --seed 7 \
      --holes lakes,islands,river,small --small-per-cell 3 --empty 4:3
  fi
  echo "the result will be in $TILEMEND_DATA/$name-filled"
  run_client client submit "/data/$name" --out "/data/$name-filled" --wait "$@"
}

case "$1" in
  up)
    mkdir -p "$TILEMEND_DATA" "$TILEMEND_WORK"
    own "$TILEMEND_DATA" "$TILEMEND_WORK"
    certificates
    docker image inspect "$TILEMEND_IMAGE" >/dev/null 2>&1 || build
    "${compose[@]}" up -d --scale "worker=${2:-3}" ${TRIAL_SERVICES:-}
    ;;
  build) build ;;
  fill) shift; fill "$@" ;;
  client) shift; run_client client "$@" ;;
  scale) "${compose[@]}" up -d --no-recreate --scale "worker=${2:?how many workers}" ${TRIAL_SERVICES:-} ;;
  renew) certificates ;;
  logs) shift; "${compose[@]}" logs --no-color "$@" ;;
  down) shift; "${compose[@]}" down "$@" ;;
  *) sed -n '2,13p' "$0" | cut -c3-; exit 2 ;;
esac
