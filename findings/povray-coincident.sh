#!/usr/bin/env bash
# POV-Ray: spheres behind the camera decide which of two coincident discs is seen in front of it.
#
# One would guess: of two opaque surfaces at the same place the first or the last in the file wins, or there are speckles of
#   both; in any case objects out of sight have no say.
# What happens: without bounding (-MB) the first in the file wins. With it, as by default, the one that the bounding tree comes
#   to first wins, and the tree is another one for every number of objects: the overlap of the same two discs is red, blue
#   with one small sphere behind the camera, and red again with three. No speckles, so nothing hints at the conflict.
# Seen in: 3.7.0.10.
# ropelight instead: surfaces at the same place are stacked by a rule of the scene format, whatever else is in the scene.
set -euo pipefail

package=povray=1:3.7.0.10-2+b2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# The program, and what this machine lacks of the libraries that it needs.
apt-get install -s --no-install-recommends "$package" >plan
mapfile -t missing < <(awk '$1 == "Inst" && $2 != "povray" { for (i = 3; $i !~ /^\(/; ++i); print $2 "=" substr($i, 2) }' plan)
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "$package" "${missing[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "package: $package"
lib=$PWD/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$lib:$lib/pulseaudio:$PWD/root/lib/x86_64-linux-gnu

cat >scene.pov <<'POV'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
#macro Plate(Place, Colour)
  disc { Place, z, 1 pigment { rgb Colour } finish { emission 1 diffuse 0 ambient 0 } }
#end
Plate(<0.5, 0, 0>, <0, 0, 1>)
Plate(<-0.5, 0, 0>, <1, 0, 0>)
#for (I, 1, Behind)
  sphere { <0, 0, -20 - I>, 0.1 }
#end
POV

# overlap SPHERES [OPTION…]: the colour of the pixel in the middle, where the two discs lie over each other.
overlap() {
  root/usr/bin/povray +Iscene.pov +Oout.ppm +FP +W16 +H12 -A -D -GA +WT1 "Declare=Behind=$1" "${@:2}" >log 2>&1 ||
    { cat log >&2; exit 1; }
  tail -c $((3 * 16 * 12)) out.ppm | od -An -v -tu1 -w3 | sed -n "$((6 * 16 + 9))p" |
    sed -e 's/^ *0 *0 *255$/blue/' -e 's/^ *255 *0 *0$/red/'
}

status=0
# look EXPECTED SPHERES [OPTION…]
look() {
  local seen
  seen=$(overlap "${@:2}")
  echo "$2 spheres behind the camera, ${3:-default bounding}: $seen"
  [[ $seen == "$1" ]] || { echo "CHANGED: was $1"; status=1; }
}
for spheres in 0 1 3; do look blue "$spheres" -MB; done
look red 0
look blue 1
look red 3
exit "$status"
