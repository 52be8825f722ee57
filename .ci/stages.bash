# What .ci/run and .ci/nightly share: stages, each timed and run in a shell of its own; all run, and
# one failure fails the whole. To be sourced by a script that defines an array `stages` and a
# function of each of its names, and then calls `run_stages "$@"`.
# shellcheck shell=bash

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CI=${CI:-true} DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2034  # the stages use it
jobs=$(nproc)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Every C++ file of the tree; builds are passed over.
sources() {
  find . -name 'build*' -prune -o -type f \( -name '*.cpp' -o -name '*.hpp' \) -print
}

# Installs Debian packages that only some stages need.
install_tools() {
  apt-get -q update
  apt-get -q -y install --no-install-recommends "$@"
}

# Runs a stage so that any failing command ends it, and notes how it went. What a failed stage said is
# said again before the summary, as far as it tells why.
failed=0
summary=""
reasons=""
run_stage() {
  local name=$1 start=$SECONDS status verdict=ok said=$work/said.$1
  printf '\n=== %s\n' "$name"
  set +e
  (
    set -e
    "$name"
  ) </dev/null 2>&1 | tee "$said"
  status=${PIPESTATUS[0]}
  set -e
  if ((status != 0)); then
    verdict="FAILED (exit $status)"
    failed=1
    reasons+=$(printf '\n=== why %s failed\n' "$name" && why "$said")$'\n'
  fi
  rm -f "$said"
  summary+=$(printf '%-17s %5d s  %s' "$name" $((SECONDS - start)) "$verdict")$'\n'
  printf '=== %s: %s, %d s\n' "$name" "$verdict" $((SECONDS - start))
}

# The lines of a log that look like errors, and its end.
why() {
  grep -nE -A4 'error:|Error |FAILED|Failed|undefined reference|No such file' "$1" | cut -c 1-300 | head -n 60 || true
  printf -- '--- its last lines\n'
  tail -n 25 "$1" | cut -c 1-300
}

# All stages, or those that are named; the last lines sum up. Exits with 1 if one failed.
run_stages() {
  local name wanted=("$@")
  [[ $# -gt 0 ]] || wanted=("${stages[@]}")
  for name in "${wanted[@]}"; do
    [[ " ${stages[*]} " == *" $name "* ]] || {
      printf 'no such stage: %s; there are: %s\n' "$name" "${stages[*]}" >&2
      exit 2
    }
  done
  for name in "${wanted[@]}"; do
    run_stage "$name"
  done
  printf '%s' "$reasons"
  printf '\n=== summary\n%stotal             %5d s\n' "$summary" "$SECONDS"
  exit "$failed"
}
