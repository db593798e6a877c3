#!/bin/sh
# packaged.sh CPACK BUILD FOLDER KEY: makes the Debian packages of a build, lets dpkg install them into a folder of their own, marks
# and verifies the sample with what is there, and removes them again.
set -eu
cpack=$1 build=$2 folder=$3 key=$4
for tool in dpkg dpkg-shlibdeps file; do
    if ! command -v "$tool" >/dev/null; then
        echo "SKIPPED: $tool is not installed"
        exit 0
    fi
done

rm -rf "$folder"
mkdir -p "$folder"
# The quickest compression: what is tested is what is inside.
"$cpack" --config "$build/CPackConfig.cmake" -B "$folder/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip

fail() {
    echo "$*"
    exit 1
}
# needs PACKAGE NAME...: PACKAGE declares that it depends on these.
needs() {
    package=$(ls "$folder/packages/$1"_*.deb)
    depends=", $(dpkg-deb -f "$package" Depends)"
    shift
    for name in "$@"; do
        case $depends in
            *", $name"*) ;;
            *) fail "$package does not depend on $name: $depends" ;;
        esac
    done
}
needs wm3d libc6 libsodium23 libfmt libtbb
needs libwm3d-dev libeigen3-dev libfmt-dev libsodium-dev libtbb-dev

# What the packages depend on is on this machine, not in the folder, so it is not asked for.
root=$folder/root
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
: >"$root/var/lib/dpkg/status"
: >"$root/var/lib/dpkg/available"
PATH=$PATH:/usr/sbin:/sbin
dpkg --root="$root" --force-not-root --force-depends --force-script-chrootless --log="$folder/dpkg.log" \
    -i "$folder"/packages/*.deb >"$folder/dpkg.out" 2>&1 || fail "$(cat "$folder/dpkg.out")"
for file in share/man/man1/wm3d.1.gz share/bash-completion/completions/wm3d include/wm3d/wm3d.hpp \
    share/doc/wm3d/copyright share/doc/libwm3d-dev/copyright share/doc/wm3d/NEWS.gz; do
    [ -f "$root/usr/$file" ] || fail "the packages lack $file"
done

wm3d=$root/usr/bin/wm3d
cd "$folder"
"$wm3d" sample -q -o sample.ply
"$wm3d" keygen -q new.key >new.txt
"$wm3d" mark -q sample.ply -o marked.ply --key "$key" >mark.txt
"$wm3d" verify marked.ply --key "$key"
if "$wm3d" verify -q sample.ply --key "$key" >original.txt; then
    fail "the unmarked sample is said to be marked"
fi

packages=$root/usr/lib/python3/dist-packages
if [ -d "$packages" ] && /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$packages /usr/bin/python3 -c '
import sys, wm3d
mesh = wm3d.read("marked.ply")
assert wm3d.verify(mesh.vertices, mesh.faces, wm3d.Key.load(sys.argv[1])).verdict == "present"' "$key"
fi

if command -v lintian >/dev/null; then
    lintian --fail-on error "$folder"/packages/*.deb ||
        fail "lintian found errors"
fi

dpkg --root="$root" --get-selections | cut -f1 |
    xargs dpkg --root="$root" --force-not-root --log="$folder/dpkg.log" -P >"$folder/dpkg.out" 2>&1 ||
    fail "$(cat "$folder/dpkg.out")"
[ ! -e "$root/usr" ] || fail "the packages leave behind: $(find "$root/usr" -type f)"
