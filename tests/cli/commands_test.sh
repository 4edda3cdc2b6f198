# What the commands print and write when all is well.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

has_report() { # the report's fields of docs/interface.md
  local field
  for field in tandem method norm samples sampling cost mean_cost invalid_nodes invalid_length valid min_dot \
    valid_share direction shift rotation path correspondence reparametrization max_deviation curve seconds; do
    out_has "\"$field\": ?[^ ]"
  done
}

quick=(--samples 24) # what is tested here does not depend on their number

# match
expect 0 match "${quick[@]}" "$square" "$triangle"
out_has 'cost .*valid .*direction +forward'
expect 0 match "${quick[@]}" "$square" "$square" --json
has_report
out_has '"valid": ?true'
out_has '"cost": ?(0|[0-9.]+e-[0-9]+),'
json=$out
expect 0 match "${quick[@]}" "$square" "$square" -o -
that "-o - and --json agree but for the times" test "${out%%\"seconds\"*}" == "${json%%\"seconds\"*}"
expect 0 match "${quick[@]}" "$square" "$square" -o - --json
that "-o - and --json print one report" test "$(grep -o '"max_deviation"' <<<"$out" | wc -l)" == 1
expect 0 match "${quick[@]}" "$square" "$triangle" -o m.json
out_empty
that "m.json" grep -q '"correspondence"' m.json
expect 0 match "${quick[@]}" "$square" "$triangle" -o m.svg --json
has_report
that "m.svg" grep -q '<svg' m.svg
expect 0 match "${quick[@]}" "$square" "$triangle" -o - --to svg
out_has '<svg .*</svg>'

for options in '--method paper' '--norm ruled' '--norm distance' '--norm bottleneck' \
  '--sampling curvature' '--sampling parameter' '--features tangent+curvature' '--reduce 20' '--tolerance 1e-2 --order 3' \
  '--direction reversed' '--closed no' '--closed pinned' '--closed yes' '--low-pass 0.02' '--fast' \
  '--rotate' '--no-rotate' '--rotate --method paper' '--rotate --norm distance' '--threads 1' '--method paper --reduce 12 --order 3'; do
  # shellcheck disable=SC2086  # words are wanted
  expect 0 match "${quick[@]}" "$square" "$triangle" --json --quiet $options
  out_has '"cost"'
  err_empty
done
# Pins: the square's corner at (4,4) is at u = 2, the triangle's lower left one at v = 2.
expect 0 match "$square" "$triangle" --pin '4,4=0,4' --pin '0,0=4.1,4.1' --json --quiet
out_has '\[0, 1\].*\[2, -1\]' # once round, v falls by 3
expect 0 match "$square" "$triangle" --pin '4,4=0,4' --method paper --direction forward --json --quiet
out_has '\[2, 2\]'
expect 3 match "$square" "$triangle" --pin '4,4=0,4' --pin '4,4=4,4'
err_has 'cross'
expect 0 match "$square" "$triangle" --method segments --json --quiet
out_has '"norm": ?"derivative"'
expect 0 match "$square" "$triangle" --method segments --split uniform --segment-cost paper --json --quiet
out_has '"norm": ?"paper"'
expect 0 match "$square" "$triangle" --method segments --pin '2,0=1,2' --direction forward --json --quiet
out_has '\[0\.5, 2\.5\]' # the middle of an edge of each

expect 0 match "$square" "$triangle" --samples 40,50 --json --quiet
out_has '"samples": ?\[(39|40|41), ?(49|50|51)\]' # corners decide the rest
expect 0 match "$square" "$triangle" --method paper --json --quiet
out_has '"method": ?"paper"'
out_has '"samples": ?\[100, ?100\]'
out_has '"sampling": ?"parameter"'
expect 0 match "${quick[@]}" "$square" "$triangle" --direction reversed --json --quiet
out_has '"direction": ?"reversed"'

# Several contours: pairs in order, totals, those without a partner.
two='M0 0H8V8H0ZM2 2V6H6V2Z'
three='M0 0H8V8H0ZM1 1V3H3V1ZM5 5V7H7V5Z'
expect 0 match "${quick[@]}" "$two" "$three" --json
err_has 'contour 2 of B has no partner'
out_has '"contours": \[\{"a": 0, "b": 0, "tandem"'
out_has '"a": 1, "b": 1'
out_has '"unmatched": \{"a": \[\], "b": \[2\]\}'
out_has '"seconds": \{"sample": [0-9.e-]+, "match": [0-9.e-]+, "fit": [0-9.e-]+, "compose": [0-9.e-]+\}\}$'
expect 0 match "${quick[@]}" "$two" "$three"
out_has '2  no partner'
expect 0 match "${quick[@]}" "$two" "$three" -o sheet.svg --quiet
err_empty
that "a sheet of two pictures" test "$(grep -c '<svg y=' sheet.svg)" == 2

# morph
expect 0 morph "${quick[@]}" "$square" "$triangle" --at 0,0.5,1 -o -
out_has '^\{"frames": \['
out_has '"s": 0.5, "d": "M[^"]*Z"\}'
out_has '"report": \{'
err_empty
has_report
expect 0 morph "${quick[@]}" "$square" "$triangle" --at -0.2,0.5 -o -
out_has '"s": -0.2'
expect 0 morph "${quick[@]}" "$square" "$triangle" --at=-1e-1 -o -
out_has '"s": -0.1'
# open contours beside closed ones
expect 0 morph "${quick[@]}" 'M0 0H9V9H0ZM2 2V5H5V2' 'M1 0H9V9H1ZM2 2V6H5V2' --at 0.5 -o -
err_has 'open, and drawn as strokes: contour 1 of A, contour 1 of B; --closed yes closes them'
expect 0 morph "${quick[@]}" 'M0 0H9V9H0ZM2 2V5H5V2' 'M1 0H9V9H1ZM2 2V6H5V2' --at 0.5 -o - --closed yes
err_empty
out_has '"d": "M[^M]*ZM[^M]*Z"'
expect 0 align "${quick[@]}" 'M0 0H9V9H0' 'M1 0H9V9H1' --closed yes -o -
out_has '"a": "M[^"]*Z",'
expect 0 morph "${quick[@]}" 'M0 0H9V9H0Z' 'M1 0H9V9H1' --at 0.5 -o -
err_has 'contour 0 of A is closed, contour 0 of B open: the closed one is cut where that is best'
# one against several
play='M6 4L20 12L6 20Z' pause='M5 4H10V20H5ZM14 4H19V20H14Z'
expect 0 morph "$play" "$pause" --at 0,1 -o -
out_has '"contours": \[\{"a": 0, "b": [01],'
out_has '"unmatched": \{"a": \[\], "b": \[\]\}'
expect 0 morph "$play" "$pause" --at 0,1 -o - --no-cut
out_has '"unmatched": \{"a": \[\], "b": \[[01]\]\}'
expect 0 morph "${quick[@]}" 'M0 0 L4 0 L4 4' 'm 1,2 l 4,0 l 0,4' --at 0.5 -o -
out_has '"d": "M0.5 1'
expect 0 morph "${quick[@]}" "$square" "$triangle" -o f.json --frames 5
that "five frames" test "$(grep -o '"s": [0-9.]*' f.json | tr '\n' ' ')" == '"s": 0 "s": 0.25 "s": 0.5 "s": 0.75 "s": 1 '
expect 0 morph "${quick[@]}" "$square" "$triangle" -o a.svg --json --duration 1.5 --easing ease-in-out
out_has '^\{"report": \{'
that "an animation" grep -q '<animate' a.svg
expect 0 morph "${quick[@]}" "$square" "$triangle" -o c.svg --easing 'cubic-bezier(0.3, 0, 0.7, 1)'
# When keys are reached, and how.
expect 0 morph --blend affine "$square" "$triangle" "$square" -o t.svg --times 0,0.4,1 --easing ease --easing linear --play once
that "times" grep -q 'keyTimes="0;0.4;1" calcMode="spline" keySplines="0.25 0.1 0.25 1;0 0 1 1"' t.svg
cp t.svg u.svg
for times in 0%,40%,100% 0s,0.8s,2s; do
  expect 0 morph --blend affine "$square" "$triangle" "$square" -o t.svg --times "$times" --easing 'ease; linear' --play once
  that "the same times" cmp t.svg u.svg
done
expect 0 morph --blend affine "$square" "$triangle" "$square" -o t.svg --times 0s,1s,5s --play once
that "a duration" grep -q 'dur="5s"' t.svg
expect 0 morph "${quick[@]}" "$square" "$triangle" -o t.svg --duration 500ms --play once
that "a duration in milliseconds" grep -q 'dur="0.5s"' t.svg
expect 2 morph "$square" "$triangle" -o t.svg --duration 2m
expect 0 morph --blend affine "$square" "$triangle" "$square" -o - --times 0,0.4,1 --at 0.4
out_has '"s": 0.4, "d": "M[^"]*L4 4L[^"]*0 4L[^"]*L2 0L'
expect 0 morph "${quick[@]}" "$square" 'M0 0H9V4H0Z' 'M0 0H9V9H0Z' -o smooth.svg --smooth --blend affine
that "more frames than keys" bash -c '[[ $(grep -o "keyTimes=\"[^\"]*" smooth.svg | head -1 | tr -cd ";" | wc -c) -gt 8 ]]'
rm t.svg u.svg smooth.svg
expect 0 morph "${quick[@]}" "$square" "$triangle" -o still.svg --at 0.5
that "a still picture" bash -c '! grep -q "<animate" still.svg && grep -q "<svg" still.svg'
expect 0 morph "${quick[@]}" "$square" "$triangle" -o p.html
that "a page without network" bash -c 'grep -q "<html" p.html && ! grep -qE "(src|href)=\"?https?:" p.html'
expect 0 morph "${quick[@]}" "$square" "$triangle" "$square" -o - --at 0.5
out_has '"reports": \[\{'
that "two reports" test "$(grep -o '"max_deviation"' <<<"$out" | wc -l)" == 2
expect 0 morph "${quick[@]}" "$square" "$triangle" -o ANIM.SVG
that "endings in capitals" grep -q '<animate' ANIM.SVG

# Methods have blends of their own.
for pair in 'paper affine' 'segments hermite'; do
  read -r method blend <<<"$pair"
  expect 0 morph "$square" "$triangle" --method "$method" --json -o m.svg
  out_has "\"blends\": ?\\[\"$blend\"\\]"
done
expect 0 morph "$square" "$triangle" --method segments --blend bezier --json -o m.svg
out_has '"blends": ?\["bezier"\]'
expect 0 align "$square" "$triangle" --method segments --no-rotate -o -
out_has '"a": "M[^CL]*(L[^CL]*){3,4}Z"' # four segments

# The other formats: by their ending, or by --to.
for file in m.css m.lottie.json m.avd.xml m.gif; do
  expect 0 morph "${quick[@]}" "$square" "$triangle" -o "$file" --duration 0.5
done
that "a style sheet" grep -q '@keyframes morph {' m.css
that "a Lottie file" grep -q '"op":60,' m.lottie.json
that "a vector drawable" grep -q '<animated-vector' m.avd.xml
that "a GIF" test "$(head -c 6 m.gif)" == GIF89a
expect 0 morph "${quick[@]}" "$square" "$triangle" -o - --to lottie --duration 0.5
that "--to lottie writes the same" cmp .out m.lottie.json
expect 0 morph "${quick[@]}" "$square" "$triangle" -o - --to avd --play once
that "once" test "$(grep -c repeatCount .out)" == 0
expect 0 morph "${quick[@]}" "$square" "$triangle" -o - --to css --css clip-path --name logo --size 100 --precision 1
out_has '.logo [{] width: 100px; height: 100px;.*clip-path: path[(]"M'
that "one decimal" bash -c '! grep -qE "path.*[0-9][.][0-9]{2}" .out'
expect 0 morph "${quick[@]}" "$square" "$triangle" -o m.png --at 0.5 --size 64
that "a PNG" test "$(head -c 4 m.png | tail -c 3)" == PNG
expect 0 morph "${quick[@]}" "$square" "$triangle" -o - --at 0.123456789 --precision 3
that "three decimals" bash -c '! grep -qE "\"d\".*[.][0-9]{4}" .out'
expect 0 morph "${quick[@]}" "$square" "$triangle" -o f.JSON --at 0.5 --to json
that "--to overrides the ending" grep -q '"frames"' f.JSON
rm m.css m.lottie.json m.avd.xml m.gif m.png f.JSON

# Curves of R^3 come as curves.
cat >space.json <<'J'
{"curves": [{"type": "bspline", "degree": 3, "points": [[0,0,0],[1,2,1],[3,2,0],[4,0,1]]},
            {"type": "bspline", "degree": 2, "points": [[0,1,0],[2,4,1],[4,1,2]]}]}
J
expect 0 morph 'space.json#0' 'space.json#1' --at 0.5 -o -
out_has '"curves": \[\{"type": ?"bspline"'
# By segments they are cubics, joined smoothly.
expect 0 morph 'space.json#0' 'space.json#1' --method segments --at 0,0.5 -o -
out_has '"curves": \[\{"type": ?"bspline", ?"degree": ?3'
expect 3 morph 'space.json#0' 'space.json#1' --method segments --blend intrinsic --at 0.5 -o -
err_has 'affine, bezier and hermite only'
for file in space.svg space.css space.gif space.lottie.json space.avd.xml; do
  expect 3 morph 'space.json#0' 'space.json#1' -o "$file"
  err_has 'dimension 3'
done

# Frames in a directory: whole or not at all.
expect 0 morph "${quick[@]}" "$square" "$triangle" -o frames/ --frames 4
that "four frames" test "$(ls frames | tr '\n' ' ')" == 'frame_000.svg frame_001.svg frame_002.svg frame_003.svg '
expect 0 morph "${quick[@]}" "$square" "$triangle" -o frames --frames 2
that "fewer frames replace them" test "$(ls frames | tr '\n' ' ')" == 'frame_000.svg frame_001.svg '
expect 0 morph "${quick[@]}" "$square" "$triangle" -o frames/ --to png --frames 2 --size 32
that "PNG frames replace them" test "$(ls frames | tr '\n' ' ')" == 'frame_000.png frame_001.png '
expect 0 morph "${quick[@]}" "$square" "$triangle" -o frames --to svg --frames 2
that "and are replaced" test "$(ls frames | tr '\n' ' ')" == 'frame_000.svg frame_001.svg '
touch frames/mine.txt
expect 1 morph "$square" "$triangle" -o frames --frames 3
err_has 'frames: holds other files than frames \(mine.txt\)'
that "a directory with other files is left alone" test "$(ls frames | tr '\n' ' ')" == 'frame_000.svg frame_001.svg mine.txt '
mkdir empty
expect 0 morph "${quick[@]}" "$square" "$triangle" -o empty --at 0.5
that "an empty directory is used" test "$(ls empty)" == frame_000.svg
that "frames are as readable as other files" test "$(stat -c %a empty)" == "$(mkdir .mode && stat -c %a .mode && rmdir .mode)"
expect 1 morph "$square" "$triangle" -o m.json/
rm -r frames empty

# align
expect 0 align "${quick[@]}" "$square" "$triangle" -o -
out_has '^[{]"a": "M[^"]*Z",
 "b": "M[^"]*Z",
 "fill_rule": "nonzero",
 "report": [{]'
has_report
letters() { sed -n "s/^[{ ]\"$1\": \"\(.*\)\",\$/\1/p" .out | tr -dc 'MCLZ'; }
that "the same commands" test "$(letters a)" == "$(letters b)"
that "commands at all" test -n "$(letters a)"
expect 0 align "${quick[@]}" "$square" "$triangle" "$square" -o three.json --precision 2
that "three letters and a list" bash -c 'grep -q "\"c\": \"M" three.json && grep -q "\"paths\": \[\"M" three.json && grep -q "\"reports\": \[" three.json'
that "two decimals" bash -c '! grep -qE "\"a\".*[.][0-9]{3}" three.json'
expect 0 align "${quick[@]}" "$square" "$triangle" -o aligned.svg --json
out_has '^[{]"report"'
expect 0 info aligned.svg#b
out_has '1 contour'
expect 0 align "${quick[@]}" "$square" "$triangle" -o - --to svg
out_has '<path id="a" .*<path id="b"'
expect 3 align 'space.json#0' 'space.json#1' -o space.svg
err_has 'dimension 3'
expect 4 align "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --direction forward --strict -o strict.json
rm three.json aligned.svg

# info
expect 0 info "$two"
out_has '2 contours, dimension 2, fill rule nonzero, box \(0, 0\) to \(8, 8\), length 48'
expect 0 info "$two" --fill-rule evenodd --json
out_has '"fill_rule": "evenodd", "length": 48'
out_has '"closed": true'
expect 0 info 'space.json#1' --json
out_has '"kind": "bezier", "degree": 2, "dimension": 3, "control_points": 3, "domain": \[0, 1\], "closed": false'

# convert: back and forth without a loss.
expect 0 convert space.json -o space.itd
expect 0 convert space.itd -o back.json
expect 0 convert space.json -o -
that "JSON -> ITD -> JSON is the identity" test "$out" == "$(cat back.json)"
expect 0 convert "$two" -o two.svg
that "an SVG" grep -q '<svg' two.svg
expect 0 convert "$two" -o - --to svg
out_has '<svg'
expect 3 convert space.json -o space.svg

# Standard input: JSON, SVG, path data.
for text in "$(cat back.json)" "$(cat two.svg)" "$two"; do
  checks=$((checks + 1))
  run info - <<<"$text"
  [[ $status == 0 && $out == *"2 contours"* ]] || fail "standard input"
done
run match - "$triangle" <<<"$square"
out_has 'cost'
run match "$square" - --json <<<"$triangle"
out_has '"cost"'

# Parts of files.
cat >parts.svg <<'S'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><rect id="box" width="4" height="2"/><circle cx="5" cy="5" r="2"/></svg>
S
expect 0 info 'parts.svg#box'
out_has 'length 12'
expect 0 info 'parts.svg#1'
out_has 'length 12\.566'
expect 0 info parts.svg
out_has '2 contours'
printf 't,x,y\n0,0,0\n1,1,2\n2,3,1\n3,4,4\n' >motion.csv
expect 0 info motion.csv --json
out_has '"dimension": 2.*"domain": \[0, 3\]'

# The warning, --quiet and --strict. Opposite straight lines: there is no valid match, unless one is turned.
expect 0 match "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --direction forward --json
err_has 'warning: the match is not valid'
out_has '"valid": ?false'
expect 0 match "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --direction forward --json --quiet
err_empty
expect 4 match "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --direction forward --no-rotate --strict -o strict.json
out_empty
err_has 'no valid match'
expect 4 morph "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --direction forward --no-rotate --strict -o strict.svg
expect 4 morph "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --direction forward --no-rotate --strict -o strict.svg --quiet
err_empty
expect 0 match "${quick[@]}" 'M0 0L1 0' 'M1 1L0 1' --strict --json
out_has '"direction": ?"reversed"'

only ANIM.SVG a.svg back.json c.svg f.json m.json m.svg motion.csv p.html parts.svg sheet.svg space.itd space.json \
  still.svg two.svg
# Places and folders that cannot be; and names of contours beyond the second key.
expect 2 morph "$square" "$triangle" -o far.svg --at 1e308
err_has 'at takes'
expect 2 morph "$square" "$triangle" -o folder/ --to html
err_has 'folder/ is a directory'
expect 0 morph "$square" "$triangle" "M0 0H4V4H0ZM9 9h1v1h-1z" -o keys.json
err_has 'contour 1 of C has no partner'
dots=$(for i in {10..40}; do printf 'M%d 9h.5v.5h-.5z' "$i"; done)
expect 0 morph "$square" "$square$dots" -o keys.json --no-cut
err_has '0, 1, 2, 3, 4 and 26 more of B have no partner'
rm keys.json

# An option that has no say is mentioned, and nothing is where all have one.
expect 0 morph "$square" "$triangle" -o idle.svg --at 0.5 --play once
err_has 'note: --play changes nothing'
expect 0 morph "$square" "$triangle" -o idle.svg --frames 9 --size 64 --name walk
err_has '--frames changes nothing.*--size changes nothing.*--name changes nothing'
expect 0 morph "$square" "$triangle" -o idle.svg --play once --duration 1 --easing ease --precision 2
err_empty
expect 0 morph "$square" "$triangle" -o idle.gif --play once --frames 9 --duration 1 --size 64
err_empty
rm idle.svg idle.gif

# Perpendicular at one end alone: valid on all of the length but a point, which is not all.
expect 0 match 'M0 0L10 0' 'M0 0C5.5 0 10 4.5 10 10'
out_has 'valid +no .*over 99\.99 % of the length'
err_has 'valid on over 99\.99 % of the length'
finish
