# What the tests of the program share. A test sources this, calls the functions below and ends with `finish`.
# In: TANDEM (the program), DATA (tests/data), SANITIZE (not empty under a sanitizer).
set -uo pipefail

examples=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../examples/data" && pwd)
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
checks=0
out= err= status=

square='M0 0H4V4H0Z'
triangle='M2 0L4 4H0Z'

fail() {
  failures=$((failures + 1))
  ((failures <= 10)) || return 0
  printf 'FAILED: %.400s\n  status %s\n  stdout: %.400s\n  stderr: %.400s\n' "$1" "$status" "$out" "$err" >&2
}

# run ARG...: the program with these arguments; standard input is empty unless redirected.
run() {
  "$TANDEM" "$@" >"$work/.out" 2>"$work/.err"
  status=$?
  out=$(tr -d '\0' <"$work/.out")
  err=$(tr -d '\0' <"$work/.err")
}

# expect STATUS ARG...
expect() {
  local wanted=$1
  shift
  run "$@" </dev/null
  checks=$((checks + 1))
  [[ $status == "$wanted" ]] || fail "exit status $wanted wanted: tandem $*"
}

# The last run: text on standard output or error matches the pattern (bash regex).
out_has() { checks=$((checks + 1)) && [[ $out =~ $1 ]] || fail "standard output lacks $1"; }
err_has() { checks=$((checks + 1)) && [[ $err =~ $1 ]] || fail "standard error lacks $1"; }
out_empty() { checks=$((checks + 1)) && [[ -z $out ]] || fail "standard output is not empty"; }
err_empty() { checks=$((checks + 1)) && [[ -z $err ]] || fail "standard error is not empty"; }

# that DESCRIPTION COMMAND...: the command succeeds.
that() {
  local what=$1
  shift
  checks=$((checks + 1))
  "$@" || fail "$what"
}

# only NAME...: the work directory holds these entries and nothing else (nothing half-written, nothing temporary).
only() {
  checks=$((checks + 1))
  local found wanted
  found=$(find . -mindepth 1 -maxdepth 1 ! -name .out ! -name .err -printf '%f\n' | sort | tr '\n' ' ')
  wanted=$((($# == 0)) || printf '%s\n' "$@" | sort | tr '\n' ' ')
  [[ $found == "$wanted" ]] || fail "files wanted: $wanted; found: $found"
}

# polygons COUNT: closed polygons as JSON lines, no two alike, the same ones every time.
polygons() {
  awk -v count="$1" '
    function random() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
    BEGIN {
      seed = 20240731
      for (k = 1; k <= count; ++k) {
        corners = 5 + int(8 * random())
        first = ""; points = ""
        for (i = 0; i < corners; ++i) {
          angle = 6.283185307 * (i + 0.6 * random() - 0.3) / corners
          radius = 0.4 + 1.6 * random()
          point = sprintf("[%.9f,%.9f]", radius * cos(angle), radius * sin(angle))
          if (i == 0) first = point
          points = points point ","
        }
        printf "{\"type\": \"bspline\", \"degree\": 1, \"points\": [%s%s], \"name\": \"polygon %d\"}\n", points, first, k
      }
    }'
}

finish() {
  echo "$checks checks, $failures failures"
  ((checks > 0 && failures == 0)) || exit 1
}
