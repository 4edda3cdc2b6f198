# Our OBJ, STL, PLY and glTF files as Assimp reads them.
source "$(dirname "${BASH_SOURCE[0]}")/../cli/lib.sh"

command -v assimp >/dev/null || {
  echo "SKIPPED: no assimp" >&2
  exit 77
}

cat >patch.json <<'S'
{"type": "bspline_surface", "degree": [2, 1], "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 2, 2]],
 "points": [[[0, 0, 0], [0, 3, 0]], [[1, 0, 2], [1, 3, 2]], [[2, 0, 0], [2, 3, 0]]]}
S
expect 0 convert patch.json -o patch.obj
faces=$(grep -c ^f patch.obj)
that "a surface of several faces" test "$faces" -gt 4
for ending in obj stl ply glb; do
  expect 0 convert patch.json -o "patch.$ending"
  read_back=$(assimp info "patch.$ending" 2>&1)
  found=$(sed -n 's/^Faces: *//p' <<<"$read_back")
  that "$ending: $found faces, wanted $faces" test "$found" == "$faces"
  # The height of the parabola is 1; glTF has y up.
  highest=$(sed -n 's/^Maximum point *(\(.*\))/\1/p' <<<"$read_back")
  case $ending in
    glb) wanted='2.000000 1.000000 -0.000000|2.000000 1.000000 0.000000' ;;
    *) wanted='2.000000 3.000000 1.000000' ;;
  esac
  that "$ending: highest point ($highest)" grep -qxE "$wanted" <<<"$highest"
done
finish
