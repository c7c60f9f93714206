#!/bin/sh
# A real window under Xvfb, driven by mouse and keyboard: one drag is one undo step, a typed number another, the window
# survives resizing, Ctrl+Q asks and Enter answers. Usage: window_test.sh GALLERY cpu|vulkan [OPTION OF XVFB ...]
set -e
program=$1
renderer=$2
shift 2
for tool in Xvfb xdotool; do
  command -v $tool > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
# The server chooses its number and says it when it is ready: numbers chosen from outside clash with servers that just end.
folder=$(mktemp -d)
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp "$@" 3> "$folder/display" 2> "$folder/server" &
server=$!
trap 'kill "$server" 2> /dev/null; rm -rf "$folder"' EXIT
read -r number < "$folder/display" || { echo "Xvfb did not start:"; cat "$folder/server"; exit 1; }
export DISPLAY=":$number"
unset XAUTHORITY WAYLAND_DISPLAY
out=$folder/out
"$program" --ui "$renderer" --validate > "$out" 2>&1 &
gallery=$!
# The window is there and has drawn when its title can be found; a busy machine may need long.
for i in $(seq 300); do
  id=$(xdotool search --name '^Gallery$' 2> /dev/null | tail -1) && [ -n "$id" ] && break
  sleep 0.2
done
if [ -z "$id" ]; then
  echo "the gallery's window did not appear within a minute; what it said:"
  cat "$out"
  kill "$gallery" 2> /dev/null
  exit 1
fi
sleep 2
xdotool mousemove 1330 163; sleep 0.4
xdotool mousedown 1; sleep 0.4; xdotool mousemove 1360 163; sleep 0.4; xdotool mousemove 1400 163; sleep 0.4
xdotool mouseup 1; sleep 0.4
xdotool mousemove 1500 187; sleep 0.4
xdotool click --repeat 2 --delay 60 1; sleep 0.6
xdotool type --delay 30 0.77; xdotool key Return; sleep 0.6
xdotool mousemove 700 500
xdotool windowsize "$id" 900 600; sleep 1
xdotool windowsize "$id" 1600 1000; sleep 1
xdotool key ctrl+q; sleep 1.5
xdotool key Return
for i in $(seq 50); do
  kill -0 $gallery 2> /dev/null || break
  sleep 0.2
done
kill $gallery 2> /dev/null && { cat "$out"; echo "the window did not close"; exit 1; }
cat "$out"
grep -q "undo steps 2," "$out"
grep -q "validation messages 0" "$out"
