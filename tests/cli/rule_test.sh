# rule and blend: what they write, what they report, what they refuse.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

u=("$examples/u_planar.json#0" "$examples/u_planar.json#1")
letters=("$examples/letters_ef.json#0" "$examples/letters_ef.json#1")

# rule, in the plane
expect 0 rule "${u[@]}" -o u.json --json
err_empty
for field in planar tangents wrong_sign_share crease_angle warp_angle mean_warp_angle inclination mean_inclination \
  twisted_share law outcome refined correspondence reparametrization valid min_dot; do
  out_has "\"$field\": ?[^ ]"
done
out_has '"norm": ?"ruled"'
out_has '"planar": ?true'
out_has '"valid": ?true'
out_has '"wrong_sign_share": ?0,'
that "u.json is a surface" grep -q '"bspline_surface"' u.json
that "u.json has the report" grep -q '"report": *{' u.json
expect 0 rule "${u[@]}" -o u.json --json --certify
out_has '"certificate": ?"certified"'
out_has '"one_to_one": ?"certified"'
expect 0 rule 'M0 0 C 20 30 40 30 60 0' 'M0 60 C 20 90 40 90 60 60' -o - --planar
out_has '"bspline_surface"'

# in space
expect 0 rule "${letters[@]}" -o letters.obj --quiet --json
out_has '"norm": ?"anti-twist"'
out_has '"planar": ?false'
that "letters.obj" grep -q '^f ' letters.obj
expect 0 rule "${letters[@]}" -o letters.json --norm developable --inclination 1.2 --samples 48 --quiet --json
out_has '"norm": ?"developable"'
expect 0 rule "${letters[@]}" -o letters.json --norm tangent --order 3 --tolerance 0.01 --samples 48 --quiet --json
out_has '"norm": ?"tangent"'
out_has '"order": ?3'

# curves that cross have no ruled surface without folds
crossing=('M0 0 C 20 30 40 30 60 0' 'M0 20 C 20 -10 40 0 60 30')
expect 0 rule "${crossing[@]}" -o crossing.json
err_has 'folds over itself: the wrong sign on [0-9.]+ % of its area'
expect 0 rule "${crossing[@]}" -o crossing.json --certify --json --quiet
out_has '"certificate": ?"violated"'
out_has '"witness": ?\{"kind"'
rm -f crossing.json
expect 4 rule "${crossing[@]}" -o crossing.json --strict
that "nothing is written" test ! -e crossing.json

# a law that its slopes and spans keep off its match
expect 0 rule "${letters[@]}" -o x.json --tolerance 1e-12
err_has 'the law is [0-9.e-]+ of its domain away from the match, 1e-12 was asked for'
rm x.json

# blend
up='{"degree": 1, "points": [[0,2,4],[0,2,4]]}'
down='{"degree": 1, "points": [[0,2,-4],[0,2,-4]]}'
echo "{\"curves\": [{\"degree\": 2, \"points\": [[0,0,0],[3,0,1],[6,0,0]]}, $up, {\"degree\": 2, \"points\": [[0,5,0],[2,5,1],[6,5,0]]}, $down]}" >rails.json
rails=('rails.json#0' 'rails.json#1' 'rails.json#2' 'rails.json#3')
expect 0 blend "${rails[@]}" -o blend.json --json
out_has '"crease_angle"'
out_has '"valid": ?true'
that "blend.json is cubic across" grep -Eq '"degree": *\[[0-9]+, *3\]' blend.json
expect 0 blend "${rails[@]}" -o blend.stl
that "blend.stl" test -s blend.stl

# one contour of several
ring='M0 0H8V8H0ZM2 2H4V4H2Z'
outer='M-2 -2H10V10H-2Z'
expect 3 rule "$ring" "$outer" -o x.json
err_has 'has 2 contours; rule takes one curve each, and --contour N picks one: 0 \(length 32\), 1 \(length 8\)'
expect 3 rule "$ring" "$outer" -o x.json --contour 2
err_has 'and no 2;'
expect 0 rule "$ring" "$outer" -o outer.json --contour 0 --quiet
expect 0 rule "$ring" "$outer" -o hole.json --contour 1,0 --quiet
expect 0 rule "${ring/ZM*/Z}" "$outer" -o alone.json --quiet
control_points() { grep -o '"points": *\[.*' "$1"; }
that "the outer contour is the one without the hole" test "$(control_points outer.json)" == "$(control_points alone.json)"
that "the hole is another" test "$(control_points hole.json)" != "$(control_points alone.json)"
expect 2 rule "$ring" "$outer" -o x.json --contour 0,1,0
expect 2 rule "$ring" "$outer" -o x.json --contour -1

# the order that fits
# curves DEGREE FILE: two Bezier curves.
curves() {
  awk -v p="$1" 'BEGIN {
    for (k = 0; k < 2; ++k) {
      printf "%s{\"degree\": %d, \"points\": [", k ? ", " : "{\"curves\": [", p
      for (i = 0; i <= p; ++i) printf "%s[%.6f,%.6f,%.6f]", i ? "," : "", i / p, sin(3 * i / p + 0.3 * k) + k, k * (1 + i / p)
      printf "]}"
    }
    print "]}"
  }' >"$2"
}
curves 40 forty.json
expect 0 rule forty.json#0 forty.json#1 -o x40.json
err_has 'order 3 instead of 4: the surface is of degree 80 along u, 100 is the highest'
that "it is of that degree" grep -Eq '"degree": *\[80, *1\]' x40.json
expect 3 rule forty.json#0 forty.json#1 -o x.json --order 4
err_has 'of degree 120 along u, with a law of order 4: 100 is the highest; leave --order out'
expect 0 skin forty.json -o x40.json --order 2
curves 120 many.json
for command in "rule many.json#0 many.json#1" "skin many.json"; do
  start=$SECONDS
  # shellcheck disable=SC2086  # words are wanted
  expect 3 $command -o x.json
  err_has 'degree 120 along u.*100 is the highest.*approximate'
  that "at once" test $((SECONDS - start)) -le 5
done

# a tessellation of too many triangles is refused early
start=$SECONDS
expect 3 rule "${letters[@]}" -o x.stl --chord 1e-9 --quiet
expect 3 rule "${letters[@]}" -o x.stl --chord 1e-9
err_has 'vertices, expected a larger one'
that "in seconds" test $((SECONDS - start)) -le 60

# what cannot be written is known before anything is read
expect 1 rule missing.json missing.json -o nowhere/x.json
err_has 'cannot write nowhere/x.json'
mkdir here.json
expect 1 rule "${u[@]}" -o here.json
err_has 'cannot write here.json'
rmdir here.json

mkdir folder
expect 2 rule "${u[@]}" -o folder
err_has 'folder is a directory, expected a file'
rmdir folder

# too far away for what is asked
for at in 1e9 1e15; do
  awk -v at=$at 'BEGIN {
    for (k = 0; k < 2; ++k)
      printf "%s{\"degree\": 2, \"points\": [[%.17g,0,%d],[%.17g,2,%d],[%.17g,0,%d]]}", k ? ", " : "[", at, k, at + 2, k, at + 4, k
    print "]"
  }' >"far$at.json"
done
expect 3 rule far1e9.json#0 far1e9.json#1 -o x.stl
err_has 'numbers of 32 bits.* at coordinates of 1e\+09'
expect 0 rule far1e9.json#0 far1e9.json#1 -o far.ply
expect 3 rule far1e15.json#0 far1e15.json#1 -o x.ply
err_has 'at coordinates of 1e\+15 doubles know a surface of size [0-9.]+ to 0\.0[0-9] of its size: expected a larger chord'

# what is refused
expect 3 rule "${letters[0]}" "${letters[0]}" -o x.json
err_has 'coincide'
expect 3 rule "${letters[@]}" -o x.json --planar
err_has 'do not lie in one plane'
expect 3 rule "${letters[0]}" 'rails.json#0' -o x.json
err_has 'the first curve is closed, the second open'
expect 3 rule "${letters[0]}" "$square" -o x.json
err_has 'different dimensions'
expect 3 rule 'M0 0H10' 'M20 0H30' -o x.json
err_has 'on one line'
# The same outline, though it begins elsewhere.
expect 3 rule 'M0 0H4V4H0Z' 'M4 4H0V0H4Z' -o x.json
err_has 'coincide'
expect 3 blend "${rails[0]}" "${rails[1]}" "${rails[0]}" "${rails[1]}" -o x.json
err_has 'coincide'
expect 2 rule "${u[@]}"
err_has 'needs -o'
expect 2 rule "${u[0]}" -o x.json
err_has 'takes 2 curves'
expect 2 blend "${u[@]}" -o x.json
err_has 'takes 4 curves'
expect 2 rule "${u[@]}" -o x.json --reduce 20
err_has 'not --reduce'
expect 2 rule "${u[@]}" -o x.json --rotate
err_has 'where they lie'
expect 2 rule "${u[@]}" -o x.json --inclination 0.5
err_has 'goes with --norm developable'
expect 2 rule "${u[@]}" -o x.json --norm angle
err_has 'takes one of'
that "nothing is written" test ! -e x.json

# --contour counts where there is one contour, too.
expect 0 rule "$square" "$triangle" -o one.json --contour 0 --quiet
expect 2 rule "$square" "$triangle" -o one.json --contour foo
expect 3 rule "$square" "$triangle" -o one.json --contour 3
err_has 'has 1 contour, and no 3'
expect 2 rule "$square" "$triangle" -o one.json --contour 5,6,7

finish
