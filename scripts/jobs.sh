# Sets `jobs`: compilers at once. Sourced. gRPC's headers take over 1 GB a compiler, so that memory limits as well as cores.
jobs="${JOBS:-}"
if [[ -z "$jobs" ]]; then
  jobs=$(nproc)
  by_memory=$(awk '/^MemAvailable:/ {print int($2 / 1500000)}' /proc/meminfo)
  if ((by_memory < jobs)); then jobs=$by_memory; fi
  if ((jobs < 1)); then jobs=1; fi
fi
# Compilers' results are found again in another clone: paths below the root count from it.
export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$PWD}" CCACHE_NOHASHDIR="${CCACHE_NOHASHDIR:-1}"
