#!/usr/bin/env bash
# Installs into a scratch folder and looks at what is there: every file in its place, valid where a validator is at hand,
# the manual pages agreeing with --help, the programs working from where they are. Makes the Debian package, too, where
# dpkg is. Run as: install_test.sh BUILD SCRATCH
set -euo pipefail

build=$1
scratch=$2
failures=0
rm -rf "$scratch"
mkdir -p "$scratch"

fail() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

# options_of FILE: the long options that a text names, one a line.
options_of() {
  grep -oE -- '--[a-z][a-z-]+' "$1" | sort -u
}

check_files() {
  local file
  for file in bin/netwright bin/netwright-cli libexec/netwright/netwright-read share/man/man1/netwright.1 \
    share/man/man1/netwright-cli.1 share/applications/netwright.desktop share/mime/packages/netwright.xml \
    share/metainfo/org.netwright.Netwright.metainfo.xml share/icons/hicolor/scalable/apps/netwright.svg \
    share/icons/hicolor/{16x16,32x32,48x48,64x64,128x128,256x256}/apps/netwright.png share/doc/netwright/copyright; do
    [[ -s $installed/$file ]] || fail "$file is not installed"
  done
  for file in "$installed"/share/icons/hicolor/*x*/apps/netwright.png; do
    [[ $file == */"$(head -c 24 "$file" | tail -c 8 | od -An -tu1 | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }')"/* ]] ||
      fail "$file has another size than its folder says"
  done
}

check_formats() {
  local share=$installed/share
  if command -v desktop-file-validate >/dev/null; then
    desktop-file-validate "$share/applications/netwright.desktop" || fail "the desktop entry is not valid"
  fi
  if command -v appstreamcli >/dev/null; then
    appstreamcli validate --no-net "$share/metainfo/org.netwright.Netwright.metainfo.xml" >"$scratch/appstream" ||
      fail "the metainfo is not valid: $(cat "$scratch/appstream")"
  fi
  if command -v update-mime-database >/dev/null; then
    XDG_DATA_DIRS=$share update-mime-database "$share/mime" >"$scratch/mime" 2>&1 || fail "the MIME types are not valid"
    [[ ! -s $scratch/mime ]] || fail "the MIME types are not valid: $(cat "$scratch/mime")"
    grep -q '^50:application/x-netwright:\*\.netwright$' "$share/mime/globs2" || fail "projects have no MIME type"
  fi
}

# The options in a manual page are those of --help, no more and no less.
check_manual() {
  local program=$1 page=$installed/share/man/man1/$1.1
  shift
  sed 's/\\-/-/g; s/\\f.//g' "$page" >"$scratch/page"
  cat "$@" >"$scratch/help"
  diff <(options_of "$scratch/help") <(options_of "$scratch/page") ||
    fail "$program.1 and $program --help name different options (< only in --help, > only in the manual page)"
  if command -v groff >/dev/null; then
    [[ -z $(groff -man -Tutf8 -ww -z "$page" 2>&1) ]] || fail "$program.1 is no clean manual page"
  fi
}

check_manuals() {
  local command
  "$installed/bin/netwright" --help >"$scratch/netwright.help"
  check_manual netwright "$scratch/netwright.help"
  "$installed/bin/netwright-cli" --help >"$scratch/cli.help"
  for command in unfold verify info bench; do
    "$installed/bin/netwright-cli" "$command" --help >"$scratch/cli.$command.help"
  done
  check_manual netwright-cli "$scratch"/cli*.help
}

# An STL file is read by the helper program, which has to be found where it was installed.
check_programs() {
  local cli=$installed/bin/netwright-cli
  cat >"$scratch/tetrahedron.stl" <<'END'
solid t
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 1 0 vertex 1 0 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 1 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 1 vertex 0 1 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 1 0 0 vertex 0 1 0 vertex 0 0 1 endloop endfacet
endsolid t
END
  "$cli" unfold "$scratch/tetrahedron.stl" -o "$scratch/t.pdf" -o "$scratch/t.netwright" >"$scratch/said" 2>&1 ||
    fail "the installed netwright-cli: $(cat "$scratch/said")"
  [[ $(head -c 4 "$scratch/t.pdf") == %PDF ]] || fail "the installed netwright-cli wrote no PDF"
  [[ $(head -c 61 "$scratch/t.netwright" | tail -c 31) == mimetypeapplication/x-netwright ]] ||
    fail "a project does not begin as its MIME type says"
  "$installed/bin/netwright" --version | grep -q '^netwright [0-9]' || fail "the installed netwright does not start"
}

check_package() {
  command -v dpkg-shlibdeps >/dev/null || return 0
  (cd "$build" && cpack -G DEB -B "$scratch/package" >"$scratch/cpack.log" 2>&1) || fail "cpack: $(cat "$scratch/cpack.log")"
  local package
  package=$(echo "$scratch"/package/netwright_*.deb)
  dpkg-deb --field "$package" Depends | grep -q 'libcairo2' || fail "the package does not depend on the libraries it needs"
  dpkg-deb --contents "$package" >"$scratch/contents"
  grep -q " ./usr/libexec/netwright/netwright-read$" "$scratch/contents" || fail "the package lacks the helper"
}

DESTDIR=$scratch/root cmake --install "$build" --prefix /usr >"$scratch/log"
installed=$scratch/root/usr
check_files
check_formats
check_manuals
check_programs
check_package
[[ $failures == 0 ]] || exit 1
rm -rf "$scratch"
