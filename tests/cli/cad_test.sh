# STEP, IGES and BREP, by way of the CAD component; without it the program says so.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

letters=$examples/letters_ef.json

if [[ ! -e $(dirname "$TANDEM")/libtandem_cad.so ]]; then
  expect 3 rule "$letters#0" "$letters#1" -o a.step
  err_has 'CAD component'
  finish
  exit 0
fi

# There and back, in all formats.
for ending in step iges brep; do
  expect 0 convert "$letters" -o "letters.$ending"
  expect 0 info "letters.$ending" --json
  out_has '"closed": true'
  expect 0 convert "letters.$ending#1" -o "f.json"
  expect 0 rule "letters.$ending#0" "letters.$ending#1" -o "ruled.$ending"
  that "the file is not empty" test -s "ruled.$ending"
done
expect 0 convert "$letters" -o other --to step
that "STEP begins with its name" grep -q '^ISO-10303-21;' other

# Degrees that end at 25: the order of the law gives way, if it was not asked for.
for degree in 9 13 26; do
  awk -v p=$degree 'BEGIN {
    for (k = 0; k < 2; ++k) {
      printf "%s{\"degree\": %d, \"points\": [", k ? ", " : "{\"curves\": [", p
      for (i = 0; i <= p; ++i) printf "%s[%.6f,%.6f,%.6f]", i ? "," : "", i / p, sin(3 * i / p + 0.3 * k) + k, k * (1 + i / p)
      printf "]}"
    }
    print "]}"
  }' >"degree$degree.json"
done
expect 0 rule degree9.json#0 degree9.json#1 -o nine.step
err_has 'order 3 instead of 4: the surface is of degree 18 along u, 25 is the highest of STEP'
expect 3 rule degree9.json#0 degree9.json#1 -o x.step --order 4
err_has 'leave --order out'
expect 0 rule degree13.json#0 degree13.json#1 -o thirteen.igs
err_has 'order 2 instead of 4'
expect 0 skin degree13.json -o thirteen.brep
err_has 'order 2 instead of 3'
expect 3 rule degree26.json#0 degree26.json#1 -o x.brep
err_has '25 is the highest'
expect 0 convert degree13.json -o thirteen.step
expect 0 loft-repair thirteen.step -o repaired13.step
err_has 'order 2 instead of 3'

# Sections in step.
expect 0 loft-repair letters.step -o repaired.step --json
out_has '"total_cost"'
expect 0 info repaired.step
expect 0 loft-repair letters.brep -o repaired.igs --quiet
out_empty
expect 2 loft-repair letters.step
expect 2 loft-repair letters.step letters.brep -o x.step
expect 2 loft-repair letters.step -o x.json
expect 1 loft-repair missing.step -o x.step
expect 3 loft-repair "$letters" -o x.step
expect 0 convert "$letters#0" -o one.step
expect 3 loft-repair one.step -o x.step
err_has 'at least 2'
echo '[{"degree": 1, "points": [[0,0,0],[1e-9,0,0]]}, {"degree": 1, "points": [[0,1e-9,0],[1e-9,1e-9,1e-9]]}]' >tiny.json
expect 3 convert tiny.json -o x.step
err_has 'a curve of size 1e-09 is too small'
expect 3 rule tiny.json#0 tiny.json#1 -o x.step
err_has 'a surface of size 1\.73e-09 is too small'
mkdir folder
expect 2 loft-repair letters.step -o folder
err_has 'folder is a directory'
echo nonsense >bad.step
expect 3 info bad.step
err_has 'bad\.step'
expect 3 skin "$square" "$triangle" --solid --spacing 1 -o solid.step
that "nothing was written" test ! -e x.step

finish
