"use strict";
// Draws the grasp on a canvas, seen from afar, and turns it. Everything is painted from back to front.
(() => {
  const scene = JSON.parse(document.getElementById("grasp").textContent);
  const canvas = document.getElementById("view");
  const pen = canvas.getContext("2d");
  const COLOURS = {
    "sticking": "#0072b2", "about-to-slide": "#e69f00", "sliding": "#d55e00", "separated": "#6e6e6e", "frictionless": "#009e73",
  };
  const [BLACK, GREY, PINK, SKY, VERMILION] = ["#000", "#6e6e6e", "#cc79a7", "#3a8fc8", "#d55e00"];
  const SIDES = 32;
  const START = { ...scene.view, zoom: 1 };
  let { yaw, pitch, zoom } = START;
  let shown = 0, lit = -1;
  const layers = {};

  const add = (a, b, s = 1) => a.map((x, k) => x + s * b[k]);
  const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = (a) => Math.hypot(...a);
  // To first order, magnified.
  const moved = (twist, p) => add(p, add(twist.slice(0, 3), cross(twist.slice(3), p)), scene.displacement);

  // Everything of every answer stays inside the picture, so that answers can be compared.
  const reach = (() => {
    const ends = [...scene.outlines.flat(), ...scene.fixtures.flat()];
    for (const { point, normal } of scene.contacts) ends.push(point, add(point, normal, -scene.finger));
    for (const frame of scene.frames.filter(Boolean)) {
      const { load } = frame;
      frame.contacts.forEach(({ at, force }) => ends.push(add(at, force, scene.force)));
      ends.push(load.at, add(load.at, load.force, scene.force), add(load.at, load.moment, scene.moment));
      ends.push(...scene.outlines.flat().map((p) => moved(frame.twist, p)));
    }
    return Math.max(...ends.map((p) => length(add(p, scene.centre, -1))), scene.span / 2);
  })();

  // A point in pixels and its distance towards the eye.
  let project = () => [0, 0, 0];
  const look = () => {
    const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    const right = [cy, sy, 0], eye = [sy * cp, -cy * cp, sp], up = cross(eye, right);
    const scale = (0.46 * zoom * Math.min(canvas.clientWidth, canvas.clientHeight)) / reach;
    project = (p) => {
      const q = add(p, scene.centre, -1);
      return [canvas.clientWidth / 2 + scale * dot(right, q), canvas.clientHeight / 2 - scale * dot(up, q), scale * dot(eye, q)];
    };
  };

  let strokes = [];
  const paint = (depth, draw) => strokes.push({ depth, draw });
  const path = (points, closed) => {
    pen.beginPath();
    points.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    if (closed) pen.closePath();
  };
  const line = (from, to, ink, width, dashes = []) => {
    const ends = [project(from), project(to)];
    paint((ends[0][2] + ends[1][2]) / 2, () => {
      path(ends);
      [pen.strokeStyle, pen.lineWidth] = [ink, width];
      pen.setLineDash(dashes);
      pen.stroke();
      pen.setLineDash([]);
    });
  };
  const loop = (points, ink, width, dashes) =>
    points.forEach((p, k) => {
      const next = points[(k + 1) % points.length];
      // Two corners are one line.
      if (k + 1 < points.length || k > 1) line(p, next, typeof ink === "string" ? ink : ink(p, next), width, dashes);
    });
  const face = (points, ink, opacity) => {
    const corners = points.map(project);
    paint(corners.reduce((sum, c) => sum + c[2], 0) / corners.length, () => {
      path(corners, true);
      pen.globalAlpha = opacity;
      pen.fillStyle = ink;
      pen.fill();
      pen.globalAlpha = 1;
    });
  };
  // A grey, darker where it is nearer.
  const shades = () => {
    const depths = scene.outlines.flat().map((p) => project(p)[2]);
    const [far, near] = [Math.min(...depths), Math.max(...depths)];
    return (a, b) => {
      const part = near > far ? ((project(a)[2] + project(b)[2]) / 2 - far) / (near - far) : 1;
      const grey = Math.round(200 - 110 * part);
      return `rgb(${grey},${grey},${grey})`;
    };
  };
  // A convex part of the object, behind everything.
  const body = (points) => {
    const places = points.map(project).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = (places) => {
      const line = [];
      for (const c of places) {
        const turnsBack = ([a, b]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0;
        while (line.length > 1 && turnsBack(line.slice(-2))) line.pop();
        line.push(c);
      }
      return line.slice(0, -1);
    };
    const corners = [...half(places), ...half(places.reverse())];
    // Of the contour that half is left which is beside all bodies.
    paint(-Infinity, () => {
      path(corners, true);
      [pen.strokeStyle, pen.lineWidth] = ["#969696", 2.4];
      pen.stroke();
    });
    paint(-Number.MAX_VALUE, () => {
      path(corners, true);
      pen.fillStyle = "#eeeff1";
      pen.fill();
    });
  };
  const head = (tip, back, ink, width) => {
    const [a, b] = [project(tip), project(back)];
    const along = [a[0] - b[0], a[1] - b[1]], size = Math.hypot(...along);
    if (size < 1e-6) return;
    const [long, wide] = [Math.min(4.5 * width, size), 1.6 * width];
    const [x, y] = [along[0] / size, along[1] / size];
    const neck = [a[0] - long * x, a[1] - long * y];
    paint(a[2] + 1e-3, () => {
      path([a, [neck[0] - wide * y, neck[1] + wide * x], [neck[0] + wide * y, neck[1] - wide * x]], true);
      pen.fillStyle = ink;
      pen.fill();
    });
  };
  const arrow = (from, along, ink, width, heads = 1) => {
    if (length(along) === 0) return;
    // The line ends inside the head.
    const size = Math.hypot(...[0, 1].map((k) => project(add(from, along))[k] - project(from)[k]));
    const neck = Math.max(0, 1 - (3 * width * heads) / Math.max(size, 1e-6));
    line(from, add(from, along, neck), ink, width);
    head(add(from, along), from, ink, width);
    if (heads === 2) head(add(from, along, Math.max(0, 1 - (4.5 * width) / Math.max(size, 1e-6))), from, ink, width);
  };
  const text = (at, words, ink, bold, [dx, dy] = [10, -8]) => {
    const [x, y] = project(at);
    paint(Infinity, () => {
      pen.font = `${bold ? "bold " : ""}14px sans-serif`;
      [pen.lineWidth, pen.strokeStyle, pen.fillStyle] = [4, "#ffffffd0", ink];
      pen.strokeText(words, x + dx, y + dy);
      pen.fillText(words, x + dx, y + dy);
    });
  };

  const drawCone = ({ normal, tangents, mu }, point, normalForce, ink) => {
    const high = scene.cone * normalForce * scene.force, wide = mu * high;
    if (!(high > 0 && wide > 0)) return;
    const rim = Array.from({ length: SIDES }, (_, k) => {
      const [c, s] = [Math.cos((2 * Math.PI * k) / SIDES), Math.sin((2 * Math.PI * k) / SIDES)];
      return add(add(add(point, normal, high), tangents[0], wide * c), tangents[1], wide * s);
    });
    rim.forEach((p, k) => face([point, p, rim[(k + 1) % SIDES]], ink, 0.1));
    loop(rim, ink, 1);
  };

  const drawDot = (at, state, size) => {
    const [x, y, depth] = project(at);
    paint(depth + 1e-2, () => {
      pen.beginPath();
      pen.arc(x, y, size, 0, 2 * Math.PI);
      const open = !state || state === "separated", ink = COLOURS[state] || GREY;
      [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = [open ? "#fff" : ink, open ? ink : "#fff", open ? 2 : 1];
      pen.fill();
      pen.stroke();
    });
  };
  const drawContact = (contact, answer, i) => {
    const { point, points, normal, name } = contact;
    // The finger, behind the contact.
    line(add(point, normal, -scene.finger), point, GREY, 5);
    if (answer) {
      const { at } = answer, ink = COLOURS[answer.state];
      if (layers.cones) drawCone(contact, at, answer.normal_force, ink);
      if (layers.forces) arrow(at, answer.force.map((f) => f * scene.force), ink, 3);
      if (layers.displacements) arrow(at, answer.displacement.map((u) => u * scene.displacement), PINK, 2);
      if (answer.slides) arrow(at, answer.slides.map((d) => scene.slip * d), "#7a3600", 2);
      points.forEach((p, k) => drawDot(p, answer.states[k], (points.length > 1 ? 3 : 6) + (i === lit ? 3 : 0)));
    } else {
      drawDot(point, null, i === lit ? 9 : 6);
    }
    if (i === lit || (layers.names && scene.contacts.length <= scene.many)) text(add(point, normal, -scene.finger), name, "#222", i === lit);
  };

  // A round force, and the arrow that stands for it.
  const drawScale = () => {
    const pixels = length(add(project([scene.force, 0, 0]), project([0, 0, 0]), -1));
    if (!(pixels > 0)) return;
    const power = 10 ** Math.floor(Math.log10(100 / pixels));
    const round = [5, 2, 1].map((k) => k * power).find((force) => force * pixels <= 100);
    const [from, to] = [canvas.clientWidth - 20 - round * pixels, canvas.clientWidth - 20];
    const y = canvas.clientHeight - 22;
    paint(Infinity, () => {
      path([[from, y], [to - 9, y]]);
      [pen.strokeStyle, pen.fillStyle, pen.lineWidth, pen.font] = [GREY, GREY, 3, "13px sans-serif"];
      pen.stroke();
      path([[to, y], [to - 13, y - 5], [to - 13, y + 5]], true);
      pen.fill();
      pen.fillText(`${Number(round.toPrecision(1))} N`, from, y - 9);
    });
  };

  const drawAxes = () => {
    // In the corner, turned like the grasp.
    const origin = project(scene.centre), unit = reach / zoom;
    const corner = [46, canvas.clientHeight - 46];
    ["x", "y", "z"].forEach((name, k) => {
      const tip = project(add(scene.centre, [0, 1, 2].map((j) => (j === k ? 0.13 * unit : 0))));
      const end = [corner[0] + tip[0] - origin[0], corner[1] + tip[1] - origin[1]];
      paint(Infinity, () => {
        path([corner, end]);
        [pen.strokeStyle, pen.lineWidth, pen.fillStyle, pen.font] = ["#888", 1.5, "#555", "13px sans-serif"];
        pen.stroke();
        pen.fillText(name, end[0] + 4 * Math.sign(end[0] - corner[0]) - 3, end[1] + 4 * Math.sign(end[1] - corner[1]) + 4);
      });
    });
  };

  const draw = () => {
    const ratio = window.devicePixelRatio || 1;
    [canvas.width, canvas.height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    [pen.lineJoin, pen.lineCap] = ["round", "round"];
    look();
    strokes = [];
    const frame = scene.frames[shown];
    for (const fixture of scene.fixtures) loop(fixture, "#ccc", 1);
    scene.bodies.forEach(body);
    const shade = shades();
    for (const outline of scene.outlines) {
      loop(outline, shade, 1.2);
      if (frame && layers.displacements) loop(outline.map((p) => moved(frame.twist, p)), PINK, 1, [5, 4]);
    }
    scene.contacts.forEach((contact, i) => drawContact(contact, frame && frame.contacts[i], i));
    if (frame && layers.load) {
      const { at, force, moment } = frame.load;
      arrow(at, force.map((f) => f * scene.force), BLACK, 3);
      arrow(at, moment.map((m) => m * scene.moment), BLACK, 2, 2);
      const end = length(force) > 0 ? add(at, force, scene.force) : add(at, moment, scene.moment);
      if (layers.names && length(add(end, at, -1)) > 0) text(end, "load", BLACK, false, [8, 14]);
    }
    for (const { name, at } of frame ? frame.yields : []) {
      const [x, y, depth] = project(at);
      paint(depth + 1e-2, () => {
        pen.beginPath();
        pen.arc(x, y, 7, 0, 2 * Math.PI);
        pen.fillStyle = VERMILION;
        pen.fill();
      });
      if (layers.names) text(at, `${name} yields`, VERMILION, false);
    }
    if (frame && layers.free) {
      for (const { at, along, turns } of frame.free) {
        line(add(at, along, -scene.axis), add(at, along, scene.axis), SKY, 2, [9, 6]);
        text(add(at, along, scene.axis), turns ? "turns freely" : "moves freely", SKY, false);
      }
    }
    drawAxes();
    if (frame && layers.forces) drawScale();
    strokes.sort((a, b) => (a.depth < b.depth ? -1 : a.depth > b.depth ? 1 : 0)).forEach(({ draw }) => draw());
  };

  const show = (k) => {
    shown = k;
    for (const part of document.querySelectorAll("section[data-frame]")) part.hidden = Number(part.dataset.frame) !== k;
    for (const button of document.querySelectorAll("#frames button")) {
      button.setAttribute("aria-pressed", String(Number(button.dataset.frame) === k));
    }
    draw();
  };
  const light = (i) => {
    if (i === lit) return;
    lit = i;
    for (const row of document.querySelectorAll("tr[data-contact]")) row.classList.toggle("lit", Number(row.dataset.contact) === i);
    draw();
  };
  const under = ({ offsetX, offsetY }) => {
    const near = scene.contacts.map(({ point }, i) => [Math.hypot(project(point)[0] - offsetX, project(point)[1] - offsetY), i]);
    const [distance, i] = near.reduce((best, next) => (next[0] < best[0] ? next : best));
    return distance < 14 ? i : -1;
  };
  const turn = (across, down) => {
    yaw -= 0.008 * across;
    pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, pitch + 0.008 * down));
    draw();
  };

  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return light(under(event));
    turn(event.clientX - held[0], event.clientY - held[1]);
    held = [event.clientX, event.clientY];
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom = Math.max(0.2, Math.min(20, zoom * Math.exp(-0.0015 * event.deltaY)));
    draw();
  }, { passive: false });
  canvas.addEventListener("dblclick", () => {
    ({ yaw, pitch, zoom } = START);
    draw();
  });
  canvas.addEventListener("keydown", (event) => {
    const way = { ArrowLeft: [-15, 0], ArrowRight: [15, 0], ArrowUp: [0, -15], ArrowDown: [0, 15] }[event.key];
    if (!way) return;
    event.preventDefault();
    turn(...way);
  });
  for (const row of document.querySelectorAll("tr[data-contact]")) {
    row.addEventListener("mouseenter", () => light(Number(row.dataset.contact)));
    row.addEventListener("mouseleave", () => light(-1));
  }
  for (const button of document.querySelectorAll("#frames button")) {
    button.addEventListener("click", () => show(Number(button.dataset.frame)));
  }
  for (const box of document.querySelectorAll("input[data-layer]")) {
    layers[box.dataset.layer] = box.checked;
    box.addEventListener("change", () => {
      layers[box.dataset.layer] = box.checked;
      draw();
    });
  }
  window.addEventListener("resize", draw);
  draw();
})();
