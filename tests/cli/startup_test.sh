# `tandem --version` takes at most 10 ms: the best of 20 runs, since other work on the machine only adds to it.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

best=1000000
for _ in {1..20}; do
  start=${EPOCHREALTIME//[.,]/}
  "$TANDEM" --version >.out || fail "tandem --version"
  took=$((${EPOCHREALTIME//[.,]/} - start))
  ((took < best)) && best=$took
done
echo "tandem --version: $best microseconds"
# A sanitizer's own start takes longer than that.
[[ -n ${SANITIZE-} ]] || that "start-up within 10 ms" test "$best" -le 10000
that "it ran" grep -q '^tandem' .out
finish
