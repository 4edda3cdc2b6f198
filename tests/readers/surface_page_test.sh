# What Chromium shows of the page of a surface, and of its SVG, against our own PNG.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../cli/lib.sh"
source "$here/pictures.sh"

chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || skip "no Chromium"
need_imagemagick

root=()
((EUID != 0)) || root=(--no-sandbox)
browse() { # SIZE ARG...: WebGL by software
  "$chromium" --headless "${root[@]}" --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
    --force-color-profile=srgb --force-device-scale-factor=1 --user-data-dir="$work/.chromium" --window-size="$1" \
    "${@:2}" 2>/dev/null
}

# A tube, seen from above: its outside and its inside.
s=0.7071067811865476
cat >tube.json <<S
{"type": "bspline_surface", "degree": [2, 1], "knots": [[0,0,0,1,1,2,2,3,3,4,4,4], [0,0,1,1]],
 "points": [[[1,0,0],[1,0,1]], [[1,1,0],[1,1,1]], [[0,1,0],[0,1,1]], [[-1,1,0],[-1,1,1]], [[-1,0,0],[-1,0,1]],
   [[-1,-1,0],[-1,-1,1]], [[0,-1,0],[0,-1,1]], [[1,-1,0],[1,-1,1]], [[1,0,0],[1,0,1]]],
 "weights": [[1,1],[$s,$s],[1,1],[$s,$s],[1,1],[$s,$s],[1,1],[$s,$s],[1,1]]}
S
expect 0 convert tube.json -o tube.png --size 300
expect 0 convert tube.json -o tube.svg --size 300
expect 0 convert tube.json -o tube.html

read -r width height < <(identify -format '%w %h\n' tube.png)
mogrify -background white -alpha remove tube.png
echo "<!DOCTYPE html><style>body{margin:0}svg{display:block}</style>$(cat tube.svg)" >still.html
browse "$width,$((height + 200))" --screenshot=tube.svg.png "file://$work/still.html" >/dev/null
mogrify -crop "${width}x$height+0+0" +repage tube.svg.png
same_picture tube.svg.png tube.png

# share PICTURE CONDITION: of the pixels.
share() { convert "$1" -alpha off -fx "$2" -format '%[fx:mean.r]' info:; }
browse 500,500 --virtual-time-budget=2000 --screenshot=page.png "file://$work/tube.html" >/dev/null
blue=$(share page.png 'b>r+0.1') warm=$(share page.png 'r>b+0.12')
echo "page: blue $blue, warm $warm"
that "the page shows the outside: $blue" less 0.04 "$blue"
that "the page shows the inside: $warm" less 0.02 "$warm"
# Where WebGL is not to be had, the page says so.
dom=$("$chromium" --headless "${root[@]}" --disable-gpu --disable-3d-apis --user-data-dir="$work/.chromium2" --dump-dom "file://$work/tube.html" 2>/dev/null)
checks=$((checks + 1))
[[ $dom == *'id="sorry">'* || $dom == *'id="sorry" >'* ]] || fail "the page does not say that there is no WebGL"
finish
