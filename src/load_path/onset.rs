//! The onset of sliding, found directly.
//!
//! While everything rolls, forces are affine in the load factor, `F(τ) = F⁰ + τ F¹`: two linear solves. The onset is
//! the smallest τ at which a contact reaches the edge of its cone (a linear equation for each facet, a quadratic one
//! for the round cone). It is the first pivot of Lemke's method with the load as covering vector. An open contact may
//! close on the way; it starts with F_t = 0 and rolls on if the rates lie in its cone.

use std::sync::Arc;

use nalgebra::SVector;

use super::beyond::Beyond;
use super::ramp::Ramp;
use super::segment::Segment;
use super::walk::Walk;
use crate::contact::{Polygon, State};
use crate::equilibrium::{Cone, Equilibrium, NoEquilibrium, Outcome, Undecided};
use crate::error::{Error, Field};
use crate::grasp::{Grasp, Wrench};
use crate::object::{Load, Problem};
use crate::search::{Found, Rung, Settings, Settled, settle};

/// The answer to "at which load factor τ >= 0 does the first contact leave rolling?"
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Onset<const D: usize, const C: usize> {
    /// At this factor.
    At(Box<OnsetEvent<D, C>>),
    /// However far the load goes along this direction, everything keeps rolling.
    Never,
    /// At factor 0 something slides already: the equilibrium there. (A contact that only stands on the edge there rolls, and may leave at 0.)
    AlreadySliding(Box<Equilibrium<D, C>>),
    /// No equilibrium exists at factor 0.
    NoBase(NoEquilibrium<D>),
    /// No contact leaves rolling, but from this factor on nothing resists the load's direction: the reason.
    GivesWay {
        /// The factor up to which the grasp holds.
        factor: f64,
        /// Why it does not hold beyond; the work in it is that of the load direction, J for one unit of the factor.
        reason: NoEquilibrium<D>,
    },
    /// Nothing can be said about the equilibrium at factor 0.
    Undecided(Undecided),
}

impl<const D: usize, const C: usize> Onset<D, C> {
    /// The event, if there is one.
    #[must_use]
    pub fn event(&self) -> Option<&OnsetEvent<D, C>> {
        match self {
            Self::At(event) => Some(event),
            _ => None,
        }
    }

    /// The load factor up to which everything that touches rolls: that of the event, or from which on nothing resists; infinite for never.
    /// `None` where there is no rolling equilibrium to start from, or nothing can be said.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        match self {
            Self::At(event) => Some(event.factor),
            Self::Never => Some(f64::INFINITY),
            Self::GivesWay { factor, .. } => Some(*factor),
            _ => None,
        }
    }
}

/// The first contact leaves rolling.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct OnsetEvent<const D: usize, const C: usize> {
    /// Load factor τ, exact up to rounding.
    pub factor: f64,
    /// The load there, `base + τ direction`.
    pub load: Wrench<D>,
    /// Which contacts leave, all at once. Contacts that close on the way do not count.
    pub leaving: Vec<Leaving<C>>,
    /// The equilibrium there: everything rolls, the leaving contacts stand on the edge of their cone.
    pub state: Equilibrium<D, C>,
    /// What comes next.
    pub beyond: Beyond<D, C>,
    /// In space, when the event is for the round cone: the onset on the polygon of the settings, for comparison
    /// (infinite for never; `None` where the polygon has no rolling equilibrium at factor 0).
    pub polygon_factor: Option<f64>,
}

/// A contact that leaves rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Leaving<const C: usize> {
    /// The contact, from 0.
    pub contact: usize,
    /// How it leaves.
    pub how: Departure<C>,
}

/// How a contact leaves rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Departure<const C: usize> {
    /// It slides, `|F_t| = μ F_n`.
    Slides {
        /// Unit direction in which the finger slips over the body, coordinate axes; friction pulls the body that way.
        direction: SVector<f64, C>,
    },
    /// It opens, F_n = 0.
    Opens,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The onset of sliding from a base load along a load direction, with default [`Settings`]: exact in the plane, on
    /// the round cone in space. See [`Self::onset`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Both contacts slide when half the load is μ N = 5 N.
    /// let onset = grasp.onset_of_sliding(Wrench::ZERO, Wrench::force([0.0, -1.0]))?;
    /// let event = onset.event().expect("friction is finite");
    /// assert!((event.factor - 10.0).abs() < 1e-14);
    /// assert_eq!(event.leaving.len(), 2);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite, or beyond 1e50.
    pub fn onset_of_sliding(&self, base: Wrench<D>, direction: Wrench<D>) -> Result<Onset<D, C>, Error> {
        self.onset(&Ramp::load(base, direction), &Settings::default())
    }

    /// The factor at which the first contact leaves rolling along a [`Ramp`], which contacts leave and how, the state
    /// there and what comes next. No stepping and no bisection: a linear equation for each facet in the plane, a
    /// quadratic one for each contact on the round cone in space.
    ///
    /// What comes next takes most of the time, in space by far: where this equilibrium does not go on, that is a proof over all contact states.
    /// For many onsets alone ask with [`Settings::with_most_states`] of 0, which leaves such proofs out.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    /// use grasp_lcp::Settings;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // The fingers let go under 4 N: F_t = 2 N needs F_n = 4 N, which is left after 6 mm.
    /// let release = Ramp::commands(Wrench::force([0.0, -4.0]), vec![[-1.0, 0.0].into(); 2]);
    /// let factor = grasp.onset(&release, &Settings::default())?.factor().expect("rolls at first");
    /// assert!((factor - 0.006).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load of the ramp, [`Error::Contact`] if a command change is not finite or beyond 1e50; [`Error::Size`] if
    /// there are more or fewer command changes than contacts.
    pub fn onset(&self, ramp: &Ramp<D, C>, settings: &Settings) -> Result<Onset<D, C>, Error> {
        if C == 2 {
            return self.onset_on_polygon(ramp, settings);
        }
        let on_polygon = self.onset_on_polygon(ramp, settings)?;
        let mut onset = self.search_onset(ramp, settings, Cone::Round)?;
        if let Onset::At(event) = &mut onset {
            event.polygon_factor = on_polygon.factor();
        }
        Ok(onset)
    }

    /// The same on the polygonal cone of the settings, corners where [`PolygonCone`](crate::PolygonCone) says (in the plane this is the exact cone).
    ///
    /// ```
    /// use grasp_lcp::Settings;
    /// use grasp_lcp::spatial::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Three fingers under a plate of 12 N, μ = 0.5, pulled sideways between two corners of the octagon in the cone.
    /// let finger = |x: f64, y: f64| {
    ///     Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(100.0, 100.0).friction(0.5).command([0.04, 0.0, 0.0])
    /// };
    /// let grasp = Grasp::new([finger(-1.0, -1.0), finger(1.0, -1.0), finger(0.0, 2.0)])?;
    /// let eighth = std::f64::consts::FRAC_PI_8;
    /// let ramp = Ramp::load(Wrench::force([0.0, 0.0, -12.0]), Wrench::force([eighth.cos(), eighth.sin(), 0.0]));
    ///
    /// let onset = grasp.onset_on_polygon(&ramp, &Settings::default())?;
    /// assert!((onset.factor().expect("slides") - 6.0 * eighth.cos()).abs() < 1e-13); // 6 N on the round cone
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn onset_on_polygon(&self, ramp: &Ramp<D, C>, settings: &Settings) -> Result<Onset<D, C>, Error> {
        self.search_onset(ramp, settings, Cone::polygonal::<C>(settings))
    }

    fn search_onset(&self, ramp: &Ramp<D, C>, settings: &Settings, cone: Cone) -> Result<Onset<D, C>, Error> {
        let (base, direction) =
            (self.inside(&ramp.base, "base load")?, self.inside(&ramp.direction, "load direction")?);
        let change = match &ramp.command_change {
            Some(change) => {
                self.check_commands(change, "command changes", Field::CommandChange)?;
                change.clone()
            }
            None => vec![SVector::zeros(); self.len()],
        };
        let polygon = Arc::new(Polygon::new(&settings.cone));
        let round = cone == Cone::Round;
        let problem = Problem::at_rest(self.sites(), polygon, round, self.drives(), &Load::from(&base));
        let (found, rule) = match self.rolling_base(&problem, ramp, settings, cone) {
            Ok(base) => base,
            Err(onset) => return Ok(*onset),
        };
        let segment = Segment { grasp: self, cone, problem, change, direction };
        let mut walk = Walk { segment, ramp, settings, rule, factor: 0.0 };
        Ok(walk.run(found.states))
    }

    /// The equilibrium at factor 0 if nothing slides there.
    fn rolling_base(
        &self,
        problem: &Problem<D, C>,
        ramp: &Ramp<D, C>,
        settings: &Settings,
        cone: Cone,
    ) -> Result<(Found<D, C>, Rung), Box<Onset<D, C>>> {
        let slides = |found: &Found<D, C>| found.states.iter().any(State::slides);
        let (settled, effort) = settle(problem, settings);
        match &settled {
            Settled::Found(found, rule) if !slides(found) => {
                return Ok((found.clone(), *rule));
            }
            _ => {}
        }
        Err(Box::new(match self.outcome(problem, &ramp.base, settled, &effort, cone) {
            Outcome::Equilibrium(equilibrium) => Onset::AlreadySliding(equilibrium),
            Outcome::NoEquilibrium(none) => Onset::NoBase(none),
            Outcome::Undecided(doubt) => Onset::Undecided(doubt),
        }))
    }
}
