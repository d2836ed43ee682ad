# The one list of Debian packages, and how to install what is missing of it. Sourced by run and test.

build_packages=(
  g++ cmake ninja-build pkg-config python3-glad
  libglfw3-dev libimgui-dev libglm-dev libeigen3-dev libgl-dev libegl-dev
  libtinyobjloader-dev libtinygltf-dev libassimp-dev libstb-dev
  libcairo2-dev libfreetype-dev libcli11-dev nlohmann-json3-dev libzip-dev libqpdf-dev
  libgl1 libgl1-mesa-dri libegl1 libegl-mesa0)
test_packages=(libgtest-dev xvfb xauth xdotool x11-utils imagemagick poppler-utils mupdf-tools
  librsvg2-bin python3-ezdxf desktop-file-utils appstream shared-mime-info groff-base dpkg-dev python3)
lint_packages=(clang-format clang-tidy-16)

say() { printf '%s\n' "$*" >&2; }

# need PACKAGES…: afterwards they are installed. Asks dpkg first, so that nothing happens when nothing is missing.
need() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "There is no apt here. Netwright needs what Debian 12 calls:"
    say "  $*"
    say "Going on in the hope that all of it is installed."
    return 0
  fi
  local package status states missing=()
  local -A installed=()
  states=$(dpkg-query -W -f='${Package} ${db:Status-Abbrev}\n' "$@" 2>/dev/null) || true  # it fails when some are missing
  while read -r package status; do
    [[ $status != ?i* ]] || installed[$package]=yes
  done <<<"$states"
  for package in "$@"; do
    [[ -n ${installed[$package]:-} ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      say "These Debian packages are missing, and installing them takes root or sudo. As root, run:"
      say "  apt-get install --no-install-recommends ${missing[*]}"
      return 1
    fi
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} missing packages: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600)
  "${apt[@]}" update || say "The package lists could not be refreshed; trying with the old ones."
  "${apt[@]}" -o Dpkg::Use-Pty=0 install -y --no-install-recommends "${missing[@]}" >/dev/null </dev/null || {
    say "apt-get could not install all of: ${missing[*]}"
    return 1
  }
}

# configure PRESET OPTIONS…: makes build/PRESET ready for ninja. Does nothing when it is ready and has these options;
# starts over when it was left half made or belongs to a folder of another name.
configure() {
  local preset=$1 option key ready=yes
  local folder=$root/build/$preset
  local cache=$folder/CMakeCache.txt
  shift
  if [[ -d $folder ]] && { [[ ! -f $folder/build.ninja ]] || ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; }; then
    rm -rf "$folder"
  fi
  [[ -f $folder/build.ninja ]] || ready=no
  for option in "$@"; do
    key=${option#-D}
    [[ $ready == yes ]] && grep -qx "${key%%=*}:[A-Z]*=${key#*=}" "$cache" || ready=no
  done
  [[ $ready == yes ]] || (cd "$root" && cmake --preset "$preset" "$@" --log-level=WARNING) >&2
}
