# Surfaces as files: info and convert.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

cat >patch.json <<'S'
{"type": "bspline_surface", "degree": [2, 1], "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 2, 2]],
 "points": [[[0, 0, 0], [0, 3, 0]], [[1, 0, 2], [1, 3, 1]], [[2, 0, 0], [2, 3, 0]]], "report": {"valid": true}}
S
cat >flat.json <<'S'
{"type": "bspline_surface", "degree": [1, 1], "points": [[[0, 0], [0, 3]], [[2, 0], [2, 3]]]}
S

expect 0 info patch.json
out_has 'surface, dimension 3, polynomial, control points from \(0, 0, 0\) to \(2, 3, 2\)'
expect 0 info patch.json --json
out_has '"kind": "surface", "degree": \[2, 1\], "dimension": 3, "control_points": \[3, 2\], "domain": \[\[0, 1\], \[0, 2\]\], "closed": \[false, false\], "rational": false'

# JSON: all numbers, and nothing else.
expect 0 convert patch.json -o back.json
expect 0 convert back.json -o -
that "JSON -> JSON is the identity" test "$out" == "$(cat back.json)"
that "the report is not the surface's" test "$(grep -c report back.json)" == 0
checks=$((checks + 1))
run convert - -o - <patch.json
[[ $status == 0 && $out == "$(cat back.json)" ]] || fail "standard input"

# One file of each kind, told by how it starts; denser where it is asked for.
starts() { test "$(head -c "${#2}" "$1")" == "$2"; }
for kind in 'obj=# Tandem' 'stl=Tandem, binary STL' 'ply=ply' 'glb=glTF' 'svg=<svg' 'html=<!DOCTYPE html>'; do
  expect 0 convert patch.json -o "out.${kind%%=*}"
  that "${kind%%=*} starts as it should" starts "out.${kind%%=*}" "${kind#*=}"
done
expect 0 convert patch.json -o out.png --size 64
that "a PNG" test "$(head -c 4 out.png | od -An -tx1 | tr -d ' ')" == 89504e47
expect 0 convert patch.json -o OUT --to stl --chord 1e-5
that "a smaller chord distance makes more triangles" test "$(stat -c %s OUT)" -gt "$(stat -c %s out.stl)"
expect 0 convert patch.json -o angle.stl --angle 0.02
that "a smaller angle makes more triangles" test "$(stat -c %s angle.stl)" -gt "$(stat -c %s out.stl)"
expect 0 convert flat.json -o flat.obj
that "a flat square takes two triangles" test "$(grep -c ^f flat.obj)" == 2
expect 0 convert flat.json -o flat.svg --quiet

# What cannot be.
expect 2 convert patch.json -o out.css
err_has ending
expect 2 convert patch.json -o out.itd
err_has ending
expect 2 convert 'M0 0H4V4H0Z' -o out2.stl
err_has ending
for option in '--chord 0' '--chord nan' '--angle -1' '--angle 3' '--size 0' '--size 9000'; do
  # shellcheck disable=SC2086  # the option and its value
  expect 2 convert patch.json -o never.stl $option
  err_has "${option%% *}"
done
sed 's/2, 3, 0/2, 3/' patch.json >broken.json
expect 3 convert broken.json -o never.stl
err_has 'broken\.json:2:[0-9]+: surface: point \(2, 1\) has 2 coordinates, point \(0, 0\) has 3'
sed 's/\[2, 1\]/[2, 7]/' patch.json >degree.json
expect 3 info degree.json
err_has 'degree\.json'
expect 3 match patch.json 'M0 0H4'
err_has 'is a surface, expected curves'
expect 1 convert patch.json -o missing/out.stl
expect 1 convert missing.json -o out3.stl
that "nothing is left of what failed" test ! -e never.stl -a ! -e out3.stl
cat >huge.json <<'S'
{"type": "bspline_surface", "degree": [1, 1], "points": [[[0, 0, 0], [0, 3e200, 0]], [[2e200, 0, 0], [2e200, 3e200, 0]]]}
S
expect 3 convert huge.json -o huge.stl
err_has '32 bits'
expect 0 convert huge.json -o huge.ply
that "no huge.stl" test ! -e huge.stl
cat >line.json <<'S'
{"type": "bspline_surface", "degree": [1, 1], "points": [[[0, 0, 0], [0, 0, 0]], [[1, 0, 0], [1, 0, 0]]]}
S
for ending in stl glb svg html; do
  expect 3 convert line.json -o "line.$ending"
  err_has 'no area'
done
finish
