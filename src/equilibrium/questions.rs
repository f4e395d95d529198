//! The questions for equilibria.

use nalgebra::SVector;

use super::answer::{Cone, Equilibrium, NoEquilibrium, Outcome, Proof, Undecided, WorkDone};
use crate::contact::Polygon;
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::object::Problem;
use crate::search::{Doubt, Effort, Found, Rung, Settings, Settled, combinations, search, settle};

/// No answer with a larger residual is called an equilibrium. Usual ones are below 1e-15; only scenes whose numbers lie apart by
/// more than the working precision come near this.
pub(crate) const ACCURATE: f64 = 1e-10;
/// The bound on the round cone, where a larger residual means that Newton's method has not arrived.
const ACCURATE_ON_THE_ROUND_CONE: f64 = 1e-12;
/// Two answers whose forces and displacements differ by less than this part of the largest are one equilibrium.
const SAME: f64 = 1e-9;

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The equilibrium under a load, with default [`Settings`].
    ///
    /// Where several equilibria exist, the one in which everything rolls comes first; else see [`Rung`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Outcome, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // 4 N downwards stretch two tangential springs of 800 N/m; each contact carries half.
    /// let outcome = grasp.solve(&Wrench::force([0.0, -4.0]))?;
    /// let held = outcome.equilibrium().expect("friction carries up to 10 N");
    /// assert!((held.twist.translation()[1] - -4.0 / 1600.0).abs() < 1e-15);
    /// assert!((held.contacts[0].friction_used() - 2.0 / 10.0).abs() < 1e-15);
    ///
    /// assert!(matches!(grasp.solve(&Wrench::force([0.0, -11.0]))?, Outcome::NoEquilibrium(_)));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn solve(&self, load: &Wrench<D, C>) -> Result<Outcome<D, C>, Error> {
        self.solve_with(load, &Settings::default())
    }

    /// The equilibrium under a load.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{Fit, PolygonCone, Settings};
    ///
    /// // Four fingers on a ring, 10 N each, μ = 0.5: the round cone carries 20 N upwards whatever the frames.
    /// let finger = |x: f64, y: f64| {
    ///     Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0, 0.0])
    /// };
    /// let grasp = Grasp::new([finger(1.0, 0.0), finger(0.0, 1.0), finger(-1.0, 0.0), finger(0.0, -1.0)])?;
    /// let up = Wrench::force([0.0, 0.0, 19.9]);
    /// assert!(grasp.solve(&up)?.equilibrium().is_some());
    ///
    /// // A triangle in the cone, its corner pointing sideways, does not.
    /// let triangle = Settings::default().on_the_polygon().with_cone(PolygonCone::new(3, Fit::Inscribed)?);
    /// assert!(grasp.solve_with(&up, &triangle)?.equilibrium().is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn solve_with(&self, load: &Wrench<D, C>, settings: &Settings) -> Result<Outcome<D, C>, Error> {
        let problem = self.problem_under(load, settings)?;
        let (settled, effort) = settle(&problem, settings);
        Ok(self.outcome(&problem, load, settled, &effort, Cone::of::<C>(settings)))
    }

    /// All equilibria under a load, for few contacts, by trying every combination of contact states; the one that
    /// [`Self::solve_with`] returns is among them. On the round cone: that one, and those that Newton's method reaches from the equilibria of
    /// the polygon, which may be fewer than there are. Whether it is proved that there is none says [`Self::solve_with`]. Combinations that
    /// share one equilibrium (a contact exactly on an edge) are listed once; a line of equilibria by one of its points, with its
    /// [`neutral_motions`](Equilibrium::neutral_motions).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let all = grasp.equilibria(&Wrench::force([0.0, -4.0]))?;
    /// assert_eq!(all.len(), 1); // a pinch with horizontal normals has no other
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::TooManyStates`] beyond [`Settings::most_states`] combinations, [`Error::Wrench`] if the load is not
    /// finite, or beyond 1e50.
    pub fn equilibria(&self, load: &Wrench<D, C>) -> Result<Vec<Equilibrium<D, C>>, Error> {
        self.equilibria_with(load, &Settings::default())
    }

    /// [`Self::equilibria`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::equilibria`].
    pub fn equilibria_with(
        &self,
        load: &Wrench<D, C>,
        settings: &Settings,
    ) -> Result<Vec<Equilibrium<D, C>>, Error> {
        let problem = self.problem_under(load, settings)?;
        let combinations = combinations(&problem);
        if combinations > settings.most_states as f64 {
            return Err(Error::TooManyStates {
                contacts: self.len(),
                combinations,
                most: settings.most_states,
            });
        }
        let search = search(&problem, false);
        let effort = Effort { combinations: search.tried, ..Effort::default() };
        let mut list: Vec<Equilibrium<D, C>> = Vec::new();
        let mut add = |found: Found<D, C>, rule, effort: &Effort| {
            let equilibrium = self.equilibrium(&problem, load, found, rule, effort, Cone::of::<C>(settings));
            if accurate(&equilibrium) && !list.iter().any(|known| same(known, &equilibrium)) {
                list.push(equilibrium);
            }
        };
        for found in search.found {
            add(found, Rung::Enumeration, &effort);
        }
        // The round cone may have an equilibrium where the polygon inside has none, or one far from it.
        if problem.round
            && let (Settled::Found(found, rule), effort) = settle(&problem, settings)
        {
            add(found, rule, &effort);
        }
        Ok(list)
    }

    /// The problem at rest under a load.
    pub(super) fn problem_under(
        &self,
        load: &Wrench<D, C>,
        settings: &Settings,
    ) -> Result<Problem<'_, D, C>, Error> {
        let polygon = Polygon::shared(&settings.cone);
        let load = self.load(load, "load")?;
        Ok(self.problem(polygon, settings.is_round::<C>(), self.drives(), &load))
    }

    pub(crate) fn outcome(
        &self,
        problem: &Problem<D, C>,
        load: &Wrench<D, C>,
        settled: Settled<D, C>,
        effort: &Effort,
        cone: Cone,
    ) -> Outcome<D, C> {
        let none = |proof| Outcome::NoEquilibrium(NoEquilibrium { proof });
        let motion_and_work = |v: &SVector<f64, D>| (self.outside(v), v.dot(&problem.wrench));
        match settled {
            Settled::Found(found, rule) => {
                let equilibrium = self.equilibrium(problem, load, found, rule, effort, cone);
                if accurate(&equilibrium) {
                    Outcome::Equilibrium(Box::new(equilibrium))
                } else {
                    Outcome::Undecided(Undecided { doubt: Doubt::Inaccurate, work: equilibrium.work })
                }
            }
            Settled::FreeMotion(v) => {
                let (motion, work) = motion_and_work(&v);
                none(Proof::FreeMotion { motion, work })
            }
            Settled::Separating(v) => {
                let (motion, work) = motion_and_work(&v);
                none(Proof::SeparatingMotion { motion, work })
            }
            Settled::NoneOf(combinations) => none(Proof::EveryStateTried { combinations }),
            Settled::Contradicted { cases, escape } => none(Proof::EveryCaseContradicted { cases, escape }),
            Settled::Undecided(doubt) => {
                let work = WorkDone {
                    pivots: effort.pivots,
                    rows_made: effort.rows,
                    rows_left_out: self.left_out(effort, cone, false),
                    combinations: effort.combinations,
                };
                Outcome::Undecided(Undecided { doubt, work })
            }
        }
    }
}

/// Whether residuals are those of an equilibrium.
fn accurate<const D: usize, const C: usize>(equilibrium: &Equilibrium<D, C>) -> bool {
    let most = if equilibrium.cone == Cone::Round { ACCURATE_ON_THE_ROUND_CONE } else { ACCURATE };
    equilibrium.residuals.worst() <= most
}

/// Two answers of the same question are one equilibrium.
fn same<const D: usize, const C: usize>(a: &Equilibrium<D, C>, b: &Equilibrium<D, C>) -> bool {
    let size = |e: &Equilibrium<D, C>| e.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    let force_size = size(a).max(size(b));
    let travel = |e: &Equilibrium<D, C>| e.contacts.iter().map(|c| c.body_core.norm()).fold(0.0, f64::max);
    let motion_size = travel(a).max(travel(b));
    let contacts_agree = a.contacts.iter().zip(&b.contacts).all(|(x, y)| {
        (x.force - y.force).norm() <= SAME * force_size
            && (x.body_core - y.body_core).norm() <= SAME * motion_size
    });
    let joints = || a.joints.iter().zip(&b.joints);
    let turn =
        joints().fold(0.0_f64, |most, (x, y)| most.max(x.displacement.abs()).max(y.displacement.abs()));
    contacts_agree && joints().all(|(x, y)| (x.displacement - y.displacement).abs() <= SAME * turn)
}
