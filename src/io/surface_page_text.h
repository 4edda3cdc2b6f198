#pragma once

/// The page of a surface: %TITLE% is filled in, and the data goes between the two parts.
namespace tandem {
inline namespace v0 {

inline constexpr const char* kSurfaceHead = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>%TITLE%</title>
<style>
:root { --page: #f4f2ee; --card: #fffefb; --line: #e2ded6; --ink: #1f2733; --soft: #6d7482; --accent: #3f62c8; }
@media (prefers-color-scheme: dark) {
  :root { --page: #14171c; --card: #1b1f26; --line: #2c323c; --ink: #e7e9ee; --soft: #98a1b0; --accent: #8ea8ff; }
}
* { box-sizing: border-box; }
html, body { height: 100%; }
body {
  margin: 0; padding: clamp(.75rem, 2.5vw, 2rem); display: flex; justify-content: center;
  background: var(--page); color: var(--ink); font: 15px/1.45 system-ui, "Segoe UI", Roboto, sans-serif;
}
main { width: min(100%, 72rem); min-height: 100%; display: flex; flex-direction: column; gap: .9rem; }
h1 { margin: 0; font-size: 1.05rem; font-weight: 600; letter-spacing: .005em; overflow-wrap: anywhere; }
.stage {
  flex: 1 1 0; min-height: 14rem; position: relative; background: var(--card); border: 1px solid var(--line);
  border-radius: 14px; overflow: hidden;
}
canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; cursor: grab; touch-action: none; }
canvas:active { cursor: grabbing; }
#sorry { position: absolute; inset: 0; display: grid; place-items: center; padding: 2rem; color: var(--soft); }
[hidden] { display: none !important; }
.bar { display: flex; align-items: center; gap: .6rem; flex-wrap: wrap; }
button {
  font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 999px;
  height: 2.5rem; padding: 0 1rem; cursor: pointer;
}
button:hover { border-color: var(--accent); }
button[aria-pressed="true"] { border-color: var(--accent); color: var(--accent); }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.keys { margin: 0 0 0 auto; color: var(--soft); font-size: .8rem; }
kbd { font: inherit; border: 1px solid var(--line); border-radius: 4px; padding: 0 .35em; }
@media (max-width: 60rem) { .keys { display: none; } }
</style>
</head>
<body>
<main>
<h1>%TITLE%</h1>
<div class="stage">
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
</main>
)page";

inline constexpr const char* kSurfaceScript = R"page(<script>
"use strict";
const byId = (id) => document.getElementById(id);
const scene = JSON.parse(byId("scene").textContent);
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

let waiting = false, last = 0, speed = [0, 0], goal = null;
const isDragged = () => fingers.size > 0;
function request() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame((now) => {
    waiting = false;
    const seconds = Math.min((now - last) / 1000, 0.05);
    last = now;
    step(seconds);
    draw();
  });
}

// What moves by itself: a turntable that was asked for, the rest of a push, the way home.
function step(seconds) {
  let moves = false;
  if (goal) {
    const share = still ? 1 : 1 - Math.exp(-9 * seconds);
    let left = 0;
    for (const key in goal) {
      eye[key] += share * (goal[key] - eye[key]);
      left = Math.max(left, Math.abs(goal[key] - eye[key]));
    }
    if (left < 1e-3) { Object.assign(eye, goal); goal = null; } else moves = true;
  }
  if (!still && !isDragged() && Math.hypot(...speed) > 1) {
    turn(speed[0] * seconds, speed[1] * seconds);
    speed = speed.map((x) => x * Math.exp(-5 * seconds));
    moves = true;
  }
  if (shown.spin && !isDragged()) { eye.azimuth += 24 * seconds; moves = true; }
  if (moves) request();
}

function turn(azimuth, elevation) {
  eye.azimuth += azimuth;
  eye.elevation = Math.min(90, Math.max(-90, eye.elevation + elevation));
}

function zoom(factor, x, y) {
  const before = eye.zoom;
  eye.zoom = Math.min(60, Math.max(0.2, eye.zoom * factor));
  // What is under the pointer stays there.
  const box = canvas.getBoundingClientRect(), unit = 2 * 1.04 / Math.min(box.width, box.height);
  const fx = (x - box.left - box.width / 2) * unit, fy = -(y - box.top - box.height / 2) * unit;
  eye.x += fx / eye.zoom - fx / before;
  eye.y += fy / eye.zoom - fy / before;
}

function move(dx, dy) {
  const unit = 2 * 1.04 / Math.min(canvas.clientWidth, canvas.clientHeight) / eye.zoom;
  eye.x += dx * unit;
  eye.y -= dy * unit;
}

const fingers = new Map();
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, event);
  goal = null;
  speed = [0, 0];
});
canvas.addEventListener("pointermove", (event) => {
  const before = fingers.get(event.pointerId);
  if (!before) return;
  const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
  if (fingers.size === 1 && !event.shiftKey && !(event.buttons & 6)) {
    turn(-0.4 * dx, 0.4 * dy);
    const seconds = Math.max((event.timeStamp - before.timeStamp) / 1000, 0.004);
    speed = [0.6 * speed[0] - 0.16 * dx / seconds, 0.6 * speed[1] + 0.16 * dy / seconds];
  } else if (fingers.size === 1) {
    move(dx, dy);
  } else if (fingers.size === 2) {
    const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
    const span = (e) => Math.hypot(e.clientX - other.clientX, e.clientY - other.clientY);
    move(dx / 2, dy / 2);
    zoom(span(event) / Math.max(span(before), 1), (event.clientX + other.clientX) / 2, (event.clientY + other.clientY) / 2);
  }
  fingers.set(event.pointerId, event);
  request();
});
function lift(event) {
  const before = fingers.get(event.pointerId);
  if (before && event.timeStamp - before.timeStamp > 60) speed = [0, 0];
  fingers.delete(event.pointerId);
  last = performance.now();
  request();
}
canvas.addEventListener("pointerup", lift);
canvas.addEventListener("pointercancel", lift);
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  goal = null;
  zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.04 : 0.0015)), event.clientX, event.clientY);
  request();
}, { passive: false });
canvas.addEventListener("dblclick", reset);

function toggle(name) {
  shown[name] = !shown[name];
  byId(name).setAttribute("aria-pressed", shown[name]);
  last = performance.now();
  request();
}
function reset() {
  speed = [0, 0];
  eye.azimuth -= 360 * Math.round((eye.azimuth - home.azimuth) / 360);
  goal = { ...home };
  last = performance.now();
  request();
}
for (const name in shown) byId(name).addEventListener("click", () => toggle(name));
byId("reset").addEventListener("click", reset);
const keys = {
  i: () => toggle("iso"), w: () => toggle("wire"), b: () => toggle("back"), t: () => toggle("spin"), r: reset,
  ArrowLeft: () => turn(-6, 0), ArrowRight: () => turn(6, 0), ArrowUp: () => turn(0, 6), ArrowDown: () => turn(0, -6),
};
addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const box = canvas.getBoundingClientRect();
  const scale = { "+": 1.2, "=": 1.2, "-": 1 / 1.2 }[event.key];
  if (scale) zoom(scale, box.left + box.width / 2, box.top + box.height / 2);
  else if (keys[event.key]) keys[event.key]();
  else if (keys[event.key.toLowerCase()]) keys[event.key.toLowerCase()]();
  else return;
  event.preventDefault();
  request();
});
// At home the scene fills the stage, not the ball about it.
function fill() {
  const points = new Float32Array(bytes(scene.positions)), aspect = canvas.clientWidth / Math.max(canvas.clientHeight, 1);
  const [view, projection] = matrices(aspect);
  let most = 0;
  for (let i = 0; i < points.length; i += 3) {
    const row = (m, k, p) => m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k];
    const at = points.subarray(i, i + 3), p = [0, 1, 2].map((k) => row(view, k, at));
    const w = row(projection, 3, p);
    most = Math.max(most, Math.abs(row(projection, 0, p) / w), Math.abs(row(projection, 1, p) / w));
  }
  if (most > 0) home.zoom = eye.zoom = Math.min(Math.max(0.92 / most, 0.5), 4);
}
fill();
if (scene.planar) byId("back").textContent = "Folds";
new ResizeObserver(request).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", request);
draw();
</script>
</body>
</html>
)page";

}  // namespace v0
}  // namespace tandem
