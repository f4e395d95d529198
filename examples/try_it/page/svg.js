// Makes elements of SVG, in pixels.
const svg = (() => {
  const element = (name, attributes = {}, text) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
  };
  const line = ([x1, y1], [x2, y2], attributes) => element("line", { x1, y1, x2, y2, ...attributes });
  const polygon = (points, attributes) => element("polygon", { points: points.map((p) => p.map((x) => x.toFixed(2)).join()).join(" "), ...attributes });
  const text = ([x, y], words, attributes) => element("text", { x, y, ...attributes }, words);

  // The line of an arrow ends inside its head. An arrow shorter than its head consists of the head alone.
  const LONG = 12, WIDE = 5;
  const arrow = (from, along, className) => {
    const size = Math.hypot(...along), group = element("g", { class: className });
    if (size < 1) return group;
    const [x, y] = along.map((a) => a / size), long = Math.min(LONG, size);
    const tip = outline.add(from, along), neck = outline.add(tip, [x, y], -long);
    group.append(line(from, outline.add(tip, [x, y], -0.8 * long), { "stroke-width": 3 }));
    group.append(polygon([tip, [neck[0] - WIDE * y, neck[1] + WIDE * x], [neck[0] + WIDE * y, neck[1] - WIDE * x]], {}));
    return group;
  };

  // The arrow of a moment: three quarters of a circle with a head, counterclockwise or clockwise.
  const turn = ([x, y], radius, counterclockwise, className) => {
    const at = (angle) => [x + radius * Math.cos(angle), y - radius * Math.sin(angle)];
    const way = counterclockwise ? 1 : -1, [from, to] = [at(way * -0.6), at(way * 3.6)];
    const group = element("g", { class: className });
    const path = `M${from}A${radius},${radius},0,1,${counterclockwise ? 0 : 1},${to}`;
    group.append(element("path", { d: path, fill: "none", "stroke-width": 3 }));
    const along = [-way * Math.sin(way * 3.6), -way * Math.cos(way * 3.6)];
    const tip = outline.add(to, along, 9), wide = [-along[1], along[0]];
    group.append(polygon([tip, outline.add(to, wide, WIDE), outline.add(to, wide, -WIDE)], {}));
    return group;
  };

  return { element, line, polygon, text, arrow, turn };
})();
