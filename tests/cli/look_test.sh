# What morphs look like: styles and view boxes of the inputs, in every format.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

svg() { echo "<svg xmlns=\"http://www.w3.org/2000/svg\" $1>$2</svg>"; }
outline='viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round"'
svg "$outline" '<path d="M4 6H20"/><path d="M4 18H20"/>' >menu.svg
svg "$outline" '<path d="M6 6L18 18"/><path d="M18 6L6 18"/>' >cross.svg
svg 'viewBox="0 0 36 36"' '<path fill="#DD2E44" d="M4 4H32V32H4Z"/>' >red.svg
svg 'viewBox="0 0 36 36"' '<path fill="#3B88C3" d="M18 4L32 32H4Z"/>' >blue.svg

# An outline stays one.
expect 0 morph menu.svg cross.svg -o out.svg
has() { that "$2 in $1" grep -q -- "$2" "$1"; }
has_not() { that "no $2 in $1" bash -c "! grep -q -- '$2' '$1'"; }
has out.svg 'viewBox="0 0 24 24"'
has out.svg '<path fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round" d='
has_not out.svg '#1f2733'
has_not out.svg 'attributeName="stroke'
expect 0 morph menu.svg cross.svg -o out.svg --at 0.5
has out.svg 'viewBox="0 0 24 24"'
has out.svg 'stroke="currentColor"'
expect 0 morph menu.svg cross.svg -o frames/ --frames 2
has frames/frame_001.svg 'stroke-linecap="round"'
expect 0 morph menu.svg cross.svg -o out.css
has out.css '/\* <svg viewBox="0 0 24 24"><path class="morph"/></svg> \*/'
has out.css 'stroke: currentColor; stroke-width: 2; stroke-linecap: round; stroke-linejoin: round;'
expect 0 morph menu.svg cross.svg -o out.avd.xml
has out.avd.xml 'viewportWidth="24" android:viewportHeight="24"'
has out.avd.xml 'android:strokeColor="#000000" android:strokeWidth="2" android:strokeLineCap="round" android:strokeLineJoin="round"'
has_not out.avd.xml fillColor
expect 0 morph menu.svg cross.svg -o out.lottie.json --size 240
has out.lottie.json '"w":{"a":0,"k":20},"lc":2,"lj":2'
has_not out.lottie.json '"fl"'
expect 0 morph menu.svg cross.svg -o out.html
has out.html '"view":\[0,0,24,24\]'

# A line without a partner has no width where it is a point, before it is born too: round caps would draw a dot.
svg "$outline" '<path d="M4 6H20"/><path d="M4 12H20"/><path d="M4 18H20"/>' >three.svg
expect 0 morph three.svg cross.svg -o out.svg --at 1
has out.svg 'stroke-width="0"'
expect 0 morph menu.svg menu.svg three.svg -o out.svg --at 0
has out.svg 'stroke-width="0"'
expect 0 morph menu.svg cross.svg -o out.svg --at 1
has_not out.svg 'stroke-width="0"'

# What a file asks for and does not get is said, and only that.
svg 'viewBox="0 0 24 24"' '<style>g > path { fill: red } path:hover { fill: blue }</style><defs><linearGradient id="g"><stop stop-color="red"/></linearGradient></defs>
  <g stroke-dasharray="2"><path fill="url(#g)" d="M4 4H20V20H4Z"/></g><text>Hi</text><g stroke-dasharray="none" display="none"><path mask="url(#m)" d="M0 0H1V1Z"/></g>' >rich.svg
expect 0 morph rich.svg red.svg -o out.svg
err_has 'rich is drawn without dashes, gradients and patterns beyond their first colour, <text>, styles for "g > path"'
expect 0 morph red.svg blue.svg -o out.svg
err_empty
svg 'viewBox="0 0 24 24"' '<path d="M2 2H9V9Z"/><path fill="none" stroke="red" d="M12 12L20 20"/>' >mixed.svg
expect 0 morph mixed.svg red.svg -o out.svg
err_has 'mixed is drawn without its lines beside what is filled'

# One contour that crosses itself keeps its rule.
svg 'viewBox="0 0 24 24"' '<path fill-rule="evenodd" d="M12 1L19 22L1 9H23L5 22Z"/>' >pentagram.svg
expect 0 morph pentagram.svg red.svg -o out.svg --at 0
has out.svg 'fill-rule="evenodd"'

# Colours change on the way.
expect 0 morph red.svg blue.svg -o out.svg
has out.svg '<animate attributeName="fill" .* values="#dd2e44;#3b88c3;#dd2e44"/>'
has_not out.svg stroke
expect 0 morph red.svg blue.svg -o out.svg --at 0.5
has out.svg 'fill="#8c5b84"'
expect 0 morph red.svg blue.svg -o out.css
has out.css '100% { fill: #3b88c3; }'
expect 0 morph red.svg blue.svg -o out.css --css clip-path
has out.css '0% { background: #dd2e44; }'
expect 0 morph red.svg blue.svg -o out.avd.xml
has out.avd.xml 'propertyName="fillColor" android:valueType="colorType".*valueFrom="#dd2e44" android:valueTo="#3b88c3"'
expect 0 morph red.svg blue.svg -o out.lottie.json
has out.lottie.json '"ty":"fl","c":{"a":1,"k":\[{"t":0,"s":\[0.866667,0.180392,0.266667,1\]'

# Style or view box of one input only, or of several kinds.
expect 0 morph red.svg 'M10 10H40V20Z' -o out.svg --at 1
has out.svg 'viewBox="0 0 40 36"'
has out.svg 'fill="#dd2e44"'
expect 0 morph menu.svg red.svg -o out.svg
err_has 'view boxes differ \(0 0 24 24, 0 0 36 36\): what comes out shows 0 0 36 36'
has out.svg 'attributeName="fill-opacity".* values="0;1;0"'
has out.svg 'attributeName="stroke-width".* values="2;0;2"'
svg 'viewBox="0 0 36 36"' '<path fill="#FFCC4D" d="M1 1H35V35H1Z"/><path fill="#664500" d="M9 9H12V12H9Z"/>' >face.svg
expect 0 morph face.svg red.svg -o out.svg
err_has 'face.* is drawn in several styles'
has out.svg 'values="#ffcc4d;#dd2e44;#ffcc4d"'
# What draws nothing that could be seen has no style, nor has path data.
svg '' '<line x2="9" y2="9"/>' >line.svg
expect 0 morph line.svg line.svg -o out.svg
has out.svg 'stroke="#1f2733"'

# An open subpath that is filled is filled, and a note names the remedy.
svg 'viewBox="0 0 24 24"' '<path d="M4 20L12 4L20 20"/>' >open.svg
expect 0 morph open.svg open.svg -o out.svg
err_has 'open though filled.*contour 0 of A, contour 0 of B; --closed yes'
has_not out.svg stroke
has_not out.svg 'fill="none"'
expect 0 morph open.svg open.svg -o out.svg --closed yes
err_empty
expect 0 morph menu.svg cross.svg -o out.svg
that "no note about open lines" test "${err/open/}" == "$err"
expect 0 morph "$square" "$triangle" -o out.svg --smooth
err_has '--smooth .* does nothing'
expect 0 morph "$square" "$triangle" "$square" -o out.svg --smooth --quiet
finish
