//! Memory for one question after another, for loops that must not wait for an allocator.

use super::grasp::Grasp;
use crate::contact::PolygonCone;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::{Wrench, inside, outside};
use crate::load_path::{Onset, Ramp};
use crate::numerics::Memory;
use crate::structured::{Search, SearchSettings};

/// Memory for one onset after another, for loops that must not wait for an allocator: [`Grasp::onset`] with the same answers.
///
/// From the second question on nothing is allocated for grasps with no more contacts, if one contact stops sticking before all others. If several
/// reach the edge of their cones together, a gap closes on the way, or the base does not clearly stick, rates decide, which allocate memory. So do
/// the factors of a grasp at its first question, and those of more than 256 contacts at every question.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, OnsetWorkspace, Ramp, Wrench};
///
/// // A box between two fingers of which the second rubs less. Whatever it weighs, it slides there first.
/// let finger = |x: f64, mu: f64| {
///     Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).command([0.01, 0.0])
/// };
/// let grasp = Grasp::new([finger(-1.0, 0.5), finger(1.0, 0.4)])?;
/// let mut workspace = OnsetWorkspace::default();
/// for weight in [1.0, 2.0, 4.0] {
///     let onset = workspace.onset(&grasp, &Ramp::load(Wrench::ZERO, Wrench::force([0.0, -weight])))?;
///     let event = onset.event().expect("slides");
///     assert!((event.factor - 8.0 / weight).abs() < 1e-14);
///     assert_eq!(event.leaving[0].contact.index, 1);
/// }
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct OnsetWorkspace<const C: usize> {
    settings: Settings,
    memory: Memory,
    /// The last answer.
    /// The last onset, as the caller sees it and as the engine does.
    told: Option<Onset<C>>,
    kept: Option<Onset<3>>,
    /// The last ramp as the engine sees it.
    ramp: Option<Ramp<3>>,
}

impl<const C: usize> OnsetWorkspace<C> {
    /// An empty workspace, for answers with these settings.
    #[must_use]
    pub fn new(settings: Settings) -> Self {
        Self { settings, ..Self::default() }
    }

    /// The onset of a grasp along a ramp, as from [`Grasp::onset`], valid until the next question. Clone it to keep it.
    ///
    /// # Errors
    /// As for [`Grasp::onset`].
    pub fn onset(&mut self, grasp: &Grasp<C>, ramp: &Ramp<C>) -> Result<&Onset<C>, Error> {
        if let (Some(Onset::At(told)), Some(Onset::At(kept))) = (&mut self.told, &mut self.kept) {
            told.exchange(kept);
        }
        let kept = self.kept.take();
        let inside = self.ramp.get_or_insert_with(|| Ramp::load(Wrench::ZERO, Wrench::ZERO));
        ramp.enter_into(inside);
        let onset = grasp.engine.onset_in(inside, &self.settings, &mut self.memory, kept)?;
        let onset = self.kept.insert(onset);
        match (&mut self.told, onset) {
            (Some(Onset::At(told)), Onset::At(kept)) => told.take_over(kept),
            (told, onset) => *told = Some(outside(onset.clone())),
        }
        Ok(self.told.get_or_insert(Onset::Never))
    }
}

/// Memory for equilibria under one load after another, by Lemke's method on lists of contact
/// states.
///
/// After the first scene it allocates nothing for scenes with no more contacts. The first scene that needs Lemke's method, after others that Newton's
/// method has solved, counts as a first scene, too. With thousands of contacts the thread pool of the feature `parallel` may allocate.
///
/// It searches for one equilibrium, in space on the polygonal cone or [on the round one](Self::on_the_round_cone), and reports how exactly it
/// satisfies every condition. A search without a result proves nothing. [`Grasp::solve`] has more methods, proofs that no equilibrium exists, and the
/// answer as physics.
///
/// Each scene is solved independently, from slips of zero: no answer enters the next one. `C` is 2 in the plane, 3 in space.
#[derive(Debug, Clone)]
pub struct Workspace<const C: usize> {
    asked: SearchSettings,
    memory: Memory,
}

impl<const C: usize> Default for Workspace<C> {
    fn default() -> Self {
        Self::new(PolygonCone::default())
    }
}

impl<const C: usize> Workspace<C> {
    /// An empty workspace, for answers on this polygonal cone, which matters in space only.
    #[must_use]
    pub fn new(cone: PolygonCone) -> Self {
        Self { asked: SearchSettings { cone, round: false, one_path: false }, memory: Memory::default() }
    }

    /// An empty workspace, for answers on the round cone: by Newton's method from the elastic trial state, else from an equilibrium on the default
    /// polygonal cone. In the plane there is only one cone.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    /// use grasp_lcp::ask::{Search, Workspace};
    ///
    /// // Four fingers on a ring, 10 N each, μ = 0.5: the round cone carries 20 N upwards whatever the frames.
    /// let finger = |x: f64, y: f64| {
    ///     Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0, 0.0])
    /// };
    /// let grasp = Grasp::new([finger(1.0, 0.0), finger(0.0, 1.0), finger(-1.0, 0.0), finger(0.0, -1.0)])?;
    /// let mut workspace = Workspace::on_the_round_cone();
    /// for up in [0.0, 10.0, 19.9] {
    ///     let Search::Found(found) = workspace.solve(&grasp, &Wrench::force([0.0, 0.0, up]))? else { panic!("it holds") };
    ///     assert!(found.residual() < 1e-13);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn on_the_round_cone() -> Self {
        let mut workspace = Self::default();
        workspace.asked.round = C == 3;
        workspace
    }

    /// The polygonal cone of the answers, or of the proposals for the round cone.
    #[must_use]
    pub fn cone(&self) -> PolygonCone {
        self.asked.cone
    }

    /// Whether answers are for the round cone.
    #[must_use]
    pub fn is_round(&self) -> bool {
        self.asked.round
    }

    /// An equilibrium of a grasp under a load on the object. From 32 contacts on, and on the round cone, Newton's method comes first. If it does not
    /// converge, up to four of Lemke's paths from the elastic trial state follow. A step of Newton's method and a pivot cost O(n) with n contacts.
    ///
    /// ```
    /// use grasp_lcp::PolygonCone;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::ask::{Search, Workspace};
    ///
    /// // Eight springs under a block of 16 N, which is pulled sideways: μ = 0.5 holds 8 N.
    /// let spring = |i: u8| {
    ///     Contact::new([f64::from(i), 0.0], [0.0, 1.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.002, 0.0])
    /// };
    /// let grasp = Grasp::new((0..8).map(spring))?;
    /// let mut workspace = Workspace::new(PolygonCone::default());
    /// for pull in 0..8 {
    ///     let load = Wrench::force_at([f64::from(pull), -16.0], [3.5, 0.0]);
    ///     let Search::Found(found) = workspace.solve(&grasp, &load)? else { panic!("it holds") };
    ///     assert!(found.residual() < 1e-14);
    ///     assert!((found.twist().translation()[0] - f64::from(pull) / 6400.0).abs() < 1e-15);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn solve(&mut self, grasp: &Grasp<C>, load: &Wrench<C>) -> Result<Search<'_, C>, Error> {
        grasp.engine.search_in(&inside(load), &self.asked, &mut self.memory).map(Search::outside)
    }

    /// As [`Self::solve`], along Lemke's first path only, with the covering vector of ones, for any number of contacts. On the round cone Newton's
    /// method continues from its end.
    ///
    /// # Errors
    /// As for [`Workspace::solve`].
    pub fn solve_along_one_path(
        &mut self,
        grasp: &Grasp<C>,
        load: &Wrench<C>,
    ) -> Result<Search<'_, C>, Error> {
        let asked = SearchSettings { one_path: true, ..self.asked };
        grasp.engine.search_in(&inside(load), &asked, &mut self.memory).map(Search::outside)
    }
}
