#!/bin/sh
# pkg_config.sh COMPILER PKGCONFIG_FOLDER SOURCE FOLDER WM3D KEY: builds an example by what pkg-config tells, marks the sample
# with it, and lets the executable verify the mark.
set -eu
compiler=$1 source=$3 wm3d=$5 key=$6
if ! command -v pkg-config >/dev/null; then
    echo "SKIPPED: pkg-config is not installed"
    exit 0
fi
export PKG_CONFIG_PATH="$2"
cd "$4"
# shellcheck disable=SC2046 # words are meant
"$compiler" -std=c++20 -O1 "$source" -o pkg-config-example $(pkg-config --cflags --libs wm3d)
rm -f pkg.ply pkg-marked.ply
"$wm3d" sample -q -o pkg.ply
./pkg-config-example pkg.ply pkg-marked.ply "$key"
"$wm3d" verify -q pkg-marked.ply --key "$key"
