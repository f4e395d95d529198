// The closed line along which fingers are dragged, parametrised by arclength from its first corner.
const outline = (() => {
  // An outline with at least ROUND_FROM corners on a circle, within ROUND_WITHIN, is a disk, which has a continuous normal.
  const ROUND_FROM = 12, ROUND_WITHIN = 1e-2;

  const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
  const length = (a) => Math.hypot(a[0], a[1]);

  const box = (corners) => {
    const along = (k) => corners.map((corner) => corner[k]);
    const [low, high] = [[0, 1].map((k) => Math.min(...along(k))), [0, 1].map((k) => Math.max(...along(k)))];
    return { middle: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], size: Math.max(high[0] - low[0], high[1] - low[1]) };
  };

  const polygon = (corners) => {
    const next = (k) => corners[(k + 1) % corners.length];
    const area = corners.reduce((sum, [x, y], k) => sum + x * next(k)[1] - y * next(k)[0], 0);
    let total = 0;
    const edges = corners.map((from, k) => {
      const along = add(next(k), from, -1), size = length(along), start = total;
      total += size;
      const unit = [along[0] / size, along[1] / size];
      // Normal into the object, for either orientation of the corners.
      return { from, unit, size, start, normal: area > 0 ? [-unit[1], unit[0]] : [unit[1], -unit[0]] };
    });
    const at = (s) => {
      const place = ((s % total) + total) % total;
      const edge = edges.findLast(({ start }) => start <= place);
      return { s: place, point: add(edge.from, edge.unit, place - edge.start), normal: edge.normal };
    };
    const nearest = (p) => {
      const feet = edges.map((edge) => {
        const along = Math.min(edge.size, Math.max(0, dot(add(p, edge.from, -1), edge.unit)));
        return { s: edge.start + along, away: length(add(p, add(edge.from, edge.unit, along), -1)) };
      });
      return feet.reduce((best, foot) => (foot.away < best.away ? foot : best)).s;
    };
    return { corners, total, turns: Math.sign(area), at, nearest, ...box(corners) };
  };

  const disk = (corners, centre, radius) => {
    const total = 2 * Math.PI * radius;
    const at = (s) => {
      const place = ((s % total) + total) % total, way = [Math.cos(place / radius), Math.sin(place / radius)];
      return { s: place, point: add(centre, way, radius), normal: [-way[0], -way[1]] };
    };
    const nearest = (p) => Math.atan2(p[1] - centre[1], p[0] - centre[0]) * radius;
    return { corners, total, turns: 1, at, nearest, ...box(corners) };
  };

  const of = (corners) => {
    const mean = [0, 1].map((k) => corners.reduce((sum, corner) => sum + corner[k], 0) / corners.length);
    const radii = corners.map((corner) => length(add(corner, mean, -1)));
    const [least, most] = [Math.min(...radii), Math.max(...radii)];
    const round = corners.length >= ROUND_FROM && most - least < ROUND_WITHIN * most;
    return round ? disk(corners, mean, (least + most) / 2) : polygon(corners);
  };

  // The box around several outlines.
  const around = (lines) => {
    const corners = lines.flatMap((line) => line.corners);
    return { corners, ...box(corners) };
  };

  return { of, around, add, dot, length };
})();
