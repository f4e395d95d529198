//! A grasp, and the questions that it answers. The engine holds the checked data of a grasp and computes with three components, also in the plane. A
//! command is the displacement that a finger would make if there were no object. The squeeze is everything by which contacts press at rest without a
//! load. The base load acts before a load grows; the load factor is the multiple of the growing load. At first slip the first contact ceases to
//! stick, at gross slip every contact that presses slides. Motions are small within the limits of rotation, slip and opening up to which the linear
//! theory is trusted.

use alloc::sync::Arc;

use nalgebra::{SMatrix, SVector};

use super::energy::Energy;
use super::sensitivity::Sensitivity;
use super::statics::Statics;
use crate::equilibrium::{Outcome, Settings};
use crate::error::{Error, check_contact};
use crate::grasp::{
    Bodies, Contact, Engine, Face, Finger, Hand, HandPart, WholeContact, Wrench, assert_plane_or_space,
    frame_outside, inside, outside,
};
use crate::hold::{PathFacts, Verdict, VerdictScope};
use crate::load_path::Ramp;
use crate::numerics::{Each, IntoList, Once, Space, mapped, numbered};
use crate::prelude::*;

/// An object held by elastic fingers: a checked list of contacts, and the joints behind them if a [`Hand`] holds it.
///
/// Wrenches and twists refer to the origin of the coordinates in which the contact points are given. `C` is the number of axes of a contact: 2 in the
/// plane ([`planar::Grasp`](crate::planar::Grasp)), 3 in space ([`spatial::Grasp`](crate::spatial::Grasp)).
///
/// | question | method |
/// |---|---|
/// | does the grasp hold a load, and up to which multiple of it | [`hold`](Self::hold) |
/// | motion of the object and contact forces under a load, or the proof that no equilibrium exists | [`solve`](Self::solve) |
/// | the load factor of first slip | [`onset`](Self::onset) |
/// | the angle of first slip while the load turns, such as a tilted weight | [`onset_of_turn`](Self::onset_of_turn) |
/// | the behaviour just beyond first slip, and the equilibrium at first slip | [`beyond`](Self::beyond), [`state_at_onset`](Self::state_at_onset) |
/// | every event of a load program, which keeps earlier slips | [`follow`](Self::follow); of thousands of contacts, in steps, [`follow_in_steps`](Self::follow_in_steps) |
/// | squeeze, friction, load, arm or angle needed to hold | [`need`](Self::need); for squeeze in closed form [`least_squeeze`](Self::least_squeeze) |
/// | finger places and commanded normal forces with the largest load factor of first slip | [`improve`](Self::improve) |
/// | friction, squeeze, stiffness and loads of supports, from observed slip | [`identify`](Self::identify) |
/// | the direction in which the least force makes a contact cease to stick | [`weakest_direction`](Self::weakest_direction) |
/// | how an answer changes with the data | [`sensitivity`](crate::ask::Sensitivity::of) |
/// | the load factor of first slip if data are uncertain | [`reserve`](Self::reserve) |
/// | whether any contact forces could balance a load | [`statics`](Self::statics) |
/// | all equilibria under a load, the error of one | [`equilibria`](Self::equilibria), [`accuracy`](Self::accuracy), [`distinct`](Self::distinct) |
/// | many loads, each on a grasp of its own; many questions on all cores | [`hold_batch`](Self::hold_batch), [`need_batch`](Self::need_batch); [`sweep`](crate::sweep) |
/// | the quadratic program of minimum energy | [`energy`](Self::energy) |
/// | any of these for another friction cone, or with other limits on computing effort | [`with`](Self::with) settings |
///
/// These methods take a load, a [`Ramp`] or a [`Turn`](crate::load_path::Turn) by value or by reference. A load in the place of a ramp grows from
/// zero.
#[derive(Debug, Clone)]
pub struct Grasp<const C: usize> {
    pub(crate) engine: Arc<Engine>,
    pub(super) settings: Settings,
    /// The data that methods return by reference. The engine stores them with three components; the first request converts them to `C` components.
    door: Once<Arc<Door<C>>>,
}

/// The data of a grasp that methods return by reference, with vectors of `C` components.
#[derive(Debug)]
struct Door<const C: usize> {
    contacts: Vec<Contact<C>>,
    frames: Vec<SMatrix<f64, C, C>>,
    links: Vec<[SVector<f64, C>; 2]>,
    joint_centres: Vec<Option<SVector<f64, C>>>,
}

/// Converts a grasp to a `Grasp<3>` and back, since the engine computes with three components in the plane, too. Both share one engine.
impl<const C: usize> Face for Grasp<C> {
    type Inside = Grasp<3>;
    const SAME: bool = C == 3;

    fn widen(&self) -> Grasp<3> {
        Grasp { engine: Arc::clone(&self.engine), settings: self.settings, door: Once::new() }
    }

    fn narrow(inside: Grasp<3>) -> Self {
        Self { engine: inside.engine, settings: inside.settings, door: Once::new() }
    }
}

impl<const C: usize> Grasp<C> {
    /// The grasp of an object by these contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp};
    /// use grasp_lcp::{Error, Field};
    ///
    /// let contact = |mu| Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(1.0, 1.0).friction(mu);
    /// assert_eq!(Grasp::new([contact(0.3), contact(0.5)])?.len(), 2);
    ///
    /// let refused = Grasp::new([contact(0.3), contact(-0.5).name("thumb")]).unwrap_err();
    /// assert!(matches!(refused, Error::Contact { field: Field::Friction, value: -0.5, .. }));
    /// assert_eq!(refused.to_string(), "contact 1 (thumb): friction coefficient is -0.5, must be from 0 to 1e50, or infinite");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`], or [`Error::Contact`] with the first contact, field and value out of range.
    pub fn new(contacts: impl IntoIterator<Item = Contact<C>>) -> Result<Self, Error> {
        const { assert_plane_or_space::<C>() };
        let contacts: Vec<_> = contacts.into_iter().map(Face::into_inside).list();
        Grasp::installed_by(engine_of_contacts(contacts)?)
    }

    /// A grasp that computes with this engine. Links (such as cables) with a given tension get the commands with which they have this tension without
    /// load. Returns an error if the grasp cannot hold such a tension.
    fn installed_by(engine: Engine) -> Result<Self, Error> {
        Ok(Self::of(engine.installed()?))
    }

    pub(super) fn of(engine: Engine) -> Self {
        Self { engine: Arc::new(engine), settings: Settings::default(), door: Once::new() }
    }

    fn door(&self) -> &Door<C> {
        self.door.get_or_init(|| {
            let engine = &*self.engine;
            Arc::new(Door {
                contacts: engine.contacts().iter().cloned().map(outside).list(),
                frames: numbered(engine.len(), &|contact| frame_outside(engine.frame(contact))),
                links: mapped(engine.links(), &|link| link.each(outside)),
                joint_centres: engine.joint_centres().iter().copied().map(outside).list(),
            })
        })
    }

    /// This grasp with other [`Settings`]: for another friction cone, or with other limits on computing effort. The copy is cheap: it shares contacts
    /// and factorised matrices with this grasp.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{PolygonFit, PolygonCone, Settings};
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
    /// let triangle = Settings::default().on_the_polygon().with_cone(PolygonCone::new(3, PolygonFit::Inscribed)?);
    /// assert!(grasp.with(&triangle).solve(&up)?.equilibrium().is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn with(&self, settings: &Settings) -> Self {
        Self { settings: *settings, ..self.clone() }
    }

    /// The contacts with a point that `is_meant` selects; its argument is the index of a contact point. A soft fingertip, which has several points,
    /// is listed once, with the number of its selected points.
    #[must_use]
    pub fn whole_contacts(&self, is_meant: impl Fn(usize) -> bool) -> Vec<WholeContact> {
        self.engine.wholes().with(&is_meant)
    }

    /// The indices of the contact points that belong to `contacts`. In `contacts` a soft fingertip counts as one contact, while each of its points
    /// has an index of its own. Returns an error for an index that no contact has.
    pub(crate) fn points_of(&self, contacts: &[usize]) -> Result<Vec<usize>, Error> {
        let parts = self.engine.wholes();
        let mut points = Vec::new();
        for contact in contacts {
            check_contact(*contact, parts.len())?;
            points.extend(parts[*contact].range.clone());
        }
        Ok(points)
    }

    /// The settings with which the methods of this grasp compute: friction cone, limits on computing effort, and limits of small motions.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Whether the grasp holds a load that grows from zero in addition to the base load. The [`Verdict`] says in a sentence whether all contacts
    /// stick, some slide, or the object is lost: at which fraction of the load, and by which motion. It also has the load factors of first slip and
    /// gross slip, up to [`Settings::most_load`].
    ///
    /// A load is a [`Wrench`], applied from zero, or a [`Ramp`] with a base load and changes of commands. From the equilibrium under the base load
    /// one load path is followed ([`Self::follow`]), without a search for other equilibria. The verdict is undecided only if this path cannot be
    /// continued, because of rounding or a limit on computing effort. If the load is lost, [`Lost::nothing_near`](crate::hold::Lost::nothing_near)
    /// proves that no equilibrium near the loss holds it.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that each press with 10 N; μ = 0.5.
    /// let jaw = |x: f64, name| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")])?;
    ///
    /// let verdict = gripper.hold(Wrench::force([0.0, -4.0]))?;
    /// assert_eq!(verdict.to_string(), "HOLDS, everything sticks: 10 N (2.5 times this load) until it is lost, as left and right slide");
    /// assert!((verdict.lost.expect("both slide at once").factor - 2.5).abs() < 1e-12);
    ///
    /// let verdict = gripper.hold(Wrench::force([0.0, -12.0]))?;
    /// let words = verdict.to_string();
    /// assert!(words.starts_with("SLIPS OUT at 10 N of 12 N: the object moves along −y, left and right slide (gross slip)"), "{words}");
    /// assert_eq!(verdict.holds(), Some(false));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load of the ramp, [`Error::Contact`] if a command change is not finite or beyond 1e50; [`Error::Size`] if there are
    /// more or fewer command changes than contacts.
    #[doc(alias = "gross slip", alias = "limit load", alias = "grip", alias = "payload", alias = "reserve")]
    pub fn hold(&self, load: impl Into<Ramp<C>>) -> Result<Verdict<C>, Error> {
        self.engine.hold(&inside(&load.into()), &self.settings).map(outside)
    }

    /// The equilibrium under a load, or the proof that no equilibrium exists; undecided if neither is found.
    ///
    /// If several equilibria exist, one in which every contact sticks is returned before any other. [`FoundBy`](crate::equilibrium::FoundBy) says by
    /// which method the equilibrium was found.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Outcome, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // 4 N downwards stretch two tangential springs of 800 N/m; each contact carries half.
    /// let outcome = grasp.solve(Wrench::force([0.0, -4.0]))?;
    /// let held = outcome.equilibrium().expect("friction carries up to 10 N");
    /// assert!((held.twist.translation()[1] - -4.0 / 1600.0).abs() < 1e-15);
    /// assert!((held.contacts[0].friction_used() - 2.0 / 10.0).abs() < 1e-15);
    ///
    /// assert!(matches!(grasp.solve(Wrench::force([0.0, -11.0]))?, Outcome::NoEquilibrium(_)));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50; [`Error::KineticFriction`] if a contact slides whose [kinetic
    /// friction](crate::grasp::Contact::kinetic) is lower.
    pub fn solve(&self, load: impl Into<Wrench<C>>) -> Result<Outcome<C>, Error> {
        self.engine.solve(&inside(&load.into()), &self.settings).map(outside)
    }

    /// Returns an error that names the method `question` if the grasp has joints or several bodies.
    pub(crate) fn refuse_hands(&self, question: &'static str) -> Result<(), Error> {
        self.engine.refuse_hands(question)
    }

    /// Whether the grasp is in the plane or in space.
    pub(crate) fn space(&self) -> Space {
        self.engine.space()
    }

    /// Whether some force acts before any load is applied: from a command, a constant force, a vacuum or a permanent load of a body.
    pub(crate) fn presses(&self) -> bool {
        self.engine.presses()
    }

    /// Whether the grasp has a squeeze, the commands and forces that [`Self::squeezed`] multiplies: a nonzero command, constant force or torque, or
    /// vacuum. Joints and tendons count, too.
    pub(crate) fn is_squeezed(&self) -> bool {
        self.engine.is_squeezed()
    }

    /// Whether contacts overlap, i.e. have clearances below zero.
    pub(crate) fn overlaps(&self) -> bool {
        self.engine.overlaps()
    }

    /// Whether this contact point has a command, constant force or vacuum of its own, and no joint or tendon of the grasp is driven.
    pub(crate) fn is_set_by_itself(&self, point: usize) -> bool {
        self.engine.is_commanded(point) && !self.engine.is_hand_driven()
    }

    /// Whether all forces except the caller's loads scale with the squeeze ([`Self::squeezed`]), so that twice the squeeze holds twice the load.
    /// Clearances, permanent loads, external torques, tendons and limits of joints prevent this.
    pub(crate) fn is_proportional(&self) -> bool {
        self.engine.is_proportional()
    }

    /// Whether some body has a permanent load or a weight.
    pub(crate) fn is_loaded_at_rest(&self) -> bool {
        self.engine.bodies().is_some_and(|bodies| bodies.loads.iter().any(|load| *load != Wrench::ZERO))
    }

    /// Names of the bodies that have permanent loads other than their weights.
    pub(crate) fn loaded_bodies(&self) -> Vec<String> {
        self.engine.loaded_bodies()
    }

    /// The verdict on a load. Also [`PathFacts`]: how near the load path comes to the limits of small motions, its equilibrium at rest, and its
    /// number of jumps. `extent` says which fields of the verdict are computed.
    pub(crate) fn hold_to_an_extent(
        &self,
        load: &Ramp<C>,
        extent: VerdictScope,
    ) -> Result<(Verdict<C>, PathFacts), Error> {
        let (verdict, more) = self.engine.hold_with(&inside(load), &self.settings, extent)?;
        Ok((outside(verdict), more))
    }

    /// A brief verdict on a load. It lacks equilibria, proofs and the data that only its sentence in words needs. The second value is the largest
    /// ratio of a rotation, slip or opening to its limit of small motions, on the part of the path that was followed.
    pub(crate) fn hold_briefly(&self, load: &Ramp<C>) -> Result<(Verdict<C>, f64), Error> {
        let (verdict, more) = self.engine.hold_with(&inside(load), &self.settings, VerdictScope::Brief)?;
        Ok((outside(verdict), more.farthest))
    }

    /// The magnitude (N) and unit direction of the least force through a point (m) that is too large for the theory of small motions. Under it a
    /// rotation, slip or opening exceeds its limit while every contact sticks. The force acts in addition to a base load. `None` if no force has this
    /// effect.
    pub(crate) fn farthest_direction(
        &self,
        base: &Wrench<C>,
        point: [f64; 3],
    ) -> Result<Option<(f64, [f64; 3])>, Error> {
        self.engine.farthest_direction(&inside(base), point, &self.settings)
    }

    /// The least margin of sticking under the base load, as a fraction of the largest force. The margin is the distance, N, of a contact force from
    /// the boundary of its friction cone or from opening. It is computed as if every contact stuck, and negative outside the cone. `None` if all
    /// forces are zero, or if nothing resists the load.
    pub(crate) fn sticking_margin(&self, base: &Wrench<C>) -> Option<f64> {
        self.engine.sticking_margin(&inside(base), &self.settings)
    }

    /// Static questions: which loads some contact forces could balance, whatever the springs and commands.
    #[must_use]
    pub fn statics(&self) -> Statics<'_, C> {
        Statics(self)
    }

    /// Questions about derivatives of answers with respect to the data of the grasp.
    #[must_use]
    pub fn sensitivity(&self) -> Sensitivity<'_, C> {
        Sensitivity(self)
    }

    /// Questions about the quadratic program of minimum energy, compared with the complementarity problem.
    #[must_use]
    pub fn energy(&self) -> Energy<'_, C> {
        Energy(self)
    }

    /// Number of contacts, at least 1; each point of a soft fingertip is one contact.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a grasp is never empty")]
    pub fn len(&self) -> usize {
        self.engine.len()
    }

    /// The contacts as given, with their commands in the contact frames; the points of a soft fingertip one by one.
    pub fn contacts(&self) -> &[Contact<C>] {
        &self.door().contacts
    }

    /// The contact frames, orthonormal columns n, t (and t₂): `frame * force` is along the coordinate axes. In space each is a rotation matrix, which
    /// [`Rotation3::from_matrix_unchecked`](nalgebra::Rotation3::from_matrix_unchecked) accepts. In the plane it is a reflection, since
    /// `t = (n_y, -n_x)` lies clockwise of n.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::{Rotation3, Vector3};
    /// use grasp_lcp::spatial::{Contact, Grasp};
    ///
    /// let grasp = Grasp::new([Contact::new([0.0; 3], [0.0, 0.0, -2.0]).series_stiffness(1.0, 1.0)])?;
    /// for frame in grasp.frames() {
    ///     assert_eq!(frame.column(0), -Vector3::z());
    ///     assert_eq!(Rotation3::from_matrix_unchecked(*frame).matrix().determinant(), 1.0);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn frames(&self) -> impl ExactSizeIterator<Item = &SMatrix<f64, C, C>> {
        self.door().frames.iter()
    }

    /// Commands of the joints of the hand, then of its tendons, rad and m; empty without a hand.
    #[must_use]
    pub fn joint_commands(&self) -> &[f64] {
        self.engine.joint_commands()
    }

    /// Name of a joint, tendon or finger of the hand in pictures and messages; its kind and number if the user gave no name.
    #[must_use]
    pub fn label_of(&self, part: HandPart) -> String {
        self.engine.label_of(part)
    }

    /// End points of the rigid links of the hand, m, in the initial posture, for pictures. A link leads from one revolute joint to the next, or from
    /// the last joint to a contact.
    #[must_use]
    pub fn links(&self) -> &[[SVector<f64, C>; 2]] {
        &self.door().links
    }

    /// Centre of each joint of the hand, m, in the initial posture, for pictures. `None` for a prismatic joint, and for a joint given by Jacobians
    /// alone.
    #[must_use]
    pub fn joint_centres(&self) -> &[Option<SVector<f64, C>>] {
        &self.door().joint_centres
    }
}

impl<const C: usize> Hand<C> {
    /// The grasp of an object by this hand, with any number of joints. For each [`Link`](crate::grasp::Link) with a
    /// given tension, the command of its spring is computed.
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`] without contacts; [`Error::Hand`] with the joint, tendon or finger, the field and the allowed values; [`Error::Contact`]
    /// with the first contact, field and value out of range.
    pub fn grasp(self) -> Result<Grasp<C>, Error> {
        const { assert_plane_or_space::<C>() };
        Grasp::installed_by(self.into_inside().engine(None)?)
    }
}

impl<const C: usize> Bodies<C> {
    /// The grasp of these bodies. In its answers "the object" is the body that loads act on.
    ///
    /// # Errors
    /// [`Error::Body`] with the name of the body and the fault; also the errors of [`Hand::grasp`].
    pub fn grasp(self) -> Result<Grasp<C>, Error> {
        const { assert_plane_or_space::<C>() };
        let (hand, bodies) = self.checked()?;
        Grasp::installed_by(hand.into_inside().engine(Some(bodies))?)
    }
}

/// The engine of a grasp without joints. A contact with a given normal force is carried by a prismatic joint without a spring, along which the force
/// stays constant however the contact moves.
fn engine_of_contacts(contacts: Vec<Contact<3>>) -> Result<Engine, Error> {
    if contacts.iter().any(|contact| contact.force.is_some()) {
        return Hand::new(contacts.into_iter().map(Finger::fixed)).engine(None);
    }
    Engine::new(contacts)
}
