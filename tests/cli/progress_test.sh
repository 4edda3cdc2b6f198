# The progress bar: on a terminal, after half a second, and never in a file or with --quiet.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

if ! command -v script >/dev/null; then
  echo "skipped: there is no script(1) to make a terminal"
  exit 0
fi
circle='M10 0A10 10 0 1 1 -10 0A10 10 0 1 1 10 0Z'
wave="M0 0$(printf 'q5 9 10 0t10 0%.0s' {1..40})V-30H0Z"

# on_terminal ARG...: what a terminal shows of standard error.
on_terminal() {
  printf '%q ' "$TANDEM" "$@" >.command
  script -qec "bash .command" /dev/null </dev/null >.out 2>&1
  status=$?
  out=$(<.out)
}

on_terminal match "$circle" "$wave" --samples 1200 -o out.json
that "it ends well" test "$status" == 0
out_has '\[#* *\] +[0-9]+ %'
out_has $'\r\e\\[K' # the bar is taken away
on_terminal match "$circle" "$wave" --samples 1200 -o out.json --quiet
out_empty
on_terminal match "$square" "$square" --method paper -o out.json
out_empty
expect 0 match "$circle" "$wave" --samples 1200 -o out.json --quiet
err_empty
rm -f .command

only out.json
finish
