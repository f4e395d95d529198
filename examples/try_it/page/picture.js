// Draws object, friction cones, forces, load and displacement. `handles` draws the grips.
const picture = (() => {
  // Length of a friction cone, and largest drawn displacement, relative to the size of the object.
  const CONE = 0.3, DISPLACED = 0.1;
  // Least length of the arrow of a load, pixels, so that its grip does not hide it.
  const SHORTEST = 26;
  // Largest friction coefficient of a drawn cone.
  const WIDEST = 50;

  const drawCone = (place, { point, normal }, friction, state) => {
    const tangent = [normal[1], -normal[0]], size = outline.length(normal), { line } = state.now;
    const high = CONE * line.size, slope = Math.min(friction, WIDEST), side = high / Math.hypot(1, slope) / size;
    const rim = [1, -1].map((way) => outline.add(outline.add(point, normal, side), tangent, way * slope * side));
    return svg.polygon([point, ...rim].map(place.pixel), { class: "cone" });
  };

  const drawObject = (place, corners, className) => svg.polygon(corners.map(place.pixel), { class: className });

  // Displacement of all parts to first order, magnified by a common factor to be visible.
  const displaced = ({ line, parts }, held) => {
    const motion = (k) => {
      const { translation, rotation } = held.bodies ? held.bodies[k].twist : held.twist;
      return (p) => [translation[0] - rotation * p[1], translation[1] + rotation * p[0]];
    };
    const most = Math.max(...parts.flatMap((part, k) => part.line.corners.map((p) => outline.length(motion(k)(p)))));
    if (!(most > 0)) return null;
    const factor = numbers.roundDown((DISPLACED * line.size) / most);
    return { factor, outlines: parts.map((part, k) => part.line.corners.map((p) => outline.add(p, motion(k)(p), factor))) };
  };

  const drawLoad = (place, { force, moment, at }, scale) => {
    const group = svg.element("g"), from = place.pixel(at), size = outline.length(force);
    const way = place.along(force.map((f) => f / size)), far = place.width + place.height;
    group.append(svg.line(outline.add(from, way, -far), outline.add(from, way, far), { class: "action" }));
    const toScale = size * scale >= SHORTEST;
    group.append(svg.arrow(from, place.along(force, toScale ? scale : SHORTEST / size), "load"));
    if (moment !== 0) group.append(svg.turn(from, 26, moment > 0, "load"));
    return { group, toScale };
  };

  // Scale of forces: an arrow of a round force in the corner.
  const drawScale = (place, scale) => {
    const round = numbers.roundDown(90 / scale), [x, y] = [14, place.height - 14];
    const group = svg.element("g", { class: "scale" });
    group.append(svg.arrow([x, y], [round * scale, 0], "scale-arrow"));
    group.append(svg.text([x, y - 10], numbers.text(round, "N")));
    return group;
  };

  // Only `found.held` has forces and a displacement to draw.
  const draw = (group, place, found) => {
    const { fingers, friction, load, parts: bodies } = state.now;
    const held = found.held ? found.held.contacts : [];
    const scale = view.forceScale(place, [load.force, ...held.map(({ force }) => force)]);
    const moved = found.held && displaced(state.now, found.held);
    const parts = bodies.map(({ line }) => drawObject(place, line.corners, "object"));
    fingers.forEach((finger, k) => {
      const cone = drawCone(place, finger, friction, state);
      cone.classList.add(held[k] ? held[k].state : "unknown");
      parts.push(cone);
    });
    if (moved) parts.push(...moved.outlines.map((corners) => drawObject(place, corners, "displaced")));
    const { group: arrow, toScale } = drawLoad(place, load, scale);
    parts.push(arrow);
    held.forEach(({ force_world: force, state: what }, k) => {
      const arrow = (way) => svg.arrow(place.pixel(fingers[k].point), place.along(force, way * scale), `force ${what}`);
      // Between two parts the force acts on both, in opposite directions.
      parts.push(...(fingers[k].fixed ? [1, -1] : [1]).map(arrow));
    });
    if (scale > 0) parts.push(drawScale(place, scale));
    group.replaceChildren(...parts);
    return { scale, factor: moved ? moved.factor : null, toScale };
  };

  return { draw };
})();
