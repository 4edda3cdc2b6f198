# Android vector drawables: Android's own compiler takes them, and what they draw at both ends is what we draw.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../cli/lib.sh"
source "$here/pictures.sh"

command -v aapt2 >/dev/null || skip "no aapt2"
command -v rsvg-convert >/dev/null || skip "no rsvg-convert"
need_imagemagick
mkdir -p res/drawable

# at FILE: path data, places and turns of the last key frame in the place of the first.
at_end() {
  awk '
    function value(line, name) { return match(line, "android:" name "=\"[^\"]*\"") ? substr(line, RSTART + length(name) + 10, RLENGTH - length(name) - 11) : "" }
    NR == FNR { if (/<target/) target = value($0, "name"); if (/<objectAnimator/) last[target, value($0, "propertyName")] = value($0, "valueTo"); next }
    /<(path|group) / {
      name = value($0, "name")
      for (key in last) {
        split(key, part, SUBSEP)
        if (part[1] == name) sub("android:" part[2] "=\"[^\"]*\"", "android:" part[2] "=\"" last[key] "\"")
      }
    }
    { print }' "$1" "$1"
}

# to_svg: the <vector> inside as SVG; a group is moved after it is turned, as Android does it.
to_svg() {
  sed -n '/<vector/,/<\/vector>/p' | sed -E \
    -e 's|<vector .*viewportWidth="([^"]*)" android:viewportHeight="([^"]*)">|<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 \1 \2">|; s|</vector>|</svg>|' \
    -e 's|<group .*translateX="([^"]*)" android:translateY="([^"]*)" android:rotation="([^"]*)">|<g transform="translate(\1 \2) rotate(\3)">|; s|</group>|</g>|' \
    -e '/fillColor/!s|<path |<path fill="none" |' \
    -e 's|android:fillColor|fill|; s|android:fillType="evenOdd"|fill-rule="evenodd"|; s|android:strokeColor|stroke|; s|android:strokeWidth|stroke-width|' \
    -e 's|android:fillAlpha|fill-opacity|; s|android:strokeAlpha|stroke-opacity|; s|android:strokeLineCap|stroke-linecap|' \
    -e 's|android:strokeLineJoin|stroke-linejoin|; s|android:strokeMiterLimit|stroke-miterlimit|; s|android:pathData|d|; s|android:name="[^"]*"||'
}

# Every <aapt:attr> becomes a resource of its own; one inside another has a dollar sign more.
resources_in() { grep -ao 'drawable/[$]\+[a-z]*__[0-9_]*' "$1" | sort -u | wc -l; }

check() { # NAME SHAPE...
  local name=$1 file=res/drawable/$1.xml end
  shift
  expect 0 morph "$@" -o "$file" --to avd --easing ease --quiet
  that "aapt2 takes $name" aapt2 compile "$file" -o .
  that "all parts of $name" test "$(resources_in "drawable_$name.xml.flat")" == "$(grep -c '<aapt:attr' "$file")"
  our_sheet "$name" 0 1 -- "$@"
  to_svg <"$file" >"$name.0.svg"
  at_end "$file" | to_svg >"$name.1.svg"
  for end in 0 1; do
    rsvg-convert -w "$width" -h "$height" "$name.$end.svg" -o "$name.$end.png" || fail "$name.$end.svg is no picture"
  done
  montage "$name".[01].png -background white -geometry +0+0 -tile 2x1 -alpha remove "$name.png"
  same_picture "$name.png" "$name.ours.png"
}

check icon "$DATA/icons/heart.svg" "$DATA/icons/star.svg"
check quarter 'M0 0H9V2H3V5H0Z' 'M0 0V9H-2V3H-5V0Z'
check several 'M0 0H9V9H0Z' 'M0 0H5V9H0Z' 'M2 0H7V7H0Z'
check lines 'M0 0H9V9H0ZM1 12L8 12' 'M0 0H5V9H0ZM1 12C3 16 5 9 8 12'
check holes 'M0 0H9V9H0ZM3 3H6V6H3Z' 'M0 0H9V9H0ZM2 2H7V7H2Z' --fill-rule evenodd
styled_shapes
check outline ring.svg zigzag.svg
check colors red.svg blue.svg
check becoming ring.svg both.svg
other_picture icon.png quarter.ours.png
sed 's|</group>||' res/drawable/quarter.xml >res/drawable/broken.xml
that "aapt2 can refuse" bash -c '! aapt2 compile res/drawable/broken.xml -o . 2>/dev/null'
finish
