#!/bin/bash
# Makes an authority for a trial, for a year, and certificates, each for a month. For a real cluster ask your own authority.
#
#   scripts/make_certificates.sh DIR [HOST...]     HOST: names and addresses of the coordinator (default: localhost)
#
# DIR gets ca.pem and, each with its .key: coordinator.pem, worker.pem, submit.pem, watch.pem and admin.pem for people, and
# scale.pem for KEDA.
# What a certificate may do stands in it as the URI tilemend:role:ROLE. Run it again to renew: the authority stays, the
# others are replaced, and running programs take the new ones within seconds.
set -euo pipefail
[[ $# -ge 1 ]] || { sed -n '2,10p' "$0" | cut -c3-; exit 2; }
dir=$1; shift
hosts=("$@"); [[ $# -gt 0 ]] || hosts=(localhost)
mkdir -p "$dir"
umask 077
days=30 authority_days=365

names=DNS:localhost,IP:127.0.0.1
for host in "${hosts[@]}"; do
  if [[ $host =~ ^[0-9.]+$|: ]]; then names+=",IP:$host"; else names+=",DNS:$host"; fi
done

new_key() { openssl ecparam -name prime256v1 -genkey -noout -out "$1"; }

if [[ ! -e $dir/ca.key ]]; then
  new_key "$dir/ca.key"
  openssl req -x509 -new -key "$dir/ca.key" -sha256 -days "$authority_days" -subj "/CN=tilemend trial authority" \
    -addext basicConstraints=critical,CA:TRUE -addext keyUsage=critical,keyCertSign,cRLSign -out "$dir/ca.pem"
fi

# certificate NAME SUBJECT_ALTERNATIVES [USES]: written beside and renamed, the key first, so that nobody sees a half one.
certificate() {
  local name=$1 alternatives=$2 uses=${3:-clientAuth}
  new_key "$dir/$name.key.new"
  openssl req -new -key "$dir/$name.key.new" -subj "/CN=$name" |
    openssl x509 -req -CA "$dir/ca.pem" -CAkey "$dir/ca.key" -sha256 -days "$days" -set_serial "0x$(openssl rand -hex 16)" \
      -extfile <(printf 'subjectAltName=%s\nextendedKeyUsage=%s\n' "$alternatives" "$uses") \
      -out "$dir/$name.pem.new" 2>/dev/null
  mv "$dir/$name.key.new" "$dir/$name.key"
  mv "$dir/$name.pem.new" "$dir/$name.pem"
}

certificate coordinator "$names" serverAuth
# Of a worker Prometheus asks as well, by the name `worker`, wherever it is. Nobody but the coordinator can pose as it.
certificate worker "DNS:worker,URI:tilemend:role:worker" serverAuth,clientAuth
for role in submit watch admin scale; do certificate "$role" "URI:tilemend:role:$role"; done
chmod 644 "$dir"/*.pem
