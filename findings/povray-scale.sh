#!/usr/bin/env bash
# POV-Ray: the same scene in another unit of length is another picture, and at 10^-5 an empty one.
#
# One would guess: a scene with camera, lamp and objects all multiplied by one number gives the same picture, to rounding.
# What happens: hits and shadows nearer than fixed distances in scene units are dropped. From 1 down to 10^-3 nothing is to be
#   seen; at 10^-4 the shadows are gone and half of the glass is black, but all is there; at 10^-5 box and ball have vanished.
#   No warning. A comparison with POV-Ray needs a scene of some units' size; millimetres written as metres are off.
# Seen in: 3.7.0.10.
# ropelight instead: rays leave a surface by the rounding error of the hit, and scenes are moved near the origin.
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
global_settings { assumed_gamma 1 max_trace_level 20 }
camera { location <0, 2, -4>*Scale look_at 0 angle 40 right x }
light_source { <3, 6, 4>*Scale rgb 1 }
plane { y, -Scale pigment { rgb 0.8 } finish { ambient 0.1 diffuse 0.9 } }
box { <-1.5, -0.9, -0.6>*Scale, <-0.5, 0.1, 0.4>*Scale pigment { rgb <1, 0.3, 0.3> } finish { ambient 0.1 diffuse 0.9 } }
sphere { <0.7, -0.2, 0>*Scale, 0.7*Scale pigment { rgbt 1 } finish { diffuse 0 ambient 0 reflection 0.2 } interior { ior 1.5 } }
POV

# picture SCALE: one pixel a line.
picture() {
  root/usr/bin/povray +Iscene.pov +Oout.ppm +FP +W160 +H120 -A -D -GA +WT1 "Declare=Scale=$1" >log 2>&1 ||
    { cat log >&2; exit 1; }
  tail -c $((3 * 160 * 120)) out.ppm | od -An -v -tu1 -w3
}

status=0
picture 1 >one
shadow=$(awk '$1 == $2 && $2 == $3 && $1 < 100 { ++n } END { print n + 0 }' one)
echo "scale 1: $shadow pixels are dark grey"
((shadow > 300)) || { echo "CHANGED: there was a shadow"; status=1; }
for scale in 0.1 0.001 0.0001 0.00001; do
  picture "$scale" >other
  changed=$(paste one other | awk '{ for (c = 1; c <= 3; ++c) if (($c - $(c + 3)) ^ 2 > 4) { ++n; break } } END { print n + 0 }')
  red=$(awk '$1 > $2 + 50 { ++n } END { print n + 0 }' other)
  echo "scale $scale: $changed of 19200 pixels differ from scale 1; $red show the red box"
  case $scale in
    0.1 | 0.001) ((changed <= 20)) || { echo "CHANGED: was the same picture"; status=1; } ;;
    0.0001) ((changed > 1000 && red > 500)) || { echo "CHANGED: was another picture of the box"; status=1; } ;;
    0.00001) ((changed > 10000 && red == 0)) || { echo "CHANGED: was empty"; status=1; } ;;
  esac
done
exit "$status"
