// Converts metres to pixels and back, and finds the scale of force arrows.
const view = (() => {
  // Size of the object, and longest arrow of a force, relative to the smaller side of the picture.
  const OBJECT = 0.5, ARROW = 0.34;

  const of = (width, height, { line, load }) => {
    const scale = (OBJECT * Math.min(width, height)) / line.size;
    const pixel = ([x, y]) => [width / 2 + scale * (x - line.middle[0]), height / 2 - scale * (y - line.middle[1])];
    const metre = ([x, y]) => [line.middle[0] + (x - width / 2) / scale, line.middle[1] - (y - height / 2) / scale];
    // Converts a direction: y points down on the screen.
    const along = ([x, y], size = 1) => [x * size, -y * size];
    return { width, height, scale, pixel, metre, along, longest: ARROW * Math.min(width, height), load };
  };

  // Pixels per newton. It changes in round steps, so that an arrow grows visibly with its force.
  const forceScale = ({ longest }, forces) => {
    const most = Math.max(...forces.map(outline.length));
    return most > 0 ? longest / numbers.roundUp(most) : 0;
  };

  return { of, forceScale };
})();
