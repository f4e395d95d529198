//! A grasp with a given amount of squeeze, friction, load or another quantity set, and its equilibrium under the load that uses most of its friction.

use super::checked_need::{SafetyDeviations, Sought};
use super::loading::{Loading, force_at};
use super::question::Need;
use crate::ask::Grasp;
use crate::equilibrium::{ContactState, Equilibrium};
use crate::error::Error;
use crate::grasp::{inside, outside};
use crate::load_path::{Leg, Ramp};
use crate::numerics::{IntoList, largest, tried};
use crate::prelude::*;
use crate::squeeze::{Loads, WeakestDirection};

impl<const C: usize> Grasp<C> {
    /// A copy of this grasp in which the sought quantity of `need` has the value `amount`, and an equilibrium of this copy. Among the loads of `need`
    /// it is the equilibrium under the load with which a contact uses the largest fraction of its friction.
    ///
    /// The amount is in the unit of the sought [`Quantity`](super::Quantity); it may be the [`Amount::bound`](super::Amount::bound) of an answer. The
    /// use of friction is the largest `|f_t| / (|f_t| + margin)` of closed contacts, with the friction force f_t and the friction margin
    /// `μ f_n - |f_t|`. The rotation of a load that turns is divided into 180 equal steps, and the equilibria at both ends of every step are
    /// compared. If an angle is sought, the load turns by the angle `amount`, and the equilibrium at this angle is returned. `None` if no load is
    /// held.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Pressed with 25 N in place of 10 N each, two jaws carry 25 N.
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e4, 8e3).friction(0.5).pressed_with(10.0);
    /// let need = Need::squeeze(Wrench::force([0.0, -24.0]));
    /// let (squeezed, state) = Grasp::new([jaw(-0.03), jaw(0.03)])?.with_amount(&need, 2.5)?.expect("it holds");
    /// assert!((state.contacts[0].normal_force() - 25.0).abs() < 1e-12 && squeezed.hold(state.load)?.sticks() == Some(true));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite or beyond 1e50. [`Error::Question`] if a field is missing or belongs to another quantity.
    /// [`Error::Argument`] for a number out of range, and for a contact that does not exist. [`Error::Part`] if no part with the given name presses.
    pub fn with_amount(&self, need: &Need<C>, amount: f64) -> Result<Option<(Self, Equilibrium<C>)>, Error> {
        inside(need).set_on(&inside(self), amount).map(|set| set.map(outside))
    }
}

impl Need<3> {
    /// Returns a copy of the grasp `given` in which the sought quantity has the value `amount`. Also returns the equilibrium of this copy under that
    /// load of the question which makes a contact use the largest fraction of its friction. `None` if no load is held.
    fn set_on(&self, given: &Grasp<3>, amount: f64) -> Result<Option<(Grasp<3>, Equilibrium<3>)>, Error> {
        let grown = self.growing(given)?;
        let posed = self.posed(given.space())?.on(&grown)?;
        let loading = Loading::of(&grown, &posed, amount, SafetyDeviations::NONE)?;
        let Loading { loads, times, grasp, base: besides, .. } = &loading;
        let put_on = |ramp: Ramp<3>| Ok::<_, Error>(grasp.hold(ramp)?.state.map(|state| *state));
        let states: Vec<Option<Equilibrium<3>>> = match loads {
            Loads::Each(list) => tried(list, &|load| put_on(Ramp::load(*besides, *load * *times)))?,
            Loads::AnyForce { base, size, point } => {
                let base = *besides + *base * *times;
                // `most` is the magnitude of the least force, in the weakest direction, that makes a contact slide. The factor `part` scales this
                // force to the magnitude `size · times`. Here `size` is given in the question, and `times` is the amount if a multiple of the load is
                // sought, else 1.
                let part = |most: f64| size * times / most;
                let load = match grasp.weakest_direction(base, *point)? {
                    WeakestDirection::Force { load, size: most, .. } if most > 0.0 => {
                        (load - base) * part(most)
                    }
                    _ => force_at([0.0; 3], *point),
                };
                vec![put_on(Ramp::load(base, load))?]
            }
            Loads::Turn(turn) => {
                let turn = loading.multiplied_turn(turn);
                let mut path = grasp.follow(turn.load_at(0.0), &[Leg::turn(&turn)])?;
                path.run();
                // If an angle is sought, the load turns by the angle `amount`, and the equilibrium at this angle is returned.
                if matches!(posed.sought, Sought::Angle { .. }) {
                    return Ok(path.state().map(|state| (grasp.with(given.settings()), state)));
                }
                // The rotation of the load is divided into 180 steps, each of which costs an equilibrium. Fewer steps could miss the angle at which
                // most friction is used.
                let on_the_way = (0..180_u32).map(|k| path.state_at(0, f64::from(k) / 180.0));
                on_the_way.chain([path.state()]).list()
            }
        };
        let fullest = states.into_iter().flatten().max_by(|a, b| used(a).total_cmp(&used(b)));
        Ok(fullest.map(|state| (grasp.with(given.settings()), state)))
    }
}

/// The largest fraction of its friction that a closed contact uses: `|f_t| / (|f_t| + margin)`.
fn used(state: &Equilibrium<3>) -> f64 {
    largest(&state.contacts, &|answer| {
        let (friction, left) = (answer.friction_force(), answer.margin.max(0.0));
        let rubs = answer.state != ContactState::Separated && friction > 0.0;
        if rubs { friction / (friction + left) } else { 0.0 }
    })
}
