#!/usr/bin/env bash
# Tests ./run and its package list in a scratch copy of the project, in a folder with spaces, where dpkg-query, apt-get,
# cmake and ninja are small stand-ins that write down how they were called. Run as: scripts_test.sh PROJECT SCRATCH
set -euo pipefail

project=$1
scratch="$2/a folder with spaces"
rm -rf "$2"
mkdir -p "$scratch/netwright/.ci" "$scratch/tools" "$scratch/elsewhere"
cp "$project/run" "$scratch/netwright/run"
cp "$project/.ci/packages.sh" "$scratch/netwright/.ci/packages.sh"
calls=$scratch/calls
failures=0

tool() {
  printf '#!/bin/bash\n%s\n' "$2" >"$scratch/tools/$1"
  chmod +x "$scratch/tools/$1"
}

for name in bash env readlink dirname basename grep rm cat mkdir chmod; do
  ln -s "$(command -v "$name")" "$scratch/tools/$name"
done
tool id 'echo 0'
tool sudo 'exec "$@"'
tool apt-get 'echo "apt-get $*" >>"$CALLS"'
tool dpkg-query '
  for package in "${@:3}"; do
    [[ " $MISSING " == *" $package "* ]] || echo "$package ii "
  done'
tool cmake '
  echo "cmake in $PWD: $*" >>"$CALLS"
  mkdir -p build/release/bin
  printf "CMAKE_HOME_DIRECTORY:INTERNAL=%s\nNETWRIGHT_TESTS:BOOL=OFF\n" "$PWD" >build/release/CMakeCache.txt
  : >build/release/build.ninja'
tool ninja '
  echo "ninja $*" >>"$CALLS"
  folder=$2
  for program in netwright netwright-cli; do
    printf "#!/bin/bash\necho \"%s in \$PWD: \$*\" >>\"\$CALLS\"\n" "$program" >"$folder/bin/$program"
    chmod +x "$folder/bin/$program"
  done'

# run_with VARIABLES… -- ARGUMENTS…: calls ./run from another folder; leaves calls and output in files.
run_with() {
  local variables=()
  while [[ $1 != -- ]]; do variables+=("$1"); shift; done
  shift
  : >"$calls"
  status=0
  (cd "$scratch/elsewhere" && env -i PATH="$scratch/tools" CALLS="$calls" "${variables[@]}" \
    "$scratch/netwright/run" "$@") >"$scratch/output" 2>&1 </dev/null || status=$?
}

expect() {
  local what=$1
  shift
  if ! "$@"; then
    echo "FAILED: $what"
    sed 's/^/    called: /' "$calls"
    sed 's/^/    said:   /' "$scratch/output"
    failures=$((failures + 1))
  fi
}

called() { grep -qE -- "$1" "$calls"; }
not_called() { ! grep -qE -- "$1" "$calls"; }
said() { grep -qE -- "$1" "$scratch/output"; }
ended_with() { [[ $status == "$1" ]]; }

run_with MISSING="ninja-build libcairo2-dev" -- --build
expect "missing packages are installed" called '^apt-get .*install .*--no-install-recommends (ninja-build libcairo2-dev|libcairo2-dev ninja-build)$'
expect "the package lists are refreshed first" called '^apt-get .* update$'
expect "the build is configured in the project's folder" called "^cmake in $scratch/netwright: --preset release"
expect "--build builds both programs" called '^ninja .*netwright netwright-cli$'
expect "--build starts nothing" not_called '^netwright'
expect "--build succeeds" ended_with 0

run_with MISSING= DISPLAY=:7 -- "my model.obj"
expect "nothing is installed twice" not_called '^apt-get'
expect "nothing is configured twice" not_called '^cmake'
expect "the editor opens the model, in the caller's folder" called "^netwright in $scratch/elsewhere: my model.obj$"

run_with MISSING= WAYLAND_DISPLAY=wayland-0 --
expect "without a file the editor opens the bunny" called 'netwright in .*: .*/netwright/assets/samples/bunny_370.obj$'

run_with MISSING= -- "models/my model.obj"
expect "without a display the model becomes a PDF here" called "^netwright-cli in $scratch/elsewhere: unfold models/my model.obj -o ./my model.pdf$"
expect "without a display it says so" said 'no display'
expect "it says where the PDF is" said "$scratch/elsewhere/my model.pdf"

printf 'CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else\n' >"$scratch/netwright/build/release/CMakeCache.txt"
: >"$scratch/netwright/build/release/leftover"
run_with MISSING= -- --build
expect "a build folder of another place is configured afresh" called '^cmake'
expect "and emptied before" test ! -e "$scratch/netwright/build/release/leftover"

rm "$scratch/netwright/build/release/build.ninja"
run_with MISSING= -- --build
expect "a half made build folder is configured afresh" called '^cmake'

run_with MISSING= -- --help
expect "--help explains" said '^Usage: ./run'
expect "--help builds nothing" not_called .

rm "$scratch/tools/dpkg-query"
run_with -- --build
expect "without apt the packages are named" said 'libcairo2-dev'
expect "and the build goes on" called '^ninja .*netwright netwright-cli$'

if ((failures)); then
  echo "$failures failed"
  exit 1
fi
echo "all passed"
