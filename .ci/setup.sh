# Shared by render.sh and test.sh, which source it: installs what is missing and builds. Debian 12 package names.

build_packages="clang cmake ninja-build libembree-dev libtbb-dev libimath-dev libopenimageio-dev libpng-dev libturbojpeg0-dev
  libhwy-dev libfmt-dev nlohmann-json3-dev libcli11-dev libgtest-dev libbenchmark-dev"
render_packages="povray-includes"  # the standard include files, found where the package puts them
# The reference that the pictures are compared with, the sanitizers, and the browser that opens reports.
test_packages="povray povray-includes povray-examples libclang-rt-14-dev chromium"

say() { printf '\033[1m==>\033[0m %s\n' "$*"; }

# install_missing PACKAGES...: apt-get installs those that dpkg does not have; says nothing when there are none.
install_missing() {
  local package missing=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "Please install as root: apt-get install ${missing[*]}"; return 1; }
    as_root=(sudo)
  fi
  say "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq || say "apt-get update failed; trying with the package lists that are here"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# build PRESET TARGET...: configures build/PRESET when it must be, then builds the targets. Quiet unless it fails.
build() {
  local preset=$1 folder=build/$1 werror=${FIRSTLIGHT_WERROR:-OFF}
  shift
  if [ ! -f "$folder/build.ninja" ] || [ CMakePresets.json -nt "$folder/build.ninja" ] ||
    ! grep -q "^FIRSTLIGHT_WERROR:BOOL=$werror\$" "$folder/CMakeCache.txt"; then
    say "Configuring $folder"
    mkdir -p "$folder"
    cmake --fresh --preset "$preset" -DFIRSTLIGHT_WERROR="$werror" >"$folder/configure.log" 2>&1 ||
      { cat "$folder/configure.log"; return 1; }
  fi
  say "Building $folder"
  cmake --build "$folder" --target "$@"
}
