//! A load that turns: while states last, forces and gaps turn with it, and the first way out is a root of a trigonometric polynomial.

use nalgebra::SVector;

use super::segment::{Segment, Standing};
use super::turn::{InsideTurn, Touch};
use crate::contact::{Exit, State, TurningExit, Wave};
use crate::object::{Piece, PieceState, Unbalanced};

/// What happens first to the contacts while a load turns.
pub(super) struct FirstOnTurn<const C: usize> {
    /// The angle from the beginning on, and everything that reaches an edge there.
    pub(super) exits: Option<(f64, Standing<C>)>,
    /// What is only touched before.
    pub(super) touches: Vec<Touch>,
}

impl<const C: usize> FirstOnTurn<C> {
    /// Of what all contacts do.
    pub(super) fn of(ways: Vec<(usize, Vec<TurningExit<C>>)>) -> Self {
        let leaving = |exit: &TurningExit<C>| match exit {
            TurningExit::Leaves(exit) => Some(*exit),
            TurningExit::Touches(_) => None,
        };
        let all = ways.iter().flat_map(|(_, exits)| exits.iter().filter_map(leaving));
        let first = all.min_by(|a, b| a.step.total_cmp(&b.step));
        let end = first.map_or(f64::INFINITY, |first| first.step);
        let mut touches = Vec::new();
        let mut standing = Vec::new();
        for (contact, exits) in ways {
            touches.extend(exits.iter().filter_map(|exit| match exit {
                TurningExit::Touches(angle) if *angle < end => Some(Touch { contact, angle: *angle }),
                _ => None,
            }));
            // Symmetric grasps reach several edges at once: equal up to the rounding of both.
            let tied = |exit: &Exit<C>| {
                first.is_some_and(|first| exit.step - first.step <= exit.uncertainty + first.uncertainty)
            };
            let together: Vec<_> = exits.iter().filter_map(leaving).filter(tied).collect();
            if !together.is_empty() {
                standing.push((contact, together));
            }
        }
        Self { exits: first.map(|first| (first.step, standing)), touches }
    }
}

impl<const D: usize, const C: usize> Segment<'_, D, C> {
    /// Puts the beginning of a turn in the place of the present load, and its rate in that of the present direction.
    pub(super) fn turn_to(&mut self, turn: &InsideTurn<D>) {
        [self.problem.wrench, self.direction] = turn.load_and_rate();
        self.problem.wrench_rest = SVector::zeros();
    }

    /// What contacts do first in these states while the load turns by this angle at most.
    pub(super) fn first_on_turn(
        &self,
        states: &[State<C>],
        piece: &Piece<D, C>,
        turn: &InsideTurn<D>,
        angle: f64,
    ) -> Result<FirstOnTurn<C>, Unbalanced<D>> {
        let sites = self.problem.sites;
        let at_rest = vec![SVector::zeros(); sites.len()];
        let solved = |drives: &[SVector<f64, C>], load: &SVector<f64, D>| piece.solve(sites, drives, load);
        let parts = [
            solved(&self.problem.drives, &turn.constant)?,
            solved(&at_rest, &turn.cosine)?,
            solved(&at_rest, &turn.sine)?,
        ];
        let waves = self.waves(turn, &parts);
        let exits = self
            .problem
            .locals()
            .zip(states)
            .zip(&waves)
            .map(|((local, state), [force, gap])| local.turning_exits(state, [force, gap], angle));
        Ok(FirstOnTurn::of(exits.enumerate().collect()))
    }

    /// The waves of force and gap of every contact. The parts are the states under the three loads, the first with the drives.
    pub(super) fn waves(&self, turn: &InsideTurn<D>, parts: &[PieceState<D, C>; 3]) -> Vec<[Wave<C>; 2]> {
        let (sites, problem) = (self.problem.sites, &self.problem);
        let at_rest = vec![SVector::zeros(); sites.len()];
        let drives = [&problem.drives, &at_rest, &at_rest];
        let loads = [turn.constant, turn.cosine, turn.sine];
        let sizes: [_; 3] =
            std::array::from_fn(|k| problem.force_sizes(drives[k], loads[k].norm(), &parts[k]));
        let wave = |i: usize| {
            let site = &sites[i];
            let [constant, cosine, sine] = std::array::from_fn(|k| parts[k].forces[i]);
            let force = Wave { constant, cosine, sine, size: sizes.iter().map(|sizes| sizes[i]).sum() };
            let [constant, cosine, sine] =
                std::array::from_fn(|k| -site.stretch(&drives[k][i], &parts[k].twist));
            // Drives count from the slip so far, and have its rounding where they cancel.
            let spans = drives.iter().zip(parts).map(|(drives, part)| site.span(&drives[i], &part.twist));
            let gap = Wave { constant, cosine, sine, size: problem.slips[i].norm() + spans.sum::<f64>() };
            [force, gap]
        };
        (0..sites.len()).map(wave).collect()
    }
}
