#pragma once

/// What the page of a surface has beside the shell of all pages (io/page.h): how it draws. How it is moved is
/// in surface_page_moves.h.
namespace tandem {
inline namespace v0 {

inline constexpr const char* kSurfaceStyle = R"page(:root { --width: 72rem; }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; cursor: grab; touch-action: none; }
canvas:active { cursor: grabbing; }
#sorry { position: absolute; inset: 0; display: grid; place-items: center; padding: 2rem; color: var(--soft); }
[hidden] { display: none !important; }
.bar { gap: .6rem; flex-wrap: wrap; }
.keys { margin-left: auto; }
@media (max-width: 60rem) { .keys { display: none; } }
)page";

inline constexpr const char* kSurfaceBody = R"page(<div class="stage">
<canvas id="view" tabindex="0" role="img" aria-label="The surface; arrow keys turn it, plus and minus zoom"></canvas>
<p id="sorry" hidden>This browser shows no WebGL 2, which the picture needs.</p>
</div>
<div class="bar">
<button id="iso" type="button" aria-pressed="true">Iso-lines</button>
<button id="wire" type="button" aria-pressed="false">Triangles</button>
<button id="back" type="button" aria-pressed="true">Back faces</button>
<button id="spin" type="button" aria-pressed="false">Turn</button>
<button id="reset" type="button">Reset</button>
<p class="keys">drag turns &ensp; <kbd>Shift</kbd> drag moves &ensp; wheel zooms &ensp; <kbd>I</kbd> <kbd>W</kbd> <kbd>B</kbd> <kbd>T</kbd> <kbd>R</kbd></p>
</div>
)page";

inline constexpr const char* kSurfaceScript = R"page(const scene = data;
const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
const canvas = byId("view");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true });
if (!gl) { byId("sorry").hidden = false; canvas.hidden = true; throw new Error("no WebGL 2"); }

function bytes(text) {
  const binary = atob(text), array = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) array[i] = binary.charCodeAt(i);
  return array.buffer;
}

function program(vertex, fragment) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, "#version 300 es\nprecision highp float;\n" + text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  const names = {};
  for (let i = 0; i < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); i++) {
    const name = gl.getActiveUniform(made, i).name;
    names[name] = gl.getUniformLocation(made, name);
  }
  return { made, names };
}

// Lamps above to the left and at the viewer, and a glint: the light picks a colour of the ramp.
const faces = program(`
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 projection, view;
out vec3 n;
out vec3 p;
void main() {
  n = mat3(view) * normal;
  vec4 at = view * vec4(position, 1.0);
  p = at.xyz;
  gl_Position = projection * at;
}`, `
in vec3 n;
in vec3 p;
uniform float front, tint, flat_light, orthographic;
uniform mat4 ramps[3];
out vec4 color;
vec3 pick(mat4 ramp, float light) {
  vec3 c = mix(ramp[0].rgb, ramp[1].rgb, clamp(light / 0.5, 0.0, 1.0));
  c = mix(c, ramp[2].rgb, clamp((light - 0.5) / 0.32, 0.0, 1.0));
  return mix(c, ramp[3].rgb, clamp((light - 0.82) / 0.18, 0.0, 1.0));
}
void main() {
  vec3 to_eye = orthographic > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-p);
  bool is_front = gl_FrontFacing == (front > 0.0);
  vec3 m = normalize(n);
  if (!gl_FrontFacing) m = -m;
  float facing = max(dot(m, to_eye), 0.0);
  vec3 lamp = normalize(vec3(-0.5, 0.75, 0.6));
  float glint = pow(max(dot(m, normalize(lamp + to_eye)), 0.0), 48.0);
  float light = 0.16 + 0.46 * max(dot(m, lamp), 0.0) + 0.2 * facing + 0.18 * glint;
  if (flat_light > 0.5) light = 0.72;
  vec3 c = is_front || tint < 0.5 ? pick(ramps[0], light) : flat_light > 0.5 ? pick(ramps[2], light) : pick(ramps[1], light);
  color = vec4(c, 1.0);
}`);

// Segments as ribbons of some pixels; a point with w = 0 ends a line.
const ribbons = program(`
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 a;
layout(location = 2) in vec4 b;
uniform mat4 projection, view;
uniform vec2 size;
uniform float width, lift;
void main() {
  vec4 p = projection * (view * vec4(a.xyz, 1.0));
  vec4 q = projection * (view * vec4(b.xyz, 1.0));
  vec2 along = (q.xy / q.w - p.xy / p.w) * size;
  float length_ = length(along);
  vec2 direction = length_ > 0.0 ? along / length_ : vec2(1.0, 0.0);
  vec2 side = vec2(-direction.y, direction.x);
  vec4 at = corner.x < 0.5 ? p : q;
  at.xy += (side * corner.y + direction * (corner.x - 0.5) * 0.8) * width / size * at.w;
  at.z -= lift * at.w;
  gl_Position = a.w * b.w > 0.5 ? at : vec4(2.0, 2.0, 2.0, 1.0);
}`, `
uniform vec4 ink;
out vec4 color;
void main() { color = vec4(ink.rgb * ink.a, ink.a); }`);

function buffer(kind, data) {
  const made = gl.createBuffer();
  gl.bindBuffer(kind, made);
  gl.bufferData(kind, data, gl.STATIC_DRAW);
  return made;
}

function attribute(index, size, stride, offset, divisor) {
  gl.enableVertexAttribArray(index);
  gl.vertexAttribPointer(index, size, gl.FLOAT, false, stride, offset);
  gl.vertexAttribDivisor(index, divisor);
}

function faceArray() {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  buffer(gl.ARRAY_BUFFER, bytes(scene.positions));
  attribute(0, 3, 0, 0, 0);
  buffer(gl.ARRAY_BUFFER, bytes(scene.normals));
  attribute(1, 3, 0, 0, 0);
  buffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
  return array;
}

function ribbonArray(points) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  buffer(gl.ARRAY_BUFFER, new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]));
  attribute(0, 2, 0, 0, 0);
  buffer(gl.ARRAY_BUFFER, points);
  attribute(1, 4, 16, 0, 1);
  attribute(2, 4, 16, 16, 1);
  return { array, count: Math.max(points.length / 4 - 1, 0) };
}

const triangles = new Uint32Array(bytes(scene.triangles));
const surface = faceArray();
const lines = {};
for (const kind of ["iso", "edge", "curve"]) lines[kind] = ribbonArray(new Float32Array(bytes(scene[kind])));
let edges = null;
function wire() {
  if (edges) return edges;
  const positions = new Float32Array(bytes(scene.positions));
  const seen = new Set(), points = [];
  for (let i = 0; i < triangles.length; i++) {
    const a = triangles[i], b = triangles[i % 3 === 2 ? i - 2 : i + 1];
    const key = Math.min(a, b) * (positions.length / 3) + Math.max(a, b);
    if (seen.has(key)) continue;
    seen.add(key);
    points.push(...positions.subarray(3 * a, 3 * a + 3), 1, ...positions.subarray(3 * b, 3 * b + 3), 1, 0, 0, 0, 0);
  }
  return edges = ribbonArray(new Float32Array(points));
}

const shown = { iso: true, wire: false, back: true, spin: false };
const home = { azimuth: scene.azimuth, elevation: scene.elevation, zoom: 1, x: 0, y: 0 };
const eye = { ...home };
const radians = Math.PI / 180;

// Parallel rays for what is planar, a long lens otherwise.
const distance = scene.planar ? 10 : 4.6;
function matrices(aspect) {
  const a = eye.azimuth * radians, e = eye.elevation * radians;
  const right = [-Math.sin(a), Math.cos(a), 0];
  const toward = [Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e)];
  const up = [-Math.cos(a) * Math.sin(e), -Math.sin(a) * Math.sin(e), Math.cos(e)];
  const view = [right[0], up[0], toward[0], 0, right[1], up[1], toward[1], 0, right[2], up[2], toward[2], 0,
                eye.x, eye.y, -distance, 1];
  const fit = Math.min(aspect, 1) * eye.zoom / 1.04;
  const near = distance - 1.6, far = distance + 1.6, depth = 1 / (near - far);
  if (scene.planar) {
    return [view, [fit / aspect, 0, 0, 0, 0, fit, 0, 0, 0, 0, 2 * depth, 0, 0, 0, (near + far) * depth, 1]];
  }
  const lens = fit * Math.sqrt(distance * distance - 1);
  return [view, [lens / aspect, 0, 0, 0, 0, lens, 0, 0, 0, 0, (near + far) * depth, -1, 0, 0, 2 * near * far * depth, 0]];
}

const ramp = (...colors) => colors.flatMap((c) => [...c.map((x) => x / 255), 1]);
const ramps = new Float32Array([
  ...ramp([40, 58, 112], [101, 132, 216], [178, 198, 244], [246, 249, 255]),
  ...ramp([116, 60, 38], [222, 158, 122], [244, 211, 188], [255, 249, 243]),
  ...ramp([120, 20, 30], [214, 60, 60], [226, 84, 80], [255, 240, 240])]);

function ink() {
  const hex = getComputedStyle(document.documentElement).getPropertyValue("--ink").trim();
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
}

function drawLines({ array, count }, width, color, lift) {
  gl.uniform1f(ribbons.names.width, width * devicePixelRatio);
  gl.uniform1f(ribbons.names.lift, lift);
  gl.uniform4f(ribbons.names.ink, ...color);
  gl.bindVertexArray(array);
  if (count > 0) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
}

function draw() {
  const width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio));
  const height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  gl.viewport(0, 0, width, height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  const [view, projection] = matrices(width / height);
  for (const { made, names } of [faces, ribbons]) {
    gl.useProgram(made);
    gl.uniformMatrix4fv(names.view, false, view);
    gl.uniformMatrix4fv(names.projection, false, projection);
  }
  gl.useProgram(faces.made);
  gl.uniform1f(faces.names.front, scene.front);
  gl.uniform1f(faces.names.tint, shown.back ? 1 : 0);
  gl.uniform1f(faces.names.flat_light, scene.planar ? 1 : 0);
  gl.uniform1f(faces.names.orthographic, scene.planar ? 1 : 0);
  gl.uniformMatrix4fv(faces.names["ramps[0]"], false, ramps);
  gl.disable(gl.BLEND);
  gl.enable(gl.POLYGON_OFFSET_FILL);
  gl.polygonOffset(1, 1);
  gl.bindVertexArray(surface);
  const drawFaces = () => gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0);
  if (scene.planar) {
    // All at one depth: the folds on top.
    const most = scene.front * eye.elevation > 0;
    gl.enable(gl.CULL_FACE);
    gl.cullFace(most ? gl.BACK : gl.FRONT);
    drawFaces();
    gl.cullFace(most ? gl.FRONT : gl.BACK);
    gl.disable(gl.DEPTH_TEST);
    drawFaces();
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
  } else {
    drawFaces();
  }
  gl.disable(gl.POLYGON_OFFSET_FILL);
  gl.useProgram(ribbons.made);
  gl.uniform2f(ribbons.names.size, width, height);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  gl.depthMask(false);
  const dark = [31 / 255, 39 / 255, 51 / 255];
  if (shown.wire) drawLines(wire(), 0.8, [...dark, 0.3], 1e-3);
  if (shown.iso) drawLines(lines.iso, 1.1, [...dark, 0.42], 2e-3);
  gl.depthMask(true);
  drawLines(lines.edge, 1.8, [...ink(), 1], 3e-3);
  drawLines(lines.curve, 3.4, [...ink(), 1], 4e-3);
}

)page";

}  // namespace v0
}  // namespace tandem
