# Set-up shared by scripts/run, scripts/test and scripts/gpu-check: installs what is missing, configures, builds.
# Sourced, not run. Of a script that is called with --help it prints the comment at its head, and ends it.
set -euo pipefail

for word in "$@"; do  # before anything is installed
  if [[ $word == -h || $word == --help ]]; then
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
    exit 0
  fi
done

vug_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

vug_packages=(
  g++ cmake ninja-build ca-certificates
  libeigen3-dev libhdf5-dev libtomlplusplus-dev libcli11-dev libfmt-dev libpng-dev libtiff-dev zlib1g-dev libboost-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  python3 python3-numpy python3-h5py python3-matplotlib
)

vug_fail() {
  printf 'vug: %s\n' "$*" >&2
  exit 1
}

# Installs the packages that are missing, with one apt-get update at most.
vug_install_packages() {
  local missing=() package
  if ! command -v dpkg-query >/dev/null; then
    for package in cmake ninja c++ python3; do
      command -v "$package" >/dev/null || missing+=("$package")
    done
    if ((${#missing[@]})); then
      vug_fail "not a Debian or Ubuntu system, and these commands are missing: ${missing[*]} (README, \"Other systems\", lists all that is needed)"
    fi
    return 0
  fi
  for package in "${vug_packages[@]}"; do
    [[ $(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null) == ii* ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || vug_fail "these packages are missing and there is no sudo to install them: ${missing[*]}"
    as_root=(sudo)
  fi
  printf 'vug: installing %s\n' "${missing[*]}" >&2
  local log
  log=$(mktemp)
  if ! { "${as_root[@]}" apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    vug_fail "installing packages failed; the lines above are from apt-get (full log: $log)"
  fi
  rm -f "$log"
}

# Configures and builds the given preset: -D... go to CMake, further arguments to the build tool. In CI a warning is an
# error.
vug_build() {
  local preset=$1 options=()
  shift
  [[ -z ${CI+set} ]] || options+=(-DVUG_WERROR=ON)
  while [[ ${1:-} == -D* ]]; do
    options+=("$1")
    shift
  done
  cd "$vug_root"
  local log="build/$preset.log"
  mkdir -p build
  if ! cmake --preset "$preset" "${options[@]}" >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    vug_fail "configuring failed; the lines above are the end of $log"
  fi
  cmake --build --preset "$preset" "$@"
}

vug_install_packages
