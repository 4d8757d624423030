#!/bin/bash
# A cluster on one machine: run.sh SCENE OUT
#
# Starts a coordinator and two workers on the loopback interface, sends a job, waits for it, and stops all three. On
# several machines the same three programs run apart; all must see SCENE and OUT under the same path (docs/operations.md).
set -euo pipefail
scene="$1" out="$2"
work=$(mktemp -d)
started=()
stop() {
  kill "${started[@]}" 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap stop EXIT

tilemend-coordinator --listen 127.0.0.1:0 --work "$work" --log text 2>"$work/log" &
started+=($!)
address=""
for _ in $(seq 100); do
  address=$(sed -n 's/.*listening address=\([^ ]*\).*/\1/p' "$work/log" | head -1)
  [[ -n "$address" ]] && break
  sleep 0.1
done
for _ in 1 2; do
  tilemend-worker --coordinator "$address" 2>/dev/null &
  started+=($!)
done

tilemend submit "$scene" --out "$out" --coordinator "$address" --wait || [[ $? == 100 ]]
tilemend workers --coordinator "$address"
