//! The onset of sliding, found directly.
//!
//! While everything rolls, forces are affine in the load factor, `F(τ) = F⁰ + τ F¹`: two linear solves. The onset is
//! the smallest τ at which a contact reaches the edge of its cone (a linear equation for each facet, a quadratic one
//! for the round cone). It is the first pivot of Lemke's method with the load as covering vector. An open contact may
//! close on the way; it starts with F_t = 0 and rolls on if the rates lie in its cone.

use super::beyond::{Beyond, End, beyond_end, continuation};
use super::course::Course;
use super::first_to_leave::first_to_leave;
use super::loss::leaving_motion;
use super::onset::{Onset, OnsetEvent};
use super::onset_workspace::OnsetMemory;
use super::ramp::Ramp;
use super::segment::Segment;
use super::turn_questions::TurnOnset;
use super::walk::Walk;
use crate::contact::{Polygon, PolygonCone, State};
use crate::equilibrium::{Cone, Equilibrium, Outcome};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::object::{Load, Problem};
use crate::search::{Effort, Found, Rung, Settings, Settled, settle};

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
    /// let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
    /// let event = onset.event().expect("friction is finite");
    /// assert!((event.factor - 10.0).abs() < 1e-14);
    /// assert_eq!(event.leaving.len(), 2);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite, or beyond 1e50.
    pub fn onset_of_sliding(
        &self,
        base: &Wrench<D, C>,
        direction: &Wrench<D, C>,
    ) -> Result<Onset<D, C>, Error> {
        self.onset(&Ramp::load(*base, *direction))
    }

    /// The factor at which the first contact leaves rolling along a [`Ramp`], and which contacts leave and how, with default [`Settings`]: in
    /// the plane exact, in space on the round cone. No stepping and no bisection: a linear equation for each facet in the plane, a quadratic
    /// one for each contact on the round cone.
    ///
    /// The equilibrium there and what comes next are one call further: [`Self::state_at_onset`], [`Self::beyond`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // The fingers let go under 4 N: F_t = 2 N needs F_n = 4 N, which is left after 6 mm.
    /// let release = Ramp::commands(Wrench::force([0.0, -4.0]), [[-1.0, 0.0]; 2]);
    /// let factor = grasp.onset(&release)?.factor().expect("rolls at first");
    /// assert!((factor - 0.006).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load of the ramp, [`Error::Contact`] if a command change is not finite or beyond 1e50; [`Error::Size`] if
    /// there are more or fewer command changes than contacts.
    pub fn onset(&self, ramp: &Ramp<D, C>) -> Result<Onset<D, C>, Error> {
        self.onset_with(ramp, &Settings::default())
    }

    /// The onset with other [`Settings`], which say for which cone: in space the polygon's where they ask for
    /// [it](Settings::on_the_polygon), with corners where [`PolygonCone`](crate::PolygonCone) says.
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
    /// let octagon = grasp.onset_with(&ramp, &Settings::default().on_the_polygon())?;
    /// assert!((octagon.factor().expect("slides") - 6.0 * eighth.cos()).abs() < 1e-13);
    /// assert!((grasp.onset(&ramp)?.factor().expect("slides") - 6.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn onset_with(&self, ramp: &Ramp<D, C>, settings: &Settings) -> Result<Onset<D, C>, Error> {
        self.onset_in(ramp, settings, &mut OnsetMemory::default())
    }

    /// [`Self::onset_with`] in memory that is there.
    pub(super) fn onset_in(
        &self,
        ramp: &Ramp<D, C>,
        settings: &Settings,
        memory: &mut OnsetMemory<D, C>,
    ) -> Result<Onset<D, C>, Error> {
        let base = self.load_alone(&ramp.base, "base load")?;
        let direction = self.inside(&ramp.direction, "load direction")?;
        ramp.drive_changes_into(self, &mut memory.change)?;
        let segment = memory.segment(self, settings, Course::Straight { from: base, rate: direction });
        if let Some(first) = first_to_leave(&segment, memory) {
            let load = ramp.load_at(first.factor);
            return Ok(first.onset(segment, load, memory));
        }
        let course = Course::Straight { from: ramp.base, rate: ramp.direction };
        Ok(self.walked(segment, (course, f64::INFINITY), settings).onset)
    }

    /// The onset along a course, as the question has it, up to its end, with all that may happen on the way.
    pub(super) fn walked<'a>(
        &'a self,
        segment: Segment<'a, D, C>,
        (course, end): (Course<Wrench<D, C>>, f64),
        settings: &'a Settings,
    ) -> TurnOnset<D, C> {
        let (found, rule) = match self.rolling_base(&segment, &course, settings) {
            Ok(base) => base,
            Err(onset) => return TurnOnset { onset: *onset, touches: Vec::new() },
        };
        let mut walk = Walk { segment, course, end, settings, rule, factor: 0.0, touches: Vec::new() };
        let onset = walk.run(found.states);
        TurnOnset { onset, touches: walk.touches }
    }

    /// The equilibrium at an onset: everything rolls, the leaving contacts stand on the edge of their cone. `None` for the event of a grasp
    /// with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
    ///
    /// let state = grasp.state_at_onset(onset.event().expect("slides")).expect("its own event");
    /// assert!((state.contacts[0].friction_used() - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn state_at_onset(&self, event: &OnsetEvent<D, C>) -> Option<Equilibrium<D, C>> {
        let problem = self.problem_at_onset(event)?;
        let (found, rule) = (event.local.found.clone(), event.local.rule);
        Some(self.equilibrium(&problem, &event.load, found, rule, &Effort::default(), event.cone))
    }

    /// What comes after an onset, with default [`Settings`]; see [`Self::beyond_with`].
    #[must_use]
    pub fn beyond(&self, event: &OnsetEvent<D, C>) -> Option<Beyond<D, C>> {
        self.beyond_with(event, &Settings::default())
    }

    /// What comes after an onset: whether the equilibrium goes on, and if not, whether there is another just beyond. That takes longer than the
    /// onset by far, in space up to a proof over all contact states. `None` for the event of a grasp with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Beyond, Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5. Both slide at once, and nothing is left.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
    ///
    /// let beyond = grasp.beyond(onset.event().expect("slides")).expect("its own event");
    /// assert!(matches!(beyond, Beyond::LimitLoad));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn beyond_with(&self, event: &OnsetEvent<D, C>, settings: &Settings) -> Option<Beyond<D, C>> {
        let problem = self.problem_at_onset(event)?;
        let (local, cone) = (&event.local, event.cone);
        let change = local.drive_rates.clone();
        let course = Course::Straight { from: local.wrench, rate: local.wrench_rate };
        let segment = Segment { grasp: self, cone, problem, change, course, largest: 0.0 };
        let rates = segment.rates(0.0, segment.laws_of_rates(&local.stands, &local.found.states));
        let (settled, effort) = match settle(&rates, settings) {
            (Settled::Found(found, rule), _) => return Some(continuation(self, &rates, found, rule)),
            lost => lost,
        };
        let motion = leaving_motion(&rates, &segment.problem.wrench, &rates.yielding());
        let end = End { factor: 0.0, forces: &local.found.forces, motion };
        Some(beyond_end(&segment, &rates, (settled, &effort), &end, settings))
    }

    /// The local problem at an onset.
    fn problem_at_onset(&self, event: &OnsetEvent<D, C>) -> Option<Problem<'_, D, C>> {
        let local = &event.local;
        if local.found.states.len() != self.sites().len() {
            return None;
        }
        let cone = if let Cone::Polygon(cone) = event.cone { cone } else { PolygonCone::default() };
        let (polygon, round) = (Polygon::shared(&cone), event.cone == Cone::Round);
        let load = Load::from(&local.wrench);
        let problem = self.problem(polygon, round, local.drives.clone(), &load);
        Some(Problem { slips: local.slips.clone(), ..problem })
    }

    /// The equilibrium at factor 0 if nothing slides there.
    fn rolling_base(
        &self,
        segment: &Segment<'_, D, C>,
        course: &Course<Wrench<D, C>>,
        settings: &Settings,
    ) -> Result<(Found<D, C>, Rung), Box<Onset<D, C>>> {
        let (problem, cone) = (&segment.problem, segment.cone);
        let slides = |found: &Found<D, C>| found.states.iter().any(State::slides);
        let (settled, effort) = settle(problem, settings);
        match &settled {
            Settled::Found(found, rule) if !slides(found) => {
                return Ok((found.clone(), *rule));
            }
            _ => {}
        }
        Err(Box::new(match self.outcome(problem, &course.at(0.0), settled, &effort, cone) {
            Outcome::Equilibrium(equilibrium) => Onset::AlreadySliding(equilibrium),
            Outcome::NoEquilibrium(none) => Onset::NoBase(none),
            Outcome::Undecided(doubt) => Onset::Undecided(doubt),
        }))
    }
}
