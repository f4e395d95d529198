// From metres to pixels and back, and how long the arrow of a force is.
const view = (() => {
  // Parts of the smaller side of the picture.
  const OBJECT = 0.5, ARROW = 0.34;

  const of = (width, height, { line, load }) => {
    const scale = (OBJECT * Math.min(width, height)) / line.size;
    const pixel = ([x, y]) => [width / 2 + scale * (x - line.middle[0]), height / 2 - scale * (y - line.middle[1])];
    const metre = ([x, y]) => [line.middle[0] + (x - width / 2) / scale, line.middle[1] - (y - height / 2) / scale];
    // A direction: y is down on the screen.
    const along = ([x, y], size = 1) => [x * size, -y * size];
    return { width, height, scale, pixel, metre, along, longest: ARROW * Math.min(width, height), load };
  };

  // Pixels a newton, in round steps, so that an arrow grows while a force does.
  const forceScale = ({ longest }, forces) => {
    const most = Math.max(...forces.map(outline.length));
    return most > 0 ? longest / numbers.roundUp(most) : 0;
  };

  return { of, forceScale };
})();
