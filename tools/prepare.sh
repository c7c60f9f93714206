# Sourced by ./run and ./test: installs what is missing and configures the release build. Speaks on stderr, because
# stdout belongs to the program that ./run starts.

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

# Installs the packages of packages.txt that are not there; the rest of the machine is left alone.
install_missing_packages() {
  local wanted missing=() package as_root=() log
  if ! command -v dpkg-query >/dev/null; then
    say "this is no Debian or Ubuntu: going on with what is installed (packages.txt says what is needed)"
    return
  fi
  mapfile -t wanted < <(grep -v -e '^#' -e '^$' packages.txt)
  for package in "${wanted[@]}"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "these packages are missing, and only root can install them: apt-get install ${missing[*]}"
      exit 1
    fi
    as_root=(sudo)
  fi
  say "installing through apt: ${missing[*]}"
  log=$(mktemp)
  if ! { "${as_root[@]}" apt-get update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } \
    >"$log" 2>&1 </dev/null; then
    tail -n 15 "$log" >&2
    say "apt could not install: ${missing[*]}"
    exit 1
  fi
  rm -f "$log"
}

configure_release() {
  local log
  # A compiler cache serves every checkout of the program, wherever it lies.
  export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
  log=$(mktemp)
  if ! cmake --preset release >"$log" 2>&1; then
    cat "$log" >&2
    say "the build could not be configured"
    exit 1
  fi
  rm -f "$log"
}

# build_release TARGET...
build_release() {
  say "building $*"
  if ! cmake --build --preset release --parallel "$(nproc)" --target "$@" >&2; then
    say "the build failed"
    exit 1
  fi
}
