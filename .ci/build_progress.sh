# Sourced by calibrate/demo and tests/run.

# Passes on the output of ninja or ctest, and prints on descriptor 3 a line for each tenth of their
# steps that is done, so that whoever waits sees how far it is.
build_progress() { # build_progress UNIT: "steps", "tests"
  local line tenth last=0 start=$SECONDS
  while IFS= read -r line || [ -n "$line" ]; do
    printf '%s\n' "$line"
    [[ $line =~ ^(\[|\ *)([0-9]+)/([0-9]+)(\]|\ Test\ ) ]] || continue
    tenth=$((10 * BASH_REMATCH[2] / BASH_REMATCH[3]))
    if [ $tenth -gt $last ]; then
      printf '   %d of %d %s, %d s\n' "${BASH_REMATCH[2]}" "${BASH_REMATCH[3]}" "$1" \
        $((SECONDS - start)) >&3
      last=$tenth
    fi
  done
}
