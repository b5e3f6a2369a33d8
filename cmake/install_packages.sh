#!/bin/sh
# Installs what alembert needs from Debian's packages: `install_packages.sh` for building and using it, `install_packages.sh tests` for
# everything the tests use as well, `install_packages.sh reproduce` for the report on the paper,
# `install_packages.sh gallery` for the gallery. Runs as root or through sudo; does nothing where all is installed.
set -eu

packages="cmake g++ make ninja-build pkg-config libeigen3-dev libfmt-dev libcli11-dev libyaml-cpp-dev tao-pegtl-dev libpugixml-dev libassimp-dev libqhull-dev libmeshoptimizer-dev nlohmann-json3-dev libboost-dev libmpfr-dev"
# The page of `simulate --html` is bundled by npm, which may have come with a node that is no Debian package.
command -v npm >/dev/null || packages="$packages npm"
if [ "${1:-}" = reproduce ] || [ "${1:-}" = tests ]; then
  packages="$packages python3 python3-numpy python3-matplotlib python3-yaml"
fi
if [ "${1:-}" = tests ]; then
  packages="$packages git python3 python3-pytest python3-distributed python3-zarr python3-torch clang lld clang-format clang-tidy libclang-rt-14-dev libgtest-dev libgmock-dev libbenchmark-dev
            liborocos-kdl-dev libmujoco-dev libdart-dev libdart-utils-urdf-dev dart-doc libsdformat-dev libsimbody-dev gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm"
fi
if [ "${1:-}" = gallery ] || [ "${1:-}" = tests ]; then
  packages="$packages chromium"
fi

missing=""
for package in $packages; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

as_root=""
[ "$(id -u)" -eq 0 ] || as_root=sudo
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -q
# shellcheck disable=SC2086
$as_root apt-get install -q -y --no-install-recommends $missing
