# Sourced by the scripts of this folder, never run: where things are, and how to build.
# shellcheck shell=bash

# Following symlinks, so that a link to a script from anywhere finds its checkout.
scripts_dir="$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
root="$(dirname "$scripts_dir")"
export build="$root/build"
# Not below build/, where catkin would put it: rosrun ignores programs in a package's build folder.
export devel="$root/devel"
export package=footprint_collision_predictor

# A python3 in front of the system's (pyenv, conda) has no catkin_pkg and breaks catkin.
export PATH="/usr/bin:$PATH"

die() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}

# Prints debian-12, ubuntu-20.04 or whatever this is.
system_name() {
  # shellcheck disable=SC1091
  (. /etc/os-release 2>/dev/null && printf '%s-%s' "${ID:-unknown}" "${VERSION_ID:-}") || printf unknown
}

# ROS's own set-up files use unset variables.
source_relaxed() {
  set +u
  # shellcheck disable=SC1090
  . "$1"
  set -u
}

# After `setup`: makes the ROS of this system known. Debian 12 has it in /usr and needs nothing.
use_ros() {
  if [[ "$(system_name)" == ubuntu-20.04 ]]; then
    source_relaxed /opt/ros/noetic/setup.bash
    export PATH="/usr/bin:$PATH"
  fi
}

# configure [CMake options]: one build folder for all scripts; what is already built stays.
configure() {
  mkdir -p "$build"
  local log="$build/configure.log" cli11
  # Where `setup` has put CLI11, on a system that has no package of it.
  cli11="$(find "$build/deps" -name CLI11Config.cmake 2>/dev/null || true)"
  cmake -S "$root" -B "$build" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_BUILD_TYPE=Release \
    -DCATKIN_DEVEL_PREFIX="$devel" \
    ${cli11:+-DCLI11_DIR="$(dirname "$cli11")"} "$@" >"$log" 2>&1 ||
    { tail -n 30 "$log" >&2; die "configuring failed; everything it said is in $log"; }
}

# build_targets TARGET...: quiet unless it fails.
build_targets() {
  local log="$build/build.log" jobs
  jobs="$(nproc)"
  cmake --build "$build" --parallel "$jobs" --target "$@" >"$log" 2>&1 ||
    { grep -n -m 10 -E 'error|Error' "$log" >&2 || tail -n 30 "$log" >&2
      die "building failed; everything it said is in $log"; }
}
