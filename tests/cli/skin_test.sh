# tandem skin: surfaces through curves, and solids through contours.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

bells=$examples/bells.json

# One line {"points": ...} of a square of the given size at height z.
square_at() {
  local h=$1 z=$2 s=${3:-}
  printf '{"type": "bspline", "degree": 1, "points": [[-%s,-%s,%s],[%s,-%s,%s],[%s,%s,%s],[-%s,%s,%s],[-%s,-%s,%s]]}\n' \
    "$h" "$h" "$z" "$h" "$h" "$z" "$h" "$h" "$z" "$h" "$h" "$z" "$h" "$h" "$z" >"square$s.json"
}

# The surface goes through all sections of a file, and says how well.
expect 0 skin "$bells" -o bells.json --json
err_empty
out_has '"valid": true'
out_has '"crease_angle": '
that "the surface is one" grep -q '"type": "bspline_surface"' bells.json
that "it holds its report" grep -q '"report": {' bells.json
expect 0 skin "$bells" -o bells.json --json --certify --chord 0.01
out_has '"certificate": "certified"'
out_has '"tessellation_simple": "certified"'
expect 2 skin "$bells" -o bells.stl --solid --certify
expect 0 skin "$bells#0" "$bells#1" "$bells#2" -o - --degree 2 --parameters centripetal
out_has '"degree": \[6, *2\]'
for ending in obj stl ply glb svg png html; do
  expect 0 skin "$bells#0" "$bells#1" -o "out.$ending" --chord 0.01 --angle 0.5
  that "out.$ending is written" test -s "out.$ending"
done

# Pins, rows, a ring, planar inputs stacked.
expect 0 skin "$bells" -o - --rows 4
expect 0 skin "$bells#0" "$bells#1" -o - --pin '2.5,0,0=6.5,2.5,0'
expect 0 skin "$square" 'M0 0H5V4H0Z' 'M0 0H6V5H0Z' -o ring.json --spacing 2 --ring
expect 0 skin "$square" "$triangle" -o planar.json --spacing -1
for spacing in 1e300 1e-300 -1e12; do
  expect 3 skin "$square" "$triangle" -o x.json --spacing $spacing
  err_has "spacing $spacing does not go with inputs of size [0-9.]+: expected [0-9.]+e-09 to [0-9.]+e\+09"
done
expect 0 skin "$examples/crow.svg" "$examples/kangaroo.svg" -o - --spacing 100
err_has 'the law of section 1 is 0\.[0-9]+ of its domain away from the match, 0\.002 was asked for'
out_has '"section_crease_angle": 0\.0'
expect 2 skin "$bells" -o - --pin '1,2,3=4,5,6'
err_has '2 points for 5 sections'
expect 2 skin "$bells" -o - --pin '1,2=1,2=1,2=1,2=1,2'
err_has "'1,2' has 2 coordinates, expected 3"

# Levels of contours to a solid.
ring_of_two='M0 0H4V4H0ZM1 1H2V2H1Z'
square_at 1 0 a
square_at 1 3 b
expect 0 skin --solid squarea.json squareb.json -o box.stl --json
out_has '"volume": 1(2|2\.00000|1\.99999)[0-9]*,'
out_has '"caps": 2'
that "a binary STL of whole triangles" test $((($(stat -c %s box.stl) - 84) % 50)) = 0
expect 0 skin --solid "$square" 'M0 0H1V4H0ZM3 0H4V4H3Z' -o legs.obj --spacing 2 --json
out_has '"branches": 1'
expect 3 skin --solid squarea.json squareb.json -o box.json
err_has 'json'

expect 0 skin --solid squarea.json squareb.json -o box.stl --json
err_empty
out_has '"tessellation_simple": "certified"'
comb='M0 0H4V1H1V2H4V3H1V4H4V5H0Z'
mirrored='M0 0H-4V1H-1V2H-4V3H-1V4H-4V5H0Z'
expect 0 skin --solid "$comb" "$mirrored" -o comb.stl --spacing 1 --json
out_has '"tessellation_simple": "violated"'
err_has 'it crosses or touches itself'
expect 3 skin --solid "$square" "$triangle" -o x.stl
err_has '--spacing X stacks the inputs'
expect 3 skin --solid "$ring_of_two" -o x.stl
err_has 'each input is one level'
expect 3 skin --solid "$square" 'M0 0H4V4' -o x.stl --spacing 1
err_has 'has an open curve'

# Equal tangents do not keep a ring in the plane from folding.
expect 0 skin "$square" 'M10 0H14V4H10Z' -o fold.json --json
err_has 'folds over itself: the wrong sign on [0-9.]+ %'
out_has '"wrong_sign_share": 0\.'
expect 0 skin "$square" 'M-2 -2H6V6H-2Z' -o ring.json --json
err_empty
out_has '"wrong_sign_share": 0,'

# Its own defaults are in its help.
for command in skin loft-repair; do
  expect 0 $command --help
  out_has '3 is C1 \(default\)'
  out_has '0\.002'
done
expect 1 skin missing.json -o nowhere/x.json
err_has 'cannot write nowhere/x.json'

# What is no chain of sections.
expect 3 skin "$bells#0" -o x.json
err_has '1 section, expected at least 2'
expect 3 skin "$bells#0" "$bells#0" -o x.json
err_has 'sections 0 and 1 coincide'
expect 3 skin "$bells#0" squarea.json -o x.json
err_has 'section 1 is closed, section 0 is open'
expect 3 skin "$bells#0" "$square" -o x.json
err_has 'section 1 has dimension 2, section 0 has 3'
expect 3 skin "$bells" -o x.json --spacing 1
err_has 'planar'
expect 3 skin "$bells" -o x.json --rows 9
err_has '9 rows for 5 sections'
expect 2 skin "$bells" -o x.json --degree 26
expect 2 skin "$bells" -o x.json --reduce 9
expect 2 skin "$bells" -o x.json --matching never
expect 2 skin "$bells" -o x.json --solid --ring
expect 2 skin -o x.json
expect 2 skin "$bells"
expect 2 skin "$bells" -o x.gif
that "nothing was written" test ! -e x.json

finish
