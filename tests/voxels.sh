#!/bin/sh
# voxels.sh STAGE FOLDER: the installed command finds the library of its attack voxels wherever the prefix is moved to,
# and says what is missing where the command was copied alone.
set -eu
stage=$1 folder=$2
fail() {
    echo "$*"
    exit 1
}

rm -rf "$folder"
mkdir -p "$folder/alone"
cp -R "$stage" "$folder/moved"
cp "$stage/bin/wm3d" "$folder/alone/wm3d"
cd "$folder"
moved/bin/wm3d sample -q -o sample.ply --faces 2000
moved/bin/wm3d attack voxels:16 -q sample.ply -o voxels.ply
[ -s voxels.ply ] || fail "voxels wrote nothing"

status=0
alone/wm3d attack voxels:16 sample.ply -o alone.ply 2>error.txt || status=$?
if [ $status = 0 ]; then
    echo "SKIPPED: wm3d is installed where this build would be, so its library is found there"
    exit 0
fi
[ $status = 2 ] || fail "without its library voxels ends with status $status"
grep -q "needs the library wm3d_voxels" error.txt || fail "no word of the library: $(cat error.txt)"
[ "$(wc -l <error.txt)" = 1 ] || fail "more than a line: $(cat error.txt)"
[ ! -e alone.ply ] || fail "something was written"
alone/wm3d attack noise:0.1 -q sample.ply -o noise.ply || fail "another attack fails too"
