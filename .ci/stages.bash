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

# Runs a stage so that any failing command ends it, and notes how it went.
failed=0
summary=""
run_stage() {
  local name=$1 start=$SECONDS status verdict=ok
  printf '\n=== %s\n' "$name"
  set +e
  (
    set -e
    "$name"
  ) </dev/null 2>&1
  status=$?
  set -e
  if ((status != 0)); then
    verdict="FAILED (exit $status)"
    failed=1
  fi
  summary+=$(printf '%-17s %5d s  %s' "$name" $((SECONDS - start)) "$verdict")$'\n'
  printf '=== %s: %s, %d s\n' "$name" "$verdict" $((SECONDS - start))
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
  printf '\n=== summary\n%stotal             %5d s\n' "$summary" "$SECONDS"
  exit "$failed"
}
