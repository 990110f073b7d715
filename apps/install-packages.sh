#!/usr/bin/env bash
# Installs what is missing of the Debian 12 packages that we build with; asks nothing.
#     apps/install-packages.sh [tests] [worlds] [checks]     the build's own packages are always included
set -euo pipefail

packages=(
    ca-certificates ccache cmake g++ ninja-build
    libboost-dev libeigen3-dev libtclap-dev nlohmann-json3-dev zlib1g-dev
    libmrpt-bayes-dev libmrpt-config-dev libmrpt-obs-dev libmrpt-opengl-dev
    libmrpt-slam-dev
    libopencv-calib3d-dev libopencv-core-dev libopencv-features2d-dev libopencv-imgcodecs-dev
    libopencv-imgproc-dev libopencv-videoio-dev
)
for group in "$@"; do
    case $group in
        worlds) packages+=(povray python3-venv) ;;
        tests) packages+=(libbenchmark-dev libgtest-dev mrpt-apps mrpt-common python3-venv) ;;
        checks) packages+=(clang-format clang-tidy git) ;;
        *) echo "$0: unknown group '$group': tests, worlds or checks" >&2; exit 2 ;;
    esac
done

if ! command -v apt-get >/dev/null; then
    echo "$0: no apt-get here; the build needs what Debian 12 calls: ${packages[*]}" >&2
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $state == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || { echo "$0: to install ${missing[*]}, run me as root" >&2; exit 1; }
    as_root=(sudo)
fi
echo "Installing ${missing[*]}"
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" </dev/null; }
apt update
apt install --yes --no-install-recommends "${missing[@]}" >/dev/null
