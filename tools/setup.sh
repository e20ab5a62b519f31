# What tools/run and tools/test share: packages, configuration, build. To be sourced.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

say() { printf '%s\n' "plinian: $*" >&2; }

# Installs the packages of tools/packages.txt that are missing. Touches no network where none is.
install_packages() {
  local package missing=()
  if ! command -v dpkg-query >/dev/null; then
    say "this is no Debian; what the build needs is listed in tools/packages.txt"
    return
  fi
  while read -r package; do
    [[ -z $package || $package == \#* ]] && continue
    [[ $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) == *'install ok installed' ]] || missing+=("$package")
  done <"$root/tools/packages.txt"
  [[ ${#missing[@]} -eq 0 ]] && return

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      say "these packages are missing; install them as root: apt-get install ${missing[*]}"
      exit 1
    fi
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# As many jobs as there are cores and 1.5 GiB of memory for each.
job_count() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1572864)}' /proc/meminfo)
  ((memory < 1)) && memory=1
  echo $((cores < memory ? cores : memory))
}

# build_targets [TARGET...]: everything, without targets. All output goes to standard error.
build_targets() {
  [[ -f $build/build.ninja ]] || (cd "$root" && cmake --preset release) >&2
  cmake --build "$build" -j "$(job_count)" ${1:+--target "$@"} >&2
}
