//! A grasp: the contacts that were given, checked, with what the arithmetic needs of them.

use nalgebra::{SMatrix, SVector};

use super::contact::Contact;
use super::hand::{Drive, HandPart, Linkage};
use super::remembered::Remembered;
use super::rotation::{assert_plane_or_space, assert_room_for_joints};
use super::site::Site;
use crate::error::{Error, Field, LARGEST, MODERATE, is_moderate};
use crate::numerics::anew;

/// An object held by elastic fingers: a checked list of contacts.
///
/// The reference point of wrenches and twists is the origin of the coordinates in which the contact
/// points are given.
///
/// | what you want | method |
/// |---|---|
/// | where the object goes and what contacts carry under a load, or the proof that nothing holds | [`solve`](Self::solve) |
/// | the load at which the first contact slides | [`onset_of_sliding`](Self::onset_of_sliding), with commands [`onset`](Self::onset) |
/// | the angle at which it slides while a weight is tilted | [`onset_of_turn`](Self::onset_of_turn) |
/// | what comes just beyond an onset | [`beyond`](Self::beyond), [`state_at_onset`](Self::state_at_onset) |
/// | onset and limit load side by side | [`reserve`](Self::reserve) |
/// | every event of a load program, with slip memory | [`follow`](Self::follow); thousands of contacts [`follow_patch`](Self::follow_patch); on the round cone in steps [`follow_in_steps`](Self::follow_in_steps) |
/// | how much squeeze suffices | [`least_squeeze`](Self::least_squeeze) |
/// | the direction in which the least force slides | [`weakest_direction`](Self::weakest_direction) |
/// | how an answer changes with the data | [`onset_gradients`](Self::onset_gradients), [`sensitivity`](Self::sensitivity), [`response`](Self::response) |
/// | how far an onset spreads where data are not known exactly | [`robust_onset`](Self::robust_onset), [`least_onset_within`](Self::least_onset_within) |
/// | whether fingers could hold it at all | [`force_closure`](Self::force_closure), [`form_closure`](Self::form_closure), [`ferrari_canny`](Self::ferrari_canny), [`load_limit`](Self::load_limit) |
/// | all equilibria under a load, the error of one | [`equilibria`](Self::equilibria), [`accuracy`](Self::accuracy), [`distinct`](Self::distinct) |
/// | many questions on all cores | [`solve_each`](Self::solve_each), [`onset_each`](Self::onset_each), [the room](crate::sweep) |
/// | what the paper's quadratic program says | [`minimum_energy`](Self::minimum_energy), [`compare_with_minimum_energy`](Self::compare_with_minimum_energy) |
#[derive(Debug, Clone)]
pub struct Grasp<const D: usize, const C: usize> {
    contacts: Vec<Contact<C>>,
    sites: Vec<Site<D, C>>,
    /// Centroid of the contact points: inside, moments and rotations are taken about it, so that a
    /// far away reference point costs no digits.
    pub(super) origin: SVector<f64, C>,
    /// Root mean square distance of the contact points from their centroid: inside, the unit of
    /// length of arms, so that rotations and translations have comparable size whatever the user's
    /// unit.
    pub(super) length: f64,
    /// The joints behind the contacts, if any.
    pub(super) linkage: Option<Box<Linkage<D, C>>>,
    /// The factors of the elastic trial.
    trial: Remembered,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Checks the contacts and lays out their frames.
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
    /// [`Error::EmptyGrasp`], or [`Error::Contact`] naming the first contact, field and value that
    /// is out of range.
    pub fn new(contacts: impl IntoIterator<Item = Contact<C>>) -> Result<Self, Error> {
        const { assert_plane_or_space::<D, C>() };
        Self::of(contacts.into_iter().collect())
    }

    /// A grasp by contacts that joints move.
    pub(super) fn by_hand(contacts: Vec<Contact<C>>, linkage: Linkage<D, C>) -> Result<Self, Error> {
        const { assert_room_for_joints::<D, C>() };
        let mut grasp = Self::of(contacts)?;
        for (site, motions) in grasp.sites.iter_mut().zip(&linkage.motions) {
            site.move_with(motions, &linkage.lengths);
        }
        grasp.sites.extend(linkage.drives.iter().map(Drive::site));
        grasp.linkage = Some(Box::new(linkage));
        Ok(grasp)
    }

    /// This grasp with other data of its contacts, at the same places, and with own springs of joints and tendons so many times as stiff.
    pub(crate) fn with_data(
        &self,
        contacts: Vec<Contact<C>>,
        stiffer: impl Fn(usize) -> f64,
    ) -> Result<Self, Error> {
        match &self.linkage {
            None => Self::of(contacts),
            Some(linkage) => Self::by_hand(contacts, linkage.stiffened(stiffer)),
        }
    }

    /// Ends of the hand's links, from revolute joint to revolute joint and on to the contacts, m, before anything moves: for pictures.
    pub fn links(&self) -> impl Iterator<Item = &[SVector<f64, C>; 2]> {
        self.linkage().into_iter().flat_map(|linkage| &linkage.bones)
    }

    /// Where each joint of the hand turns, m, before anything moves: for pictures. `None` for what slides, or is known by Jacobians alone.
    pub fn joint_centres(&self) -> impl Iterator<Item = Option<SVector<f64, C>>> {
        self.linkage().into_iter().flat_map(|linkage| linkage.centres.iter().copied())
    }

    /// The contacts alone, without the hand behind them.
    #[cfg(feature = "plot")]
    pub(crate) fn without_hand<const N: usize>(&self) -> Grasp<N, C> {
        let (contacts, origin, length) = (self.contacts.clone(), self.origin, self.length);
        let narrow = |site: &Site<D, C>| site.of_the_object();
        let sites = self.sites[..self.len()].iter().map(narrow).collect();
        Grasp { contacts, sites, origin, length, linkage: None, trial: Remembered::default() }
    }

    fn of(contacts: Vec<Contact<C>>) -> Result<Self, Error> {
        if contacts.is_empty() {
            return Err(Error::EmptyGrasp);
        }
        for (index, contact) in contacts.iter().enumerate() {
            contact.check(index)?;
        }
        let contacts: Vec<_> = contacts.into_iter().map(Contact::resolved).collect();
        let count = contacts.len() as f64;
        let origin = contacts.iter().fold(SVector::zeros(), |sum, c| sum + c.point / count);
        let spread = contacts.iter().map(|c| (c.point - origin).norm_squared() / count).sum::<f64>().sqrt();
        // A single point has no size of its own; then any unit of length does.
        let length = if spread * LARGEST > 1.0 { spread } else { 1.0 };
        let site = |(index, contact)| Site::new(contact, index, &origin, length);
        let sites = contacts.iter().enumerate().map(site).collect::<Result<_, Error>>()?;
        Ok(Self { contacts, sites, origin, length, linkage: None, trial: Remembered::default() })
    }

    /// Number of contacts, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a grasp is never empty")]
    pub fn len(&self) -> usize {
        self.contacts.len()
    }

    /// The contacts as they were given, their commands in the contact frames.
    #[must_use]
    pub fn contacts(&self) -> &[Contact<C>] {
        &self.contacts
    }

    /// The contact frames, orthonormal columns n, t (and t₂): `frame * force` is along the
    /// coordinate axes. In space each is a rotation,
    /// [`Rotation3::from_matrix_unchecked`](nalgebra::Rotation3::from_matrix_unchecked) takes it;
    /// in the plane it is a reflection, since `t = (n_y, -n_x)` lies clockwise of n.
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
        self.sites[..self.len()].iter().map(|site| &site.frame)
    }

    /// This grasp with other finger commands u_f, one a contact, each in its contact frame (m):
    /// arrays, or vectors.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let squeezed = grasp.with_commands([[0.03, 0.0]; 2])?;
    /// let outcome = squeezed.solve(&Wrench::ZERO)?;
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 30.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Size`] if there are more or fewer than contacts, [`Error::Contact`] if one is not
    /// finite.
    pub fn with_commands(
        mut self,
        commands: impl IntoIterator<Item = impl Into<[f64; C]>>,
    ) -> Result<Self, Error> {
        let commands: Vec<_> = commands.into_iter().map(|u| SVector::from(u.into())).collect();
        self.check_commands(&commands, "commands", Field::Command)?;
        for (contact, command) in self.contacts.iter_mut().zip(commands) {
            contact.command = command;
        }
        Ok(self)
    }

    /// This grasp with other commands of the joints and then of the tendons of its hand, rad and m.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint, Wrench};
    /// use grasp_lcp::planar::Contact;
    ///
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e9, 1e9).friction(0.5))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp::<5>()?.with_joint_commands(&[0.01, 0.01])?;
    /// let outcome = grasp.solve(&Wrench::ZERO)?;
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 10.0).abs() < 1e-4);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::JointCommands`] if there are more or fewer than joints and tendons, [`Error::Hand`] if one is not finite.
    pub fn with_joint_commands(mut self, commands: &[f64]) -> Result<Self, Error> {
        self.check_joint_commands(commands, "joint commands")?;
        if let Some(linkage) = &mut self.linkage {
            linkage.commands.copy_from_slice(commands);
        }
        Ok(self)
    }

    pub(crate) fn check_joint_commands(&self, commands: &[f64], what: &'static str) -> Result<(), Error> {
        let expected = self.joint_commands().len();
        if commands.len() != expected {
            return Err(Error::JointCommands { what, given: commands.len(), expected });
        }
        match commands.iter().position(|x| !is_moderate(*x)) {
            Some(k) => Err(Error::Hand {
                what: format!("{what}, number {k}"),
                field: "command",
                value: commands[k],
                allowed: MODERATE,
            }),
            None => Ok(()),
        }
    }

    /// Commands of the joints of the hand, then of its tendons, rad and m; empty without a hand.
    #[must_use]
    pub fn joint_commands(&self) -> &[f64] {
        self.linkage.as_ref().map_or(&[], |linkage| &linkage.commands)
    }

    /// How pictures and messages call a part of the hand: its name, or what it is and its number.
    #[must_use]
    pub fn label_of(&self, part: HandPart) -> String {
        self.linkage.as_ref().map_or_else(String::new, |linkage| linkage.label(part))
    }

    /// For questions that know no joints.
    pub(crate) fn refuse_hands(&self, question: &'static str) -> Result<(), Error> {
        if self.linkage.is_some() { Err(Error::NotForHands { question }) } else { Ok(()) }
    }

    /// The drives of a joint or, behind the joints, of a tendon, with the numbers of their sites.
    pub(crate) fn drives_of(&self, actuator: usize) -> impl Iterator<Item = (usize, &Drive<D>)> {
        let first = self.len();
        self.linkage()
            .into_iter()
            .flat_map(move |linkage| linkage.of_actuator(actuator))
            .map(move |(k, drive)| (first + k, drive))
    }

    /// The joints behind the contacts, if any.
    pub(crate) fn linkage(&self) -> Option<&Linkage<D, C>> {
        self.linkage.as_deref()
    }

    pub(crate) fn check_commands(
        &self,
        commands: &[SVector<f64, C>],
        what: &'static str,
        field: Field,
    ) -> Result<(), Error> {
        if commands.len() != self.len() {
            return Err(Error::Size { what, given: commands.len(), expected: self.len() });
        }
        for (index, (contact, command)) in self.contacts.iter().zip(commands).enumerate() {
            if let Some(&value) = command.iter().find(|x| !is_moderate(**x)) {
                return Err(Error::Contact {
                    contact: contact.label(index),
                    field,
                    value,
                    allowed: MODERATE,
                });
            }
        }
        Ok(())
    }

    /// Where the factors of the elastic trial are kept.
    pub(crate) fn remembered_trial(&self) -> &Remembered {
        &self.trial
    }

    pub(crate) fn sites(&self) -> &[Site<D, C>] {
        &self.sites
    }

    /// What every site is driven by: a_i of the contacts, commands in the contact frames, the normal part less the clearance; then those of
    /// the drives of a hand.
    pub(crate) fn drives(&self) -> Vec<SVector<f64, C>> {
        let mut drives = Vec::new();
        self.drives_into(&mut drives);
        drives
    }

    /// [`Self::drives`] in memory that is there.
    pub(crate) fn drives_into(&self, drives: &mut Vec<SVector<f64, C>>) {
        self.driven_by(self.contacts.iter().map(|contact| contact.command), self.joint_commands(), drives);
    }

    /// The drives with other commands.
    pub(crate) fn driven_by(
        &self,
        commands: impl Iterator<Item = SVector<f64, C>>,
        of_joints: &[f64],
        drives: &mut Vec<SVector<f64, C>>,
    ) {
        anew(drives, self.sites.len());
        drives.extend(commands.zip(&self.contacts).map(|(mut a, contact)| {
            a[0] -= contact.clearance;
            a
        }));
        if let Some(linkage) = self.linkage() {
            drives.extend(linkage.stretches(of_joints));
        }
    }

    /// What the drives change by with these changes of commands; without any they stay.
    pub(crate) fn drive_changes(
        &self,
        commands: Option<&[SVector<f64, C>]>,
        of_joints: Option<&[f64]>,
    ) -> Vec<SVector<f64, C>> {
        let mut changes = Vec::new();
        self.changed_by(commands.into_iter().flatten().copied(), of_joints, &mut changes);
        changes
    }

    /// [`Self::drive_changes`] in memory that is there; commands that are missing stay.
    pub(crate) fn changed_by(
        &self,
        commands: impl Iterator<Item = SVector<f64, C>>,
        of_joints: Option<&[f64]>,
        changes: &mut Vec<SVector<f64, C>>,
    ) {
        anew(changes, self.sites.len());
        changes.extend(commands);
        changes.resize(self.len(), SVector::zeros());
        match (self.linkage(), of_joints) {
            (Some(linkage), Some(commands)) => changes.extend(linkage.changes(commands)),
            _ => changes.resize(self.sites.len(), SVector::zeros()),
        }
    }
}
