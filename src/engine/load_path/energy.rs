//! The energy balance of each leg of a load path: works, stored energy and heat. A leg is a section of the load program. A piece is a part of a leg
//! on which all contacts keep their states (open, sticking or sliding).

use nalgebra::SVector;

use super::segment::{PathPoint, Segment};
use super::turning_state::TurningState;
use crate::contact::State;
use crate::grasp::Site;
use crate::numerics::{Each, Harmonic, mapped};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// Energies of one leg, J: `load_work + finger_work = stored + dissipated`. If no contact slides on the round cone, forces and motions on each piece
/// of the path are affine in the fraction of the leg that is done. Under a load that turns they are harmonics of its angle. In both cases every
/// integral is exact. If contacts slide on the round cone, works are integrated along with the slips.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct LegEnergy {
    /// Work of the load W along the motion q of the object, `∫ W·dq`.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub load_work: f64,
    /// Work that the commands of the fingers do, `Σ ∫ F·du_f` with the contact forces F and the finger displacements u_f, positive if a finger pushes
    /// forward.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub finger_work: f64,
    /// Change of the energy stored in the springs, `Δ Σ ½ F²/k`.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub stored: f64,
    /// Heat from friction, `Σ ∫ F_t·ds` with the friction forces F_t and the slips s, plus the energy lost in [jumps](super::Jump). It is never
    /// negative.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub dissipated: f64,
    /// Sum of the absolute values of all works, stored energies and heats of all pieces and contacts, J. Works of opposite signs cancel in the
    /// balance, so its rounding error is proportional to this sum. If directions of sliding turn on the round cone, the stored energies before and
    /// after each step are summands, because their change is computed as a difference. Not serialised.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub turnover: f64,
}

impl LegEnergy {
    /// `(load_work + finger_work - stored - dissipated) / turnover`: zero in exact arithmetic. Returns 0 if `turnover` is zero.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let excess = self.load_work + self.finger_work - self.stored - self.dissipated;
        if self.turnover > 0.0 { excess / self.turnover } else { 0.0 }
    }

    /// Adds the energy that the springs take up while the contact forces change from `from` to `to`.
    pub(super) fn store(&mut self, sites: &[Site], from: &[SVector<f64, 3>], to: &[SVector<f64, 3>]) {
        for (site, (from, to)) in sites.iter().zip(from.iter().zip(to)) {
            self.stored += 0.5 * (to - from).dot(&site.springs.deflection(&(to + from)));
            // The change of energy is a difference, so that its rounding error is proportional to both energies.
            self.turnover += site.springs.stored(to) + site.springs.stored(from);
        }
    }

    /// Adds the energies `part` of another part of the same leg.
    pub(super) fn add_part(&mut self, part: &Self) {
        self.load_work += part.load_work;
        self.finger_work += part.finger_work;
        self.stored += part.stored;
        self.dissipated += part.dissipated;
        self.turnover += part.turnover;
    }

    /// Adds the energies of a piece of the path on which the fraction of the leg changes from `factor` by `step`. On this piece contacts keep their
    /// states, and no contact slides on a round cone. `point` is the path point at the beginning of the piece: forces and twist, with their rates.
    pub(super) fn add(
        &mut self,
        segment: &Segment,
        states: &[State],
        point: &PathPoint,
        factor: f64,
        step: f64,
    ) {
        if let Some(turned) = &point.turned {
            self.add_turned(segment, states, turned, step);
            return;
        }
        let middle = segment.trajectory.at(factor + 0.5 * step);
        let works = middle.component_mul(&point.twist_rate) * step;
        self.load_work += works.sum();
        self.turnover += works.map(f64::abs).sum();
        for (i, (line, site)) in point.lines.iter().zip(segment.grasp.sites()).enumerate() {
            let force = line.force + line.rate * (0.5 * step);
            let (give, moving) =
                (site.springs.deflection(&line.rate), site.stretch(&segment.change[i], &point.twist_rate));
            let slip =
                if states[i].slides() { site.springs.slip(&moving, &line.rate) } else { SVector::zeros() };
            for axis in 0..site.springs.axes() {
                let pushed = force[axis] * segment.change[i][axis] * step;
                // The spring energy changes by `Δ(½F²/k) = F ΔF / k`, which is exact with the force F at the middle of the piece and the
                // stiffness k.
                let stored = force[axis] * give[axis] * step;
                let dissipated = force[axis] * slip[axis] * step;
                self.finger_work += pushed;
                self.stored += stored;
                self.dissipated += dissipated;
                self.turnover += pushed.abs() + stored.abs() + dissipated.abs();
            }
        }
    }

    /// Adds the energies of a piece of the path along which the load turns, so that forces and motions are harmonic functions of the load's angle.
    /// `step` is the change of the fraction of the leg along the piece.
    fn add_turned(&mut self, segment: &Segment, states: &[State], turned: &TurningState, step: f64) {
        let angle = turned.angle * step;
        for k in 0..segment.grasp.size().count() {
            let work = turned.load.map(|load| load[k]).work_on(&turned.twist.map(|twist| twist[k]), angle);
            self.load_work += work;
            self.turnover += work.abs();
        }
        let sites = segment.grasp.sites();
        let [before, after] =
            [0.0, angle].each(|angle| mapped(&turned.waves, &|[force, _]| force.of.at(angle)));
        self.store(sites, &before, &after);
        for ((site, [force, stretch]), _) in
            sites.iter().zip(&turned.waves).zip(states).filter(|(_, state)| state.slides())
        {
            let slip = Harmonic {
                constant: SVector::zeros(),
                cosine: site.springs.slip(&stretch.of.cosine, &force.of.cosine),
                sine: site.springs.slip(&stretch.of.sine, &force.of.sine),
            };
            for axis in 1..3 {
                let dissipated = force
                    .of
                    .map(|force| force[axis])
                    .work_on(&slip.map(|slip: &SVector<f64, 3>| slip[axis]), angle);
                self.dissipated += dissipated;
                self.turnover += dissipated.abs();
            }
        }
    }
}
