#!/bin/bash
# The real program in a real window under Xvfb, driven by mouse and keys: open, turn the model, unfold, export, quit.
# Usage: smoke_test.sh NETWRIGHT MODEL. Ends with 77 (skipped) where Xvfb or xdotool are missing.
set -euo pipefail

if [ "${1:-}" != --inside ]; then
  for tool in Xvfb xdotool import compare; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
  done
  # The server picks a free number itself; two that start at once could pick the same one, so they queue.
  numbers=$(mktemp -u)
  mkfifo "$numbers"
  exec 9>"${TMPDIR:-/tmp}/netwright_smoke_test.lock"
  flock 9
  Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$numbers" 2>/dev/null 9>&- &
  server=$!
  trap 'kill "$server" 2>/dev/null || true; rm -f "$numbers"' EXIT
  read -r number <"$numbers"
  sleep 1
  exec 9>&-
  status=0
  DISPLAY=:$number timeout 240 bash "$0" --inside "$@" || status=$?
  exit "$status"
fi

program=$2
model=$3
folder=$(mktemp -d)
trap 'kill "$pid" 2>/dev/null || true; rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config HOME=$folder LIBGL_ALWAYS_SOFTWARE=1
cp "$model" "$folder/model.obj"

fail() { echo "failed: $1 (title: $(xdotool getwindowname "$window" 2>/dev/null))"; exit 1; }

# await WHAT COMMAND…: until the command succeeds, half a minute at most.
await() {
  local what=$1
  shift
  for _ in $(seq 300); do
    if "$@"; then return 0; fi
    sleep 0.1
  done
  fail "$what"
}

title_has() { [[ "$(xdotool getwindowname "$window")" == *"$1"* ]]; }
is_pdf() { [ "$(head -c 4 "$1" 2>/dev/null)" = "%PDF" ]; }
is_there() { [ -s "$1" ]; }
is_gone() { ! kill -0 "$pid" 2>/dev/null; }

# Longer than a frame of software drawing takes, as a finger is.
press() { xdotool keydown "$1"; sleep 0.3; xdotool keyup "$1"; sleep 0.3; }
press_with_control() { xdotool keydown ctrl; press "$1"; xdotool keyup ctrl; }

"$program" "$folder/model.obj" &
pid=$!
window=""
has_window() { window=$(xdotool search --onlyvisible --name Netwright 2>/dev/null | head -n 1); [ -n "$window" ]; }
await "the window comes up" has_window
await "the model is opened" title_has "ready to unfold"
sleep 1

import -window "$window" "$folder/before.png"
eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(WIDTH|HEIGHT)=')"
x=$((WIDTH * 38 / 100))
y=$((HEIGHT / 2))
xdotool mousemove --window "$window" "$x" "$y"
sleep 0.3
xdotool mousedown 1
for step in 20 40 60 80; do
  xdotool mousemove --window "$window" $((x + step)) "$y"
  sleep 0.15
done
xdotool mouseup 1
sleep 1
import -window "$window" "$folder/after.png"
different=$(compare -metric AE "$folder/before.png" "$folder/after.png" null: 2>&1 || true)
[ "${different%%.*}" != 0 ] || fail "dragging turns the model"

press space
await "the model is unfolded" title_has "one piece, proved"
sleep 1
press_with_control p
sleep 1
press Return
await "the pages are exported" is_pdf "$folder/model.pdf"

press_with_control s
sleep 1
press Return
await "the project is saved" is_there "$folder/model.netwright"
press_with_control q
await "the program ends" is_gone
wait "$pid" || fail "the program ends well"
[ -s "$folder/config/netwright/settings.conf" ] || fail "the opened model is remembered"
echo "opened, turned, unfolded, exported and quit"
