#!/bin/bash
# Makes the certificates of the trial, or renews them: deploy/kubernetes/trial/certificates.sh. Then `kubectl apply -k`
# the folder.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
exec "$here/../../../scripts/make_certificates.sh" "$here/tls" \
  tilemend-coordinator tilemend-coordinator.tilemend tilemend-coordinator.tilemend.svc
