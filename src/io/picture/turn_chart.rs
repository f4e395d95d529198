//! Charts of the friction force of each contact, as a fraction of its limit μ F_n, while the load turns, grows, or follows a program. On a ramp the
//! load, or commands, grow in proportion to the load factor. A command is the displacement that a finger would make if the object were absent.

use super::chart::Chart;
use super::friction_chart::DrawnProgram;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::{Leg, Ramp, Turn};

/// A chart of `|F_t| / (μ F_n)` of each contact against the angle, along the path under a turning load. The path begins at angle 0 and ends at the
/// angle of the turn, or at the angle at which equilibrium is lost. The first contact that stops sticking and the end are marked. A [soft
/// fingertip](crate::grasp::SoftFingertip) counts as one contact, with the sums of |F_t| and of μ F_n over its points; their ratio is 1 if all points
/// slide. A note names the contacts without a curve: contacts that never touch, have no friction or infinite friction, or are glued. If there are
/// more than sixteen curves, the note also names the contacts that use least friction and are not drawn.
///
/// ```
/// use grasp_lcp::picture::chart_of_turn;
/// use grasp_lcp::planar::{Contact, Grasp, Turn};
///
/// // A tray of 4 N between two palms that press with 10 N each, tilted until it slides.
/// let palm = |name: &str, y: f64| {
///     Contact::new([0.0, 0.01 * y], [0.0, -y]).name(name).series_stiffness(1e3, 8e2).friction(0.125).pressed_with(10.0)
/// };
/// let palms = Grasp::new([palm("below", -1.0), palm("above", 1.0)])?;
/// let turn = Turn::tilting([0.0, -4.0], [0.0, 0.0]);
/// let svg = chart_of_turn(&palms, &turn, "A tray")?.to_svg()?;
/// assert!(svg.contains("lost: above on the edge") && svg.contains("angle (degrees)"));
/// // A tray that falls from the start on has no curve.
/// let heavy = Turn::tilting([40.0, 0.0], [0.0, 0.0]);
/// assert!(chart_of_turn(&palms, &heavy, "A tray")?.to_svg().is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::Wrench`] if a load of the turn is not finite or beyond 1e50; [`Error::Argument`] unless its angle is more than zero and at most 1e6 rad.
pub fn chart_of_turn<const C: usize>(grasp: &Grasp<C>, turn: &Turn<C>, title: &str) -> Result<Chart, Error> {
    let place = |_, fraction: f64| (fraction * turn.angle()).to_degrees();
    let legs = [Leg::turn(turn)];
    DrawnProgram { grasp, start: turn.load_at(0.0), legs: &legs, axis: "angle (degrees)", place: &place }
        .chart(title)
}

/// A chart of `|F_t| / (μ F_n)` of each contact against the load factor of a ramp, from 0 to `most`.
///
/// ```
/// use grasp_lcp::picture::chart_of_load;
/// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
///
/// // Two jaws that press with 10 N each carry 10 N, and so 4 N 2.5 times.
/// let jaw = |name: &str, x: f64| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
/// let jaws = Grasp::new([jaw("left", -0.03), jaw("right", 0.03)])?;
/// let svg = chart_of_load(&jaws, &Ramp::from(Wrench::force([0.0, -4.0])), 3.0, "A box")?.to_svg()?;
/// assert!(svg.contains("factor of the load") && svg.contains("lost: left, right on the edge"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::Wrench`] if a load, or [`Error::Contact`] if a command, is not finite or beyond 1e50; [`Error::Size`] if the ramp has more or fewer
/// command changes than there are contacts.
pub fn chart_of_load<const C: usize>(
    grasp: &Grasp<C>,
    ramp: &Ramp<C>,
    most: f64,
    title: &str,
) -> Result<Chart, Error> {
    let legs = [Leg::along(&ramp.times(most))];
    let place = |_, fraction: f64| fraction * most;
    DrawnProgram { grasp, start: ramp.base, legs: &legs, axis: "factor of the load", place: &place }
        .chart(title)
}

/// A chart of `|F_t| / (μ F_n)` of each contact along a load program that begins with the load `start`. The horizontal axis counts the legs, i.e. the
/// sections of the program.
///
/// ```
/// use grasp_lcp::picture::chart_of_program;
/// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
///
/// let jaw = |name: &str, x: f64| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
/// let jaws = Grasp::new([jaw("left", -0.03), jaw("right", 0.03)])?;
/// let legs = [[0.0, -8.0], [2.0, 0.0]].map(|load| Leg::load_to(Wrench::force(load)));
/// let svg = chart_of_program(&jaws, Wrench::ZERO, &legs, "Down, then aside")?.to_svg()?;
/// assert!(svg.contains("legs of the program"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::Wrench`] if a load, or [`Error::Contact`] if a command, is not finite or beyond 1e50; [`Error::Size`] if a leg has more or fewer commands
/// than there are contacts.
pub fn chart_of_program<const C: usize>(
    grasp: &Grasp<C>,
    start: Wrench<C>,
    legs: &[Leg<C>],
    title: &str,
) -> Result<Chart, Error> {
    let place = |leg: usize, fraction: f64| leg as f64 + fraction;
    DrawnProgram { grasp, start, legs, axis: "legs of the program", place: &place }.chart(title)
}
