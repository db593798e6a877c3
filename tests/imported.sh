#!/bin/sh
# imported.sh ROOT STAGE FOLDER: builds the C++20 interface units over the installation in STAGE, whatever compiler made that,
# installs them into a copy of it, and lets a program that only imports them mark and verify the sample.
set -eu
root=$1 stage=$2 folder=$3

# The system's CMake may be too old; scripts/install-packages modules fetches another one.
for cmake in cmake "$root/build/tools/node_modules/.bin/cmake" none; do
    version=$("$cmake" --version 2>/dev/null | sed -n 's/^cmake version //p')
    [ "$(printf '3.28\n%s\n' "$version" | sort -V | head -n 1)" = 3.28 ] && break
done
for compiler in clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 none; do
    command -v "$compiler" >/dev/null && command -v "clang-scan-deps-${compiler#clang++-}" >/dev/null && break
done
if [ "$cmake" = none ] || [ "$compiler" = none ]; then
    echo "SKIPPED: C++20 modules need CMake 3.28 and clang 17 with its scanner; see scripts/install-packages modules"
    exit 0
fi

rm -rf "$folder"
mkdir -p "$folder"
cp -a "$stage" "$folder/prefix"
export CXX="$compiler"
build() { # SOURCE OPTION...
    "$cmake" -S "$root/$1" -B "$folder/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$folder/prefix" \
        -Wno-dev "-D$2"
    "$cmake" --build "$folder/$1"
}
build cmake/units 'WM3D_UNITS=wm3d;shapes'
"$cmake" --install "$folder/cmake/units" --prefix "$folder/prefix"
build examples/import CMAKE_CXX_SCAN_FOR_MODULES=ON
"$folder/examples/import/import_and_mark"
