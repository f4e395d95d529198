// The crate, compiled to WebAssembly: the text of a scene goes in, the text of the answers comes out.
const asking = (() => {
  // The clock of a browser is coarse, so that times are means over the last answers.
  const MEAN_OVER = 20;

  let compiled, module;
  const times = [];

  const begin = async () => {
    const letters = atob(document.getElementById("module").textContent.trim());
    const packed = new Blob([Uint8Array.from(letters, (letter) => letter.charCodeAt(0))]);
    const unpacked = packed.stream().pipeThrough(new DecompressionStream("gzip"));
    compiled = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
    module = await WebAssembly.instantiate(compiled, {});
  };

  const exchange = (text) => {
    const { memory, room, answer, text: place } = module.exports;
    // A call may let the memory grow, which takes its buffer away: places come first, then the buffer of that moment.
    const bytes = new TextEncoder().encode(text), into = room(bytes.length);
    new Uint8Array(memory.buffer, into, bytes.length).set(bytes);
    const length = answer(), from = place();
    return new TextDecoder().decode(new Uint8Array(memory.buffer, from, length));
  };

  const ask = (scene) => {
    const text = JSON.stringify(scene);
    const before = performance.now();
    let reply;
    try {
      reply = JSON.parse(exchange(text));
    } catch (error) {
      // A module that has stopped is in no known state: the next question goes to a new one.
      module = new WebAssembly.Instance(compiled, {});
      reply = { error: { kind: "internal", message: `The module stopped: ${error.message}.` } };
    }
    times.push(performance.now() - before);
    if (times.length > MEAN_OVER) times.shift();
    return reply;
  };

  // Mean time of an answer, ms, from text to text and read.
  const time = () => times.reduce((sum, t) => sum + t, 0) / times.length;

  return { begin, ask, time };
})();
