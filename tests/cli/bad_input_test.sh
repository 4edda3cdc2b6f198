# Every malformed file and degenerate curve: exit status 3 and a message with the place, or, where there is one, the
# sensible answer. Nothing crashes, hangs, or writes.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

good='{"type": "bspline", "degree": 1, "points": [[0,0],[1,2],[3,1]]}'

# bad PATTERN FILE TEXT: the file with this text is refused by info, match and morph, with the place.
bad() {
  local pattern=$1 file=$2 text=$3
  printf '%s' "$text" >"$file"
  expect 3 info "$file"
  out_empty
  err_has "$file"
  err_has "$pattern"
  expect 3 match "$file" "$square" -o out.json
  expect 3 morph "$square" "$file" -o out.svg
  rm "$file"
}

# bad_curve PATTERN JSON: the second curve of a file is invalid; the message tells which.
bad_curve() { bad "$1" curves.json "[$good, $2]" && err_has '1|second'; }

# sensible ARG...: the program has an answer, and it holds finite numbers only.
sensible() {
  expect 0 "$@" --quiet
  checks=$((checks + 1))
  [[ ! ${out,,} =~ (nan|inf|null) ]] || fail "NaN, infinity or null in the answer: tandem $*"
}

# --- malformed files
bad 'empty' a.svg ''
bad ':2:' a.svg $'<svg xmlns="http://www.w3.org/2000/svg">\n<path d="M0 0L1 1"'
bad 'path|number|command' a.svg '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L1"/></svg>'
bad 'drawable' a.svg '<svg xmlns="http://www.w3.org/2000/svg"/>'
bad '.' a.svg '<svg xmlns="http://www.w3.org/2000/svg"><rect width="wide" height="2"/></svg>'
bad '.' a.svg '<svg xmlns="http://www.w3.org/2000/svg"><path transform="rotate(" d="M0 0L1 1"/></svg>'
bad '.' a.svg $'\x00\x01\x02\xff'
bad 'empty' a.json ''
bad ':2:' a.json $'{"type":\n"bspline",'
bad '.' a.json '{"curves": []}'
bad '.' a.json '"text"'
bad '.' a.json '[1, 2]'
bad ':1:' a.json '{"type": "bspline", "degree": 1, "points": [[0,0],[NaN,1]]}'
bad '.' a.json "$(printf '[%.0s' {1..20000})"
bad 'circle' a.json '{"type": "circle", "points": [[0,0],[1,1]]}'
bad '.' a.itd ''
bad '.' a.itd '[CURVE BEZIER 3 E2 [0 0] [1 1]'
bad '.' a.itd '[CURVE BEZIER 2 E2 [0 0] [x 1]]'
bad '.' a.itd '[CURVE BSPLINE 3 3 E2 [KV 0 0 1 1] [0 0] [1 1] [2 0]]'
bad '.' a.csv ''
bad '2' a.csv $'t,x,y\n0,0,zero\n1,1,1\n'
bad '3' a.csv $'t,x,y\n0,0,0\n1,1\n'
bad '3' a.csv $'t,x,y\n1,0,0\n0,1,1\n'
bad '.' a.csv $'t,x,y\n0,nan,0\n1,1,1\n'
bad '.' a.csv $'t,x,y\n0,0,0\n'
printf 'no font' >a.ttf
expect 3 info 'a.ttf#A'
err_has 'a\.ttf'
rm a.ttf

# --- path data on the command line
for path in 'M0 0L' 'M0 0Q1 1' 'M0 0L1e999 0' 'M0 0LNaN 1' 'M0 0L1 1X' 'M0 0A1 1 0 2 0 3 3' 'M0,,0L1 1' 'm1 2l3'; do
  expect 3 info "$path"
  err_has ':1:[0-9]+:'
done
expect 3 info 'neither file nor path'
err_has 'neither file nor path'
expect 3 info ''
expect 3 info 'M0 0' # a point is no drawing
run info - <<<''
checks=$((checks + 1)) && [[ $status == 3 ]] || fail "empty standard input"

# --- parts that do not exist
printf '<svg xmlns="http://www.w3.org/2000/svg"><rect id="r" width="1" height="1"/></svg>' >one.svg
printf '%s' "$good" >one.json
for part in 'one.svg#q' 'one.svg#1' 'one.svg#-1' 'one.json#1' 'one.json#x' 'one.json#99999999999999999999'; do
  expect 3 info "$part"
  err_has 'one\.(svg|json)'
done

# --- invalid curves
bad_curve 'knot' '{"type": "bspline", "degree": 3, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,2],[3,2],[4,0]]}'
bad_curve 'knot' '{"type": "bspline", "degree": 1, "knots": [0,0,0.5,0.4,1,1], "points": [[0,0],[1,2],[3,2],[4,0]]}'
bad_curve 'knot' '{"type": "bspline", "degree": 1, "knots": [0,0,0.5,0.5,0.5,1,1], "points": [[0,0],[1,2],[3,2],[4,0],[1,1]]}'
bad_curve 'knot|domain' '{"type": "bspline", "degree": 1, "knots": [1,1,1,1], "points": [[0,0],[1,2]]}'
bad_curve 'knot|number' '{"type": "bspline", "degree": 1, "knots": [0,0,1e999,1], "points": [[0,0],[1,2]]}'
bad_curve 'weight' '{"type": "bspline", "degree": 1, "points": [[0,0],[1,2]], "weights": [1,0]}'
bad_curve 'weight' '{"type": "bspline", "degree": 1, "points": [[0,0],[1,2]], "weights": [1,-1]}'
bad_curve 'weight' '{"type": "bspline", "degree": 1, "points": [[0,0],[1,2]], "weights": [1]}'
bad_curve 'degree' '{"type": "bspline", "degree": 0, "points": [[0,0],[1,2]]}'
bad_curve 'degree' '{"type": "bspline", "degree": -3, "points": [[0,0],[1,2]]}'
bad_curve 'degree' '{"type": "bspline", "degree": 1.5, "points": [[0,0],[1,2]]}'
bad_curve 'degree|point' '{"type": "bspline", "degree": 3, "points": [[0,0],[1,2]]}'
bad_curve 'degree|point' '{"type": "bspline", "degree": 2000000000, "points": [[0,0],[1,2]]}'
bad_curve 'dimension|coordinate|length' '{"type": "bspline", "degree": 1, "points": [[0,0],[1,2,3]]}'
bad_curve 'dimension|coordinate|empty' '{"type": "bspline", "degree": 1, "points": [[],[]]}'
bad_curve 'point' '{"type": "bspline", "degree": 1, "points": []}'
bad_curve 'point' '{"type": "bspline", "degree": 1}'
bad_curve 'number' '{"type": "bspline", "degree": 1, "points": [[0,"a"],[1,2]]}'
bad_curve 'point' '{"type": "bezier_path", "points": [[0,0],[1,1],[2,2]]}'
bad_curve 'clos' '{"type": "bezier_path", "points": [[0,0],[1,1],[2,2],[3,0]], "closed": true}'

# --- a point: it can be described and morphed to, not matched
printf '{"type": "bspline", "degree": 2, "points": [[1,1],[1,1],[1,1]]}' >point.json
sensible info point.json --json
expect 3 match point.json "$square" --json
err_has 'point'
out_empty
sensible morph "$square" point.json --at 0,0.5,1 -o - # it shrinks to the point

# --- combinations
printf '{"type": "bspline", "degree": 1, "points": [[0,0,0],[1,2,3]]}' >space.json
expect 3 match space.json "$square"
err_has 'dimension'
expect 3 morph space.json "$square" -o out.svg
err_has 'dimension'
expect 3 match 'M0 0L1 1' "$square" --closed yes
err_has 'closed|open'
expect 3 match "$square" "$triangle" --samples 2,2000
expect 3 morph space.json space.json -o out.html
err_has 'planar|dimension'

# --- what looks bad and has a sensible answer
sensible match 'M0 0L1 1L2 0' "$square" --json                                   # open and closed
sensible match 'M0 0C0 0 1 1 1 1' 'M0 0C0 0 0 0 1 0' --json                      # handles of no length
sensible match 'M0 0L0 0L1 0L1 0L1 1' 'M0 0L2 0L2 0L2 2' --json                  # repeated points
sensible match 'M0 0L1 0L0 0Z' "$square" --json                                  # back and forth, no area
sensible match 'M0 0L1e300 0L1e300 1e300L0 1e300Z' "$square" --json              # huge
sensible match 'M0 0L1e-300 0L1e-300 1e-300L0 1e-300Z' "$square" --json          # tiny
sensible match 'M1e15 1e15h4v4h-4Z' "$square" --json                             # far away
sensible match 'M0 0L1e300 0L1e300 1e300L0 1e300Z' 'M0 0L1e-300 0L1e-300 1e-300Z' --json
sensible match "$square" "$square" --samples 3 --json
sensible match "$square" "$square" --method paper --samples 3 --json
sensible morph 'M0 0L1e300 0L1e300 1e300L0 1e300Z' "$square" --at 0,0.5,1 -o -
sensible morph 'M0 0L1 0L0 0Z' "$square" --at 0,0.5,1 -o -
sensible morph "$square" 'M0 0L4 0L4 4' --at 0,0.5,1 -o -                         # closed and open
sensible info 'M0 0L1e300 1e300' --json
cat >far.json <<'J'
[{"type": "bspline", "degree": 1, "knots": [1e9,1e9,1000000001,1000000002,1000000002], "points": [[0,0],[1,2],[3,2]]},
 {"type": "bspline", "degree": 1, "knots": [-1e9,-1e9,-999999999,-999999999], "points": [[0,0],[1,2]]}]
J
sensible match far.json#0 far.json#1 --json                                      # knots far from 0
printf '{"type": "bspline", "degree": 2, "points": [[0,0],[1,1],[3,0]], "weights": [1e-300,1,1e300]}' >weights.json
run match weights.json 'M0 0L3 0' --json
checks=$((checks + 1)) && [[ $status == 0 || $status == 3 ]] || fail "extreme weights"

only far.json one.json one.svg point.json space.json weights.json
finish
