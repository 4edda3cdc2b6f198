# STEP, IGES and BREP, by way of the CAD component; without it the program says so.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

letters=$(dirname "${BASH_SOURCE[0]}")/../../examples/data/letters_ef.json

if [[ ! -e $(dirname "$TANDEM")/libtandem_cad.so ]]; then
  expect 3 rule "$letters#0" "$letters#1" -o a.step
  err_has 'CAD component'
  finish
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
echo nonsense >bad.step
expect 3 info bad.step
err_has 'bad\.step'
expect 3 skin "$square" "$triangle" --solid --spacing 1 -o solid.step
that "nothing was written" test ! -e x.step

finish
