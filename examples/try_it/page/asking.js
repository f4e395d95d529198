// Calls the crate, compiled to WebAssembly, with the text of a scene, and returns its answers.
const asking = (() => {
  // The clock of a browser is coarse. Run times are means over this number of answers.
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
    // A call may grow the memory, which invalidates `memory.buffer`. So first call for the address, then read `memory.buffer`.
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
      // The state of a module that has stopped is unknown: the next question uses a new instance.
      module = new WebAssembly.Instance(compiled, {});
      reply = { error: { kind: "internal", message: `The module stopped: ${error.message}.` } };
    }
    times.push(performance.now() - before);
    if (times.length > MEAN_OVER) times.shift();
    return reply;
  };

  // Mean run time of an answer, ms, with writing and reading of JSON.
  const time = () => times.reduce((sum, t) => sum + t, 0) / times.length;

  return { begin, ask, time };
})();
