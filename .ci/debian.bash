# A bare Debian in a folder, from where this machine gets its own packages. To be sourced.
# shellcheck shell=bash

# make_debian DIR OPTION...: options go to mmdebstrap. Release and sources are those of the machine.
make_debian() {
  local folder=$1 source release sources=()
  shift
  # shellcheck disable=SC1091  # a file of the system
  release=$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")
  for source in /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
    /etc/apt/sources.list.d/*.sources; do
    # Only Debian's own: others may not have the architecture, nor a key that fits.
    if [[ -e $source ]] && grep -qw "$release" "$source"; then sources+=("$source"); fi
  done
  mmdebstrap --quiet "$@" "$release" "$folder" "${sources[@]}"
}
