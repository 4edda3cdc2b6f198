# Our own pictures, and how others are compared with them. Sourced after tests/cli/lib.sh.

size=160         # pixels of the longer side of a cell
width= height=   # of a cell, known after our_sheet
timing=()        # options of the morph: --times, --smooth
readonly alike=0.004 # mean difference, a share of white, of pictures that show the same: rasterisers disagree on edges

skip() {
  echo "SKIPPED: $1" >&2
  exit 77
}

need_imagemagick() {
  local tool
  for tool in montage compare identify mogrify; do
    command -v "$tool" >/dev/null || skip "no ImageMagick ($tool)"
  done
}

# styled_shapes: drawings as icon sets have them: an outline, another one with other contours, two colours of which one is
# see-through, and one that is filled and stroked.
styled_shapes() {
  local outline='fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round"'
  svg_of() { echo "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 24 24\" $2>$3</svg>" >"$1"; }
  svg_of ring.svg "$outline" '<circle cx="12" cy="12" r="9"/><path d="M12 7V12L15 14"/>'
  svg_of zigzag.svg "$outline" '<path d="M3 12L8 4L16 20L21 12"/>'
  svg_of red.svg '' '<path fill="#dd2e44" d="M4 4H20V20H4Z"/>'
  svg_of blue.svg 'fill="none"' '<g style="fill: rgb(59 136 195 / 60%)"><path d="M12 3L22 20H2Z"/></g>'
  svg_of both.svg '' '<path fill="gold" stroke="#226699" stroke-width="1.5" d="M5 6H19L12 21Z"/>'
}

# eased X1,Y1,X2,Y2[;...] TIME TIMES: s at that time of 2 seconds, when keys stand at TIMES (0,0.5,1) and every step has
# its own easing, or all have one.
eased() {
  awk -v easings="$1" -v time="$2" -v times="$3" '
    function bezier(p, q, t) { return 3 * p * t * (1 - t) ^ 2 + 3 * q * t * t * (1 - t) + t ^ 3 }
    BEGIN {
      keys = split(times, at, ","); x = time / 2
      for (key = 1; key < keys - 1 && x >= at[key + 1];) ++key
      each = split(easings, easing, ";")
      if (split(easing[each == 1 ? 1 : key], c, ",") != 4) split("0,0,1,1", c, ",")
      length_ = at[key + 1] - at[key]
      lo = 0; hi = 1
      for (i = 0; i < 60; ++i) { middle = (lo + hi) / 2; if (bezier(c[1], c[3], middle) < (x - at[key]) / length_) lo = middle; else hi = middle }
      printf "%.9f", at[key] + bezier(c[2], c[4], lo) * length_
    }'
}

# our_sheet NAME S... -- SHAPE...: NAME.ours.png has our pictures of the in-betweens side by side.
our_sheet() {
  local name=$1 positions=()
  shift
  while [[ $1 != -- ]]; do positions+=("$1") && shift; done
  shift
  local at
  at=$(IFS=, && echo "${positions[*]}")
  expect 0 morph "$@" ${timing[@]+"${timing[@]}"} -o "$name.frames/" --to png --at "$at" --size "$size" --quiet
  read -r width height < <(identify -format '%w %h\n' "$name.frames/frame_000.png")
  montage "$name.frames/"*.png -background white -geometry +0+0 -tile "${#positions[@]}x1" -alpha remove "$name.ours.png"
}

difference() { compare -metric MAE "$1" "$2" null: 2>&1 | sed -n 's/.*(\([0-9.e-]*\)).*/\1/p'; }
less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && a < b) }'; }

same_picture() { # THEIRS OURS
  local found
  found=$(difference "$1" "$2")
  echo "$1: mean difference $found"
  that "$1 looks like $2: mean difference '$found'" less "$found" "$alike"
}

# The comparison can fail: turned round, the sheet is another one.
other_picture() {
  local found
  mogrify -flop "$1"
  found=$(difference "$1" "$2")
  that "pictures of other shapes differ: '$found'" less "$alike" "$found"
}

# same_numbers TEXT TEXT: the same numbers but for rounding.
same_numbers() {
  paste <(grep -oE -- '-?[0-9.]+(e-?[0-9]+)?' <<<"$1") <(grep -oE -- '-?[0-9.]+(e-?[0-9]+)?' <<<"$2") |
    awk '{ n++; if (NF != 2 || ($1 - $2) ^ 2 > 1e-4) bad++ } END { exit !(n > 6 && !bad) }'
}

other_numbers() { ! same_numbers "$@"; }
