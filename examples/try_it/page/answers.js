// What the page takes from the answers, in the order of the questions of `state`.
const answers = (() => {
  const of = (reply) => {
    if (reply.error) {
      const { field, message } = reply.error;
      return { refused: field ? `${field}: ${message}` : message };
    }
    const [{ onset }, { solve }, { follow: path }] = reply.answers;
    return { onset, solve, path, warnings: reply.warnings || [], held: solve.outcome === "equilibrium" ? solve : null };
  };

  // The factor of the load at which the path from rest ends, if it does.
  const limit = ({ path }) => (path.outcome === "lost" ? path.fraction * state.FAR : null);

  // Where the first contact leaves, if it does.
  const onset = ({ onset: { outcome, factor } }) => (outcome === "at" ? factor : null);

  return { of, limit, onset };
})();
