//! How a path ends where the rates have no solution.

use nalgebra::SVector;

use super::beyond::{Beyond, just_beyond, whole_way};
use super::event::{Loss, PathEnd};
use super::segment::Segment;
use crate::contact::{LocalLaw, State, ZERO_SLACK};
use crate::forms::kinematic_form;
use crate::lcp::{self, Outcome, Proof};
use crate::object::{Piece, Problem};
use crate::proofs::{nothing_holds, separates_from_here_on, separating_motion};
use crate::search::{Doubt, Effort, Settings, Settled, settle};

/// Part of the whole load or of all commands, or of the leg where there is no load, that lies just beyond.
const A_LITTLE: f64 = 1e-6;
/// On the round cone that may be too little to tell: then a little more.
const PARTS_BEYOND: [f64; 3] = [A_LITTLE, 1e-4, 1e-2];
/// Where the equilibrium there has nearly the forces of the end, nearer: one on a path that goes on comes back to them, another does not.
const PARTS_NEARER: [f64; 2] = [1e-8, 1e-10];
/// Among more contacts on round cones a search in vain takes seconds.
const FEW_CONTACTS: usize = 8;
/// A proof for all loads from the end on is the clearer the further it looks: this part of the way.
const FURTHER: f64 = 1e-2;

/// The way that parts beyond the end are parts of: [`whole_way`], or the whole leg where there is no load yet. Parts of nothing would lead
/// no further than the end itself.
fn way_beyond<const D: usize, const C: usize>(here: &Problem<D, C>, rates: &Problem<D, C>) -> f64 {
    let way = whole_way(here, rates);
    if way > ZERO_SLACK { way } else { 1.0 }
}

/// The same where steps along a sliding arc of the round cone get ever shorter, which `ends` says is because the path ends.
pub(super) fn end_of_arc<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    ends: bool,
    motion: &SVector<f64, D>,
    forces: &[SVector<f64, C>],
    loss: Loss<D>,
    settings: &Settings,
) -> PathEnd<D, C> {
    let here = segment.problem_at(loss.fraction);
    if separates_from_here_on(&here, motion, &segment.direction) {
        return PathEnd::LimitLoad(loss);
    }
    beyond_on_the_round_cone(segment, ends, forces, loss, settings)
}

/// Whether forces are those of a path that goes on by this part: on a short way they change by the root of it at most.
fn is_near<const C: usize>(found: &[SVector<f64, C>], forces: &[SVector<f64, C>], part: f64) -> bool {
    let largest = forces.iter().map(nalgebra::Matrix::norm).fold(0.0, f64::max);
    let near = part.min(A_LITTLE).sqrt();
    found.iter().zip(forces).all(|(f, g)| (f - g).norm() <= near * largest)
}

/// What a solution from scratch says a little further on, with the slip so far.
fn beyond_on_the_round_cone<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    ends: bool,
    forces: &[SVector<f64, C>],
    loss: Loss<D>,
    settings: &Settings,
) -> PathEnd<D, C> {
    let here = segment.problem_at(loss.fraction);
    let rates = segment.rates(here.laws.clone());
    let past = |part: f64| segment.problem_at(loss.fraction + part * way_beyond(&here, &rates));
    // Some equilibrium, at a distance from the end that no path goes on so short a way.
    let another = |part: &f64| match settle(&past(*part), settings).0 {
        Settled::Found(found, _) => !is_near(&found.forces, forces, *part),
        _ => false,
    };
    let few = here.locals().filter(LocalLaw::may_slide).count() <= FEW_CONTACTS;
    for part in PARTS_BEYOND.into_iter().filter(|_| few) {
        match settle(&past(part), settings).0 {
            Settled::FreeMotion(_)
            | Settled::Separating(_)
            | Settled::NoneOf(_)
            | Settled::Contradicted { .. } => {
                return PathEnd::LimitLoad(loss);
            }
            // Where another equilibrium is no other the path was not lost, but could not be followed.
            Settled::Found(found, _)
                if ends && (!is_near(&found.forces, forces, part) || PARTS_NEARER.iter().any(another)) =>
            {
                return PathEnd::Snap(loss);
            }
            Settled::Undecided(_) => {}
            // An equilibrium close by: the path may go on to it.
            Settled::Found(..) => return loss.undecided(Doubt::OnTheBoundary),
        }
    }
    if ends { PathEnd::Ends(loss) } else { loss.undecided(Doubt::RayWithoutProof) }
}

/// Names the end of a path whose rates have no solution.
///
/// The object gives way where a motion meets no resistance. The load is a limit load if a motion proves that: the one with which the
/// object leaves, or one that separates a slightly larger load from all that friction can do. Else a search among all
/// combinations of states decides. Where these are too many, a proof for each choice of open contacts may do.
pub(super) fn end_of_path<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    rates: &Problem<D, C>,
    (settled, effort): (Settled<D, C>, &Effort),
    sliding: &[State<C>],
    forces: &[SVector<f64, C>],
    mut loss: Loss<D>,
    settings: &Settings,
) -> PathEnd<D, C> {
    if let Settled::FreeMotion(v) = settled {
        let motion = segment.grasp.outside(&v);
        return PathEnd::GivesWay { leg: loss.leg, fraction: loss.fraction, motion };
    }
    let here = segment.problem_at(loss.fraction);
    let motion = leaving_motion(rates, &here.wrench, sliding);
    loss.motion = motion.map(|v| segment.grasp.outside(&v));
    // A little further on, for what takes a finite distance to be seen.
    let past = segment.problem_at(loss.fraction + A_LITTLE * way_beyond(&here, rates));
    let separates = |v: &SVector<f64, D>| separates_from_here_on(&here, v, &rates.wrench);
    if motion.as_ref().is_some_and(separates) || separating_motion(&past).as_ref().is_some_and(separates) {
        return PathEnd::LimitLoad(loss);
    }
    if segment.problem.round {
        let ends = !matches!(settled, Settled::Undecided(_)) || no_rates(rates);
        return beyond_on_the_round_cone(segment, ends, forces, loss, settings);
    }
    // Among many contacts the ladder does not say so by itself.
    let settled = match settled {
        Settled::Undecided(_) if no_rates(rates) => Settled::NoneOf(0),
        settled => settled,
    };
    let beyond = just_beyond(segment.grasp, &here, rates, settled, effort, settings, segment.cone);
    if matches!(beyond, Beyond::Ends(_))
        && nothing_holds(&here, &segment.problem_at(loss.fraction + FURTHER * way_beyond(&here, rates)))
    {
        return PathEnd::LimitLoad(loss);
    }
    PathEnd::from_beyond(&beyond, loss)
}

/// Whether Farkas' lemma proves that no slips and gaps make the rates possible: then there are no rates at all.
fn no_rates<const D: usize, const C: usize>(rates: &Problem<D, C>) -> bool {
    let trial = Piece::new(rates, &rates.unjumped());
    let Ok(state) = trial.solve(rates.sites, &rates.drives, &rates.wrench) else { return false };
    let settings = lcp::Settings { enumerate_up_to: 0, ..lcp::Settings::default() };
    kinematic_form(rates, &trial, &state).is_some_and(|form| {
        matches!(form.lcp.solve_with(&settings), Outcome::Ray(ray) if matches!(ray.proof, Proof::Infeasible(_)))
    })
}

/// The unit motion with which the object leaves when everything that stands on an edge slides.
///
/// It is a motion that nothing resists then and on which the load works. Where there is none it is the motion of the rates in these
/// states. Their forces balance the load, but their slips are against friction: the motion taken the other way is along it.
pub(super) fn leaving_motion<const D: usize, const C: usize>(
    rates: &Problem<D, C>,
    load: &SVector<f64, D>,
    states: &[State<C>],
) -> Option<SVector<f64, D>> {
    let piece = Piece::new(rates, states);
    let solved = match piece.solve(rates.sites, &rates.drives, &rates.wrench) {
        Err(unbalanced) => {
            // Where friction is exhausted no spring resists, but the friction forces feel the motion. Where only commands
            // change it is the load itself that drives the object out.
            let along = |wrench: &SVector<f64, D>| {
                let v = piece.free_motions().iter().fold(SVector::zeros(), |sum, v| sum + v * v.dot(wrench));
                (v.norm() > 0.0).then(|| v.normalize())
            };
            return unbalanced.motion.or_else(|| along(&rates.wrench)).or_else(|| along(load));
        }
        Ok(solved) => solved,
    };
    let mut along_friction = 0.0;
    for (i, state) in states.iter().enumerate() {
        let local = rates.local(i);
        if let Some(outward) = local.outward(state) {
            let slip = local.springs.slip(&rates.stretch(i, &solved.twist), &solved.forces[i]);
            along_friction += outward.dot(&slip);
        }
    }
    let size = solved.twist.norm();
    (size > 0.0).then(|| solved.twist * (1.0_f64.copysign(along_friction) / size))
}
