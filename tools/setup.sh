#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the missing Debian packages that Welkin needs to build, bake and draw.
#   tools/setup.sh [--tests]      --tests: also the packages that only the tests need
set -eu

# to build: compiler, build system, shader compiler, translator and optimiser, schema compiler
build="g++ cmake ninja-build pkg-config glslang-tools spirv-cross spirv-tools spirv-headers flatbuffers-compiler"
# linked by the libraries and the tool
link="libfmt-dev libsleef-dev libtbb-dev libopenexr-dev libimath-dev libopenimageio-dev libwebp-dev libjpeg-dev libpng-dev libtiff-dev libtomlplusplus-dev libxxhash-dev
libeigen3-dev libflatbuffers-dev libhwy-dev libcli11-dev nlohmann-json3-dev libtinygltf-dev libmeshoptimizer-dev libdraco-dev libembree-dev libvulkan-dev libvulkan-volk-dev libcairo2-dev libstb-dev libopencv-contrib-dev
libimgui-dev libglfw3-dev"
# for pictures: a Vulkan device for machines without one, a font for labels, a plotter for the charts of a study
draw="mesa-vulkan-drivers fonts-dejavu-core gnuplot-nox"
test=""
if [ "${1-}" = --tests ]; then
  test="catch2 clang libbenchmark-dev libclang-rt-14-dev libfilament-dev libfilament-tools libnova-dev libegl1 libgl1-mesa-dri libgles2 mono-mcs vulkan-validationlayers openexr parallel
libxtst-dev xvfb libdbus-1-3 libhwloc15 libjson-c5 libreadline8 libyaml-0-2"
  command -v npm >/dev/null || test="$test nodejs npm"  # other packages of Node.js bring an npm of their own
fi

missing=""
for package in $build $link $draw $test; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing="$missing $package"
done
if [ -n "$missing" ]; then
  echo "setup: installing$missing"
  root=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "setup: run this as root, or install:$missing" >&2; exit 1; }
    root="sudo"
  fi
  export DEBIAN_FRONTEND=noninteractive
  $root apt-get update -qq
  # shellcheck disable=SC2086  # a list of packages
  $root apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi

# The tests' own Slurm is unpacked and not installed: on a machine with systemd its daemons would start.
slurm="$(dirname "$0")/../build/slurm"
if [ "${1-}" = --tests ] && [ ! -x "$slurm/usr/sbin/slurmctld-wlm" ]; then
  mkdir -p "$slurm"
  if ! (cd "$slurm" && apt-get download -qq liblua5.1-0 libmunge2 slurm-wlm-basic-plugins slurm-client slurmd slurmctld \
      >/dev/null 2>&1 && for package in *.deb; do dpkg -x "$package" . && rm "$package"; done); then
    rm -rf "$slurm"
    echo "setup: Slurm cannot be had: its test will be skipped"
  fi
fi

# Where a compiler for ARM64 is, also its libraries that a bake of a sky links. They are unpacked and not installed, beside
# the machine's own of the same names.
arm64="$(dirname "$0")/../build/arm64_packages"
if [ "${1-}" = --tests ] && command -v aarch64-linux-gnu-g++ >/dev/null && [ ! -e "$arm64/usr/include/aarch64-linux-gnu/sleef.h" ]; then
  mkdir -p "$arm64/lists/partial" "$arm64/cache"
  apt() {
    timeout 120 apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o "Dir::State::Lists=$arm64/lists" \
      -o "Dir::Cache=$arm64/cache" "$@" >/dev/null 2>&1
  }
  arm64="$(cd "$arm64" && pwd)"
  if ! (cd "$arm64" && apt update && apt download libsleef3 libsleef-dev libtbb12 libfmt9 libxxhash0 libopenexr-3-1-30 libimath-3-1-29 zlib1g \
      && for package in *.deb; do dpkg -x "$package" . && rm "$package"; done && rm -rf lists cache); then
    rm -rf "$arm64"
    echo "setup: the libraries of ARM64 cannot be had: cross.arm64.same_bytes will be skipped"
  fi
fi

# Readers by someone else, for the tests: of KTX2, and of WGSL (Dawn, of which the other systems' programs go again).
fetch() {  # fetch FOLDER PACKAGE VERSION: by npm into build/FOLDER, once
  folder="$(dirname "$0")/../build/$1"
  [ ! -d "$folder/node_modules/$2" ] || return 0
  mkdir -p "$folder"
  if ! (cd "$folder" && timeout 120 npm install --fetch-retries=1 --no-audit --no-fund --no-save --ignore-scripts --prefix . "$2@$3" >/dev/null 2>&1); then
    rm -rf "$folder"
    echo "setup: $2 cannot be had from npm: its test will be skipped"
  fi
}
if [ "${1-}" = --tests ]; then
  fetch npm ktx-parse 2.0.0
  fetch webgpu webgpu 0.6.2
  for system in darwin-universal win32-arm64 win32-x64 linux-arm64; do
    [ "$system" = "linux-$(uname -m | sed 's/aarch64/arm64/')" ] ||
      rm -rf "$(dirname "$0")/../build/webgpu/node_modules/webgpu/dist/$system"
  done
fi
