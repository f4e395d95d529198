// What is set: where the fingers are, what they are like, and the load. From it comes the scene that the crate is asked.
const state = (() => {
  // So many times the load a path is followed to look for its end.
  const FAR = 1000;
  const SPRINGS = ["body_stiffness", "finger_stiffness", "series_stiffness"];
  // As many as the module answers.
  const MOST_FINGERS = 12;

  const now = {};

  const start = ({ id, title, teaching, scene }) => {
    const { contacts, outline: corners, questions } = scene.planar;
    const line = outline.of(corners);
    const { load } = questions.find((question) => question.solve).solve;
    Object.assign(now, {
      id, title, teaching, line,
      // The numbers of the file stay as they are until they are changed.
      fingers: contacts.map((given, k) => {
        const { point, normal, friction, command, pressed_with: pressed, name = `finger ${k + 1}`, ...rest } = given;
        return { name, rest, command, pressed, point, normal, s: line.nearest(point) };
      }),
      friction: contacts[0].friction, squeeze: 1, ratio: 1,
      load: { force: load.force, moment: load.moment || 0, at: load.at || [0, 0] },
    });
  };

  const springs = (rest) => {
    const scaled = { ...rest };
    for (const field of SPRINGS) {
      if (Array.isArray(rest[field])) scaled[field] = [rest[field][0], rest[field][1] * now.ratio];
    }
    return scaled;
  };

  const contact = ({ name, rest, command, pressed, point, normal }) => ({
    name, point, normal, ...springs(rest), friction: now.friction,
    ...(command && { command: command.map((a) => a * now.squeeze) }),
    ...(pressed && { pressed_with: pressed * now.squeeze }),
  });

  const scene = () => {
    const { force, moment, at } = now.load;
    const load = { force, moment, at };
    const far = { force: force.map((f) => f * FAR), moment: moment * FAR, at };
    const questions = [{ onset: { direction: load } }, { solve: { load } }, { follow: { legs: [{ load_by: far }] } }];
    return { format: "grasp-lcp/1", planar: { contacts: now.fingers.map(contact), outline: now.line.corners, questions } };
  };

  const place = (finger, s) => Object.assign(finger, now.line.at(s));

  // A finger like the last one, in the middle of the longest free part of the outline.
  const addFinger = () => {
    if (now.fingers.length === MOST_FINGERS) return;
    const places = now.fingers.map(({ s }) => now.line.at(s).s).sort((a, b) => a - b);
    const gaps = places.map((s, k) => [(places[k + 1] ?? places[0] + now.line.total) - s, s]);
    const [gap, s] = gaps.reduce((best, next) => (next[0] > best[0] ? next : best));
    const like = now.fingers[now.fingers.length - 1];
    now.fingers.push(place({ ...like, name: `finger ${now.fingers.length + 1}` }, s + gap / 2));
  };
  const removeFinger = () => {
    if (now.fingers.length > 1) now.fingers.pop();
  };

  const turnLoad = (angle) => {
    const size = outline.length(now.load.force);
    now.load.force = [size * Math.cos(angle), size * Math.sin(angle)];
  };
  const sizeLoad = (size) => {
    const before = outline.length(now.load.force);
    now.load.force = now.load.force.map((f) => (f * size) / before);
  };
  const angleOfLoad = () => Math.atan2(now.load.force[1], now.load.force[0]);

  return { now, FAR, start, scene, place, addFinger, removeFinger, turnLoad, sizeLoad, angleOfLoad };
})();
