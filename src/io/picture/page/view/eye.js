// The marks of the grasp as data, vectors, and the places of points on the canvas, seen from afar.
const scene = JSON.parse(document.getElementById("grasp").textContent);
const canvas = document.getElementById("view");
const pen = canvas.getContext("2d");
const START = { ...scene.view, zoom: 1 };
let { yaw, pitch, zoom } = START;
let shown = 0, lit = -1;
const layers = {};

const add = (a, b, s = 1) => a.map((x, k) => x + s * b[k]);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);

// A point in pixels and its distance towards the eye.
let project = () => [0, 0, 0], perMetre = () => 1;
const look = () => {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const right = [cy, sy, 0], eye = [sy * cp, -cy * cp, sp], up = cross(eye, right);
  const scale = (0.46 * zoom * Math.min(canvas.clientWidth, canvas.clientHeight)) / scene.reach;
  perMetre = () => scale;
  project = (p) => {
    const q = add(p, scene.centre, -1);
    return [canvas.clientWidth / 2 + scale * dot(right, q), canvas.clientHeight / 2 - scale * dot(up, q), scale * dot(eye, q)];
  };
};
