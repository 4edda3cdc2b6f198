# An output file appears whole or not at all, whatever goes wrong.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# Not read.
expect 1 info missing.svg
err_has 'missing\.svg'
expect 1 match missing.json "$triangle" -o out.json
expect 1 info missing.ttf#A
mkdir directory
expect 1 info directory/
expect 1 info directory/missing.svg
rmdir directory

# Not written.
expect 1 match "$square" "$triangle" -o missing/out.json --quiet
err_empty
expect 1 match "$square" "$triangle" -o missing/out.json
err_has 'missing/out\.json'
expect 1 morph "$square" "$triangle" -o missing/frames/
expect 1 convert "$square" -o missing/out.itd
# Before the work: these would take many seconds.
wave="M0 0$(printf 'q5 9 10 0t10 0%.0s' {1..40})V-30H0Z"
for command in match morph align; do
  expect 1 "$command" 'M10 0A10 10 0 1 1 -10 0A10 10 0 1 1 10 0Z' "$wave" --samples 3000 -o missing/out.svg
  err_has 'cannot write missing/out\.svg'
done
expect 1 morph 'M10 0A10 10 0 1 1 -10 0A10 10 0 1 1 10 0Z' "$wave" --samples 3000 -o missing/frames/
that "soon" test "$SECONDS" -le 60
mkdir taken.json
expect 1 convert "$square" -o taken.json
that "a directory is not replaced by a file" test -d taken.json
rmdir taken.json
expect 1 match "$square" "$triangle" -o "$(printf 'n%.0s' {1..300}).json"

# A full device, and a closed pipe, are noticed.
if [[ -w /dev/full ]]; then
  "$TANDEM" info "$square" >/dev/full 2>.err
  status=$?
  checks=$((checks + 1))
  [[ $status == 1 ]] || fail "standard output on a full device"
  expect 1 match "$square" "$triangle" -o /dev/full --to json
  that "/dev/full is still a device" test -c /dev/full
fi
expect 0 match "$square" "$triangle" -o /dev/null --to json
that "/dev/null is still a device" test -c /dev/null
expect 0 convert "$square" -o /dev/stdout --to svg
out_has '<svg'

# The old file stays when the new one cannot be written: too large for the limit.
expect 0 morph "$square" "$triangle" -o out.html
cp out.html before.html
(ulimit -f 1 && trap '' XFSZ && exec "$TANDEM" morph "$square" "$triangle" -o out.html) >.out 2>.err </dev/null
status=$?
checks=$((checks + 1))
[[ $status == 1 ]] || fail "a write that fails half-way"
that "the old file stays" cmp out.html before.html
(ulimit -f 1 && trap '' XFSZ && exec "$TANDEM" morph "$square" "$triangle" -o new.html) >.out 2>.err </dev/null
that "no half file" test ! -e new.html
# shellcheck disable=SC2016
(ulimit -f 1 && trap '' XFSZ && exec "$TANDEM" morph 'M0 0L1 0' "M0 1$(printf 'l1 1l1 -1%.0s' {1..60})" -o frames/ --quiet) >.out 2>.err </dev/null
that "no half directory" test ! -e frames

# An existing file is replaced through a link, which stays a link.
expect 0 convert "$square" -o target.json
ln -s target.json link.json
expect 0 convert "$triangle" -o link.json
that "a link stays" test -L link.json
that "its file changed" bash -c "cmp -s link.json target.json && '$TANDEM' info target.json | grep -q 'closed'"
expect 0 convert "$square" -o 'name with blanks & ünïcode.json'
expect 0 info './name with blanks & ünïcode.json'

# Read-only directories (root may write everywhere).
if ((EUID != 0)); then
  mkdir locked
  chmod a-w locked
  expect 1 convert "$square" -o locked/out.json
  chmod u+w locked
  rmdir locked
fi

only before.html out.html target.json link.json 'name with blanks & ünïcode.json'
finish
