#!/bin/bash
# A cluster with mutual TLS on this machine, for a trial. Needs a Docker engine and docker-compose.
#
#   docker/trial.sh up [WORKERS]        certificates, images and a cluster (default: 3 workers of one thread)
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
trial=$(mkdir -p "${TRIAL:-trial}" && cd "${TRIAL:-trial}" && pwd)

export TILEMEND_DATA=$trial/data TILEMEND_TLS=$trial/tls TILEMEND_WORK=$trial/work
export TILEMEND_IMAGE=${TILEMEND_IMAGE:-tilemend}
# The programs run as who calls this, so that its files are theirs; never as root.
if [[ $(id -u) -eq 0 ]]; then export TILEMEND_USER=10001:10001; else export TILEMEND_USER=$(id -u):$(id -g); fi

if command -v docker-compose >/dev/null; then compose=(docker-compose); else compose=(docker compose); fi
compose+=(-p tilemend -f "$here/compose.yaml")

# Each program sees its own key alone.
certificates() {
  "$root/scripts/make_certificates.sh" "$trial/authority" coordinator
  for name in coordinator worker submit; do
    install -d -m 700 "$TILEMEND_TLS/$name"
    install -m 400 "$trial/authority/$name.key" "$TILEMEND_TLS/$name/$name.key.new"
    install -m 444 "$trial/authority/ca.pem" "$trial/authority/$name.pem" "$TILEMEND_TLS/$name"
    mv "$TILEMEND_TLS/$name/$name.key.new" "$TILEMEND_TLS/$name/$name.key"
  done
  own "$TILEMEND_TLS"
}

own() { if [[ $(id -u) -eq 0 ]]; then chown -R "$TILEMEND_USER" "$@"; fi; }

case "${1:-}" in
  up)
    mkdir -p "$TILEMEND_DATA" "$TILEMEND_WORK"
    own "$TILEMEND_DATA" "$TILEMEND_WORK"
    certificates
    docker image inspect "$TILEMEND_IMAGE" >/dev/null 2>&1 ||
      DOCKER_BUILDKIT=1 docker build -f "$here/Dockerfile" -t "$TILEMEND_IMAGE" "$root"
    "${compose[@]}" up -d --scale "worker=${2:-3}" ${TRIAL_SERVICES:-}
    ;;
  client) shift; "${compose[@]}" run --rm -T client "$@" ;;
  scale) "${compose[@]}" up -d --no-recreate --scale "worker=${2:?how many workers}" ${TRIAL_SERVICES:-} ;;
  renew) certificates ;;
  logs) shift; "${compose[@]}" logs --no-color "$@" ;;
  down) shift; "${compose[@]}" down "$@" ;;
  *) sed -n '2,11p' "$0" | cut -c3-; exit 2 ;;
esac
