#!/usr/bin/env bash
# Runs every test: the release build with all of them (unit tests, and POV-Ray as the reference), then the unit tests
# again under AddressSanitizer + UndefinedBehaviorSanitizer, with half a minute of random scenes for the parser and for
# the renderer, and those of what has threads under ThreadSanitizer. Needs no display.
# Installs what is missing (Debian packages), builds what changed. The last line is the count of all of them.
set -uo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")" || exit 1
. .ci/setup.sh

passed=0 failed=0 skipped=0
finish() {
  echo
  if [ "$skipped" -gt 0 ]; then
    echo "$passed passed, $failed failed, $skipped skipped"
  else
    echo "$passed passed, $failed failed"
  fi
  exit $((failed > 0 || passed == 0))
}

declare -A builder  # the process group that builds a preset
before=
trap 'kill -- "${builder[@]/#/-}" 2>/dev/null; exit 130' INT TERM  # what is in the background ends with the script

# build_next PRESET TARGET...: builds in the background, after the presets before it, with what their tests leave of the
# processors.
build_next() {
  local preset=$1
  mkdir -p build
  set -m  # in a process group of its own
  (
    if [ -n "$before" ]; then
      tail --pid="$before" -f /dev/null
      renice -n 19 "$BASHPID" >/dev/null
    fi
    build "$@"
  ) >"build/$preset.log" 2>&1 &
  set +m
  before=$!
  builder[$preset]=$before
}

# run PRESET CTEST-OPTION...: shows how the preset is built and runs the tests chosen, adding to the count.
run() {
  local preset=$1
  shift
  tail -n +1 --pid="${builder[$preset]}" -f "build/$preset.log"
  if ! wait "${builder[$preset]}"; then
    say "The $preset build failed"
    failed=$((failed + 1))
    return
  fi
  say "Testing build/$preset"
  local report=$PWD/build/$preset/tests.xml
  rm -f "$report"
  ctest --test-dir "build/$preset" --output-on-failure --no-tests=error -j "$(nproc)" --output-junit "$report" "$@"
  local result=$?
  if [ ! -f "$report" ]; then
    failed=$((failed + 1))
    return
  fi
  local all ok unused
  all=$(grep -c '<testcase ' "$report")
  ok=$(grep '<testcase ' "$report" | grep -c 'status="run"')
  unused=$(grep -cE '<skipped |status="disabled"' "$report")
  passed=$((passed + ok))
  skipped=$((skipped + unused))
  failed=$((failed + all - ok - unused))
  if [ $result -ne 0 ] && [ "$all" -eq $((ok + unused)) ]; then
    failed=$((failed + 1))  # ctest itself failed: no test found, for one
  fi
}

install_missing $build_packages $test_packages || { failed=1; finish; }
build_next release all
build_next asan firstlight_unit_tests firstlight_parser_fuzz firstlight_render_fuzz
build_next tsan firstlight_unit_tests
run release -j "$((2 * $(nproc)))"  # POV-Ray sleeps for most of the time that a small picture takes it
run asan -L "unit|fuzz"
run tsan -L unit
finish
