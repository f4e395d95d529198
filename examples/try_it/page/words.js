// Sentences for the answers.
const words = (() => {
  const STATES = { sticking: "sticks", sliding: "slides", separated: "open", frictionless: "slides freely" };
  const DOUBTS = {
    ray_without_proof: "the bounded search of this page found neither an equilibrium nor a proof that there is none",
    on_the_boundary: "the load is on the edge of what the grasp holds, as far as rounding can tell",
    inaccurate: "the numbers lie too far apart to be told accurately",
    out_of_pivots: "the bounded search of this page came to its end",
    out_of_steps: "the bounded search of this page came to its end",
  };
  const doubt = (name) => DOUBTS[name] || name.replaceAll("_", " ");

  const proof = (reason) =>
    ({
      free_motion: "Nothing resists one motion of the object, and the load drives it.",
      separating_motion: "The load drives a motion that no force of the fingers could oppose.",
      every_state_tried: `Every combination of sticking, sliding and open fingers (${reason.combinations}) contradicts itself.`,
      every_case_contradicted: `Every case (${reason.cases}) contradicts itself.`,
    })[reason.proof] || reason.proof;

  const listed = (names) => (names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names[names.length - 1]}`);

  const stands = ({ contacts }) => {
    const which = (wanted) => contacts.filter(({ state }) => wanted.includes(state)).map(({ name }) => name);
    const [slide, open] = [which(["sliding", "frictionless"]), which(["separated"])];
    const parts = [];
    if (slide.length > 0) parts.push(`${listed(slide)} ${slide.length > 1 ? "slide" : "slides"}`);
    if (open.length > 0) parts.push(`${listed(open)} ${open.length > 1 ? "are" : "is"} open`);
    return parts.length === 0 ? "every finger sticks" : parts.join("; ");
  };

  // [class, headline, explanation]
  const verdict = (found) => {
    if (found.refused) return ["none", "No answer to this scene.", found.refused];
    const { solve } = found;
    if (solve.outcome === "no_equilibrium") return ["none", "No equilibrium under this load.", proof(solve)];
    if (solve.outcome === "undecided") return ["doubt", "Undecided.", `Undecided: ${doubt(solve.doubt)}.`];
    const limit = answers.limit(found);
    const other = limit !== null && limit < 1
      ? "The path from rest has ended before this load: what is shown is another equilibrium, to which no slow growth of the load leads."
      : "";
    const holds = stands(solve);
    return [holds === "every finger sticks" ? "holds" : "slides", `It holds: ${holds}.`, other];
  };

  const leaving = (list) => {
    const named = (how) => list.filter((one) => one.how === how).map(({ name }) => name);
    const [slide, open] = [named("slides"), named("opens")];
    const parts = [];
    if (slide.length > 0) parts.push(`${listed(slide)} ${slide.length > 1 ? "slide" : "slides"}`);
    if (open.length > 0) parts.push(`${listed(open)} ${open.length > 1 ? "open" : "opens"}`);
    return parts.join("; ");
  };

  const beyond = ({ what, reason, doubt: why }) =>
    ({
      continues: "It holds on beyond.",
      limit_load: "No equilibrium exists just beyond.",
      snap: "The object then snaps away; another equilibrium exists beyond.",
      ends: "This equilibrium ends there; whether another exists was not settled.",
      undecided: `What lies beyond is undecided: ${doubt(why || "")}.`,
    })[what] || (reason ? proof(reason) : what);

  return { STATES, verdict, proof, doubt, leaving, beyond };
})();
