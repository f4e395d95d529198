// Lines, faces, arrows and names. Everything is painted from back to front.
let strokes = [];
const paint = (depth, draw) => strokes.push({ depth, draw });
const path = (points, closed) => {
  pen.beginPath();
  points.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  if (closed) pen.closePath();
};
// A line through these corners, in pieces that have a depth each; dashes continue around the corners.
const line = (corners, ink, width, dashes = []) => {
  let offset = 0;
  corners.slice(1).forEach((to, k) => {
    const ends = [project(corners[k]), project(to)], start = offset;
    offset += Math.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    paint((ends[0][2] + ends[1][2]) / 2, () => {
      path(ends);
      [pen.strokeStyle, pen.lineWidth, pen.lineDashOffset] = [typeof ink === "string" ? ink : ink(ends), width, start];
      pen.setLineDash(dashes);
      pen.stroke();
      pen.setLineDash([]);
    });
  });
};
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
// A grey for each edge of the object, darker where it is nearer than other points of edges.
const shades = (points) => {
  const depths = points.map((p) => project(p)[2]);
  const [far, near] = [Math.min(...depths), Math.max(...depths)];
  return ([a, b]) => {
    const part = near > far ? ((a[2] + b[2]) / 2 - far) / (near - far) : 1;
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
  // Only the half of the contour that lies outside all bodies stays visible.
  paint(-Infinity, () => {
    path(corners, true);
    [pen.strokeStyle, pen.lineWidth] = [scene.contour, 2.4];
    pen.stroke();
  });
  paint(-Number.MAX_VALUE, () => {
    path(corners, true);
    pen.fillStyle = scene.face;
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
const arrow = (from, along, ink, width, heads) => {
  if (length(along) === 0) return;
  // The line ends inside the head.
  const size = Math.hypot(...[0, 1].map((k) => project(add(from, along))[k] - project(from)[k]));
  const neck = Math.max(0, 1 - (3 * width * heads) / Math.max(size, 1e-6));
  line([from, add(from, along, neck)], ink, width);
  head(add(from, along), from, ink, width);
  if (heads === 2) head(add(from, along, Math.max(0, 1 - (4.5 * width) / Math.max(size, 1e-6))), from, ink, width);
};
const cone = ({ cone: apex, middle, radii: [a, b], ink }) => {
  const rim = Array.from({ length: 33 }, (_, k) => {
    const turn = (2 * Math.PI * (k % 32)) / 32;
    return add(add(middle, a, Math.cos(turn)), b, Math.sin(turn));
  });
  rim.slice(1).forEach((p, k) => face([apex, rim[k], p], ink, 0.1));
  line(rim, ink, 1);
};
const circle = (at, radius, ink, open) => {
  const [x, y, depth] = project(at);
  paint(depth + 1e-2, () => {
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = [open ? "#fff" : ink, open ? ink : "#fff", open ? 2 : 1];
    pen.fill();
    pen.stroke();
  });
};
// The arrow of a load is never too short to be seen. Along the line of sight it is a dot in a circle, or a cross in one.
const load = ({ load: from, along, width, heads, name, otherwise }) => {
  const least = Math.min(scene.shortest, 0.04 * Math.min(canvas.clientWidth, canvas.clientHeight)) / perMetre();
  const most = Math.max(...along.map(Math.abs)), unit = along.map((x) => x / most);
  const toScale = length(along) >= least, size = toScale ? length(along) : least;
  const drawn = unit.map((x) => (x * size) / length(unit)), [a, b] = [project(from), project(add(from, drawn))];
  if (Math.hypot(b[0] - a[0], b[1] - a[1]) >= 8) arrow(from, drawn, "#000", width, heads);
  else {
    circle(from, 8, "#000", true);
    paint(a[2] + 2e-2, () => {
      pen.beginPath();
      if (b[2] > a[2]) pen.arc(a[0], a[1], 3, 0, 2 * Math.PI);
      else for (const side of [-5, 5]) [pen.moveTo(a[0] - 5, a[1] - side), pen.lineTo(a[0] + 5, a[1] + side)];
      [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = ["#000", "#000", 2];
      pen.fill();
      pen.stroke();
    });
  }
  if (layers.names) text(add(from, drawn), toScale ? name : otherwise, false);
};

// Names are written when everything is painted, each where it covers neither a contact nor another name; one that has no place beside its point is left out.
let names = [];
const text = (at, words, bold) => words && names.push({ at: project(at), words, bold });
const writeNames = () => {
  const high = 17;
  const taken = scene.contacts.map(project).map(([x, y]) => ({ x, y, wide: 10 }));
  const free = (box) => taken.every((other) => Math.abs(box.x - other.x) * 2 >= box.wide + other.wide || Math.abs(box.y - other.y) >= high);
  for (const { at: [x, y], words, bold } of names.sort((a, b) => Boolean(b.bold) - Boolean(a.bold))) {
    pen.font = `${bold ? "bold " : ""}14px sans-serif`;
    const wide = Math.min(pen.measureText(words).width + 6, canvas.clientWidth);
    const inside = (at, room, size) => Math.max(size / 2, Math.min(room - size / 2, at));
    const places = [9, 18, 30, 44].flatMap((away) => [[1, -1], [-1, -1], [1, 0], [-1, 0], [1, 1], [-1, 1], [0, -1], [0, 1]].map(([dx, dy]) => ({
      x: inside(x + dx * (wide / 2 + away * (dy ? 0.6 : 1)), canvas.clientWidth, wide),
      y: inside(y + dy * (high / 2 + away * (dx ? 0.6 : 1)), canvas.clientHeight, high), wide,
    })));
    const box = places.find(free) || (bold && places[0]);
    if (!box) continue;
    taken.push(box);
    [pen.lineWidth, pen.strokeStyle, pen.fillStyle] = [4, "#ffffffd0", "#000"];
    pen.strokeText(words, box.x - wide / 2 + 3, box.y + 5, wide - 6);
    pen.fillText(words, box.x - wide / 2 + 3, box.y + 5, wide - 6);
  }
};
