// Extracts quantities for the page from the answers, which are in the order of the questions in `state`.
const answers = (() => {
  const of = (reply) => {
    if (reply.error) {
      const { field, message } = reply.error;
      return { refused: field ? `${field}: ${message}` : message };
    }
    const [{ onset }, { solve }, { follow: path }] = reply.answers;
    return { onset, solve, path, warnings: reply.warnings || [], held: solve.outcome === "equilibrium" ? solve : null };
  };

  // Factor of the load at which the path from rest ends; null if it does not end.
  const limit = ({ path }) => (path.outcome === "lost" ? path.fraction * state.FAR : null);

  // Factor of the load at which the first contact leaves; null if no contact leaves.
  const onset = ({ onset: { outcome, factor } }) => (outcome === "at" ? factor : null);

  return { of, limit, onset };
})();
