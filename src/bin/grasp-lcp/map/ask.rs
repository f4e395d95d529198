//! The question for one direction of a map, and its answer: at which force in this direction first slip occurs. First slip is the event at which the
//! first contact ceases to stick. The base load of a map is a constant load that acts in addition to this force.

use grasp_lcp::Error;
use grasp_lcp::load_path::{DepartingContact, Onset, Ramp};
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::squeeze::WeakestDirection;
use grasp_lcp::words::Words;
use grasp_lcp::{ask::Grasp, grasp::Wrench};

use crate::failure::Failure;
use crate::scene_loads::first_base;

/// The constant load that acts in addition to the force of the map. It is the constant load (base load or load at the start) of the scene's first
/// question that has one, else zero. If questions have different constant loads, a warning names the question whose load is taken.
pub(crate) fn base<const C: usize>(setup: &Setup<C>) -> Wrench<C> {
    let Some((number, base)) = first_base(setup) else { return Wrench::ZERO };
    if setup.questions.iter().filter_map(Question::base).any(|other| other != base) {
        let load = Words::default().load(&base);
        eprintln!(
            "warning: questions of the scene have different loads at rest: the map takes that of question {number}, {load}"
        );
    }
    base
}

/// The first slip under a force that grows in one direction of the map.
pub(crate) struct FirstSlipForce {
    /// The force at first slip, or at which the grasp gives way (nothing resists more of it), N; infinite if no contact ever slips, NaN if unknown.
    pub(crate) force: f64,
    /// The contacts that stop sticking and how (slide, open), in words; or the reason why there is no first slip.
    pub(crate) contacts: String,
}

impl FirstSlipForce {
    fn without_contact(force: f64, contacts: &str) -> Self {
        Self { force, contacts: contacts.to_owned() }
    }
}

/// The direction of the least force at first slip, and that force, N. `None` if no force makes a contact slip, or if a contact slides or is open
/// under the base load.
pub(crate) fn weakest<const C: usize>(
    grasp: &Grasp<C>,
    base: &Wrench<C>,
    at: [f64; C],
) -> Result<Option<([f64; C], f64)>, Error> {
    Ok(match grasp.weakest_direction(base, at)? {
        WeakestDirection::Force { size, direction, .. } => Some((direction, size)),
        _ => None,
    })
}

/// A copy of the grasp for questions in many directions. To save time, its questions never enumerate combinations of contact states.
pub(crate) fn quick<const C: usize>(grasp: &Grasp<C>) -> Grasp<C> {
    grasp.with(&grasp.settings().with_most_states(0))
}

/// The first slip while the load grows along a ramp, i.e. from a base load in a fixed direction.
pub(crate) fn first<const C: usize>(grasp: &Grasp<C>, ramp: &Ramp<C>) -> Result<FirstSlipForce, Error> {
    Ok(match grasp.onset(ramp)? {
        Onset::At(event) => {
            let mut verbs: Vec<_> = event.leaving.iter().map(DepartingContact::verb).collect();
            verbs.sort_unstable();
            verbs.dedup();
            // The points of a soft fingertip that stop sticking count as one contact.
            let contacts = verbs.into_iter().rev().flat_map(|verb| {
                let does = |i: usize| {
                    event.leaving.iter().any(|left| left.contact.index == i && left.verb() == verb)
                };
                grasp.whole_contacts(does).into_iter().map(move |part| format!("{part} {verb}"))
            });
            let drives = event.drives.iter().map(|drive| format!("{} gives way", drive.part.text()));
            let mut contacts: Vec<_> = contacts.chain(drives).collect();
            // If more than four contacts stop sticking, only the first is named and the others are counted.
            if contacts.len() > 4 {
                let others = contacts.len() - 1;
                contacts = vec![format!("{} and {others} others", contacts[0])];
            }
            FirstSlipForce { force: event.factor, contacts: contacts.join(", ") }
        }
        Onset::Never => FirstSlipForce::without_contact(f64::INFINITY, "never"),
        Onset::GivesWay { factor, .. } => FirstSlipForce::without_contact(factor, "nothing resists"),
        _ => FirstSlipForce::without_contact(f64::NAN, "not known"),
    })
}

/// Fails with the reason if no sticking equilibrium exists under the base load, since then no direction has a first slip.
pub(crate) fn check_base<const C: usize>(grasp: &Grasp<C>, ramp: &Ramp<C>) -> Result<(), Failure> {
    match grasp.onset(ramp)? {
        Onset::NoBase(none) => {
            Err(Failure::Scene(format!("no equilibrium exists under the base load: {}", none.proof)))
        }
        Onset::AlreadySliding(_) => Err(Failure::Scene(
            "something slides already under the base load: there is no onset to map".to_owned(),
        )),
        Onset::Undecided(undecided) => Err(Failure::Scene(format!(
            "the equilibrium under the base load is undecided: {}",
            undecided.doubt
        ))),
        _ => Ok(()),
    }
}

/// The warning text if the grasp buckles, or rotations or slips are too large for the first-order model, under the base load alone.
pub(crate) fn caution<const C: usize>(grasp: &Grasp<C>, base: &Wrench<C>) -> Option<String> {
    let says = grasp.solve(base).ok()?.equilibrium()?.caution(Words::default())?;
    Some(format!("CAUTION, at rest already {says}"))
}

/// Lines of text for the picture: the point of the force, the constant load, loads that bodies always have, and the warning of [`caution`], if any.
pub(crate) fn words<const C: usize>(
    setup: &Setup<C>,
    at: [f64; C],
    base: &Wrench<C>,
    caution: Option<String>,
) -> Vec<String> {
    let point = at.map(|x| x.to_string()).join(", ");
    let mut lines = vec![format!("Force at ({point}) m")];
    let weighs = setup.bodies.iter().any(|body| body.mass > 0.0) && setup.gravity.is_some();
    let bodies = weighs || setup.bodies.iter().any(|body| body.load != Wrench::ZERO);
    let base = (*base != Wrench::ZERO).then(|| Words::default().load(base));
    let below: Vec<_> =
        base.into_iter().chain(bodies.then(|| "the loads of the bodies".to_owned())).collect();
    let on_top = format!("on top of {}", below.join(" and "));
    lines.push(if below.is_empty() { "no other load".to_owned() } else { on_top });
    lines.extend(caution);
    lines
}

/// The error if a map takes too long.
pub(crate) fn too_long() -> Failure {
    Failure::Scene("a map of so many contacts takes more than five minutes".to_owned())
}
