//! The geometric stiffness, which the theory of small motions neglects. As the object turns, the lever arms of the forces that act already turn with
//! it. A drive is the spring of a joint or tendon of a hand.
//!
//! Let contact i carry the force F_i and move by u_i with the motion q of the object. The energy of the springs has a second derivative in two parts,
//! the elastic part and `-Σ F_i · ∂²u_i/∂q²`. For a rotation θ and arms r_i of the contacts the second part is `Σ (F·r) |θ|² - (F·θ)(r·θ)`, in the
//! plane `Σ F·r θ²`. Fingers that press against each other make this part negative. The second part is compared with the work `W·q` of the load W
//! along the motion. This work equals `q·Kq` with the secant stiffness K of the grasp.
//!
//! Loads are treated like contact forces, at their points of action. A load of which only the line is known adds nothing. In the plane that is exact
//! if it acts at the point of its line nearest to the centroid of the contacts.
//!
//! The joints of a finger turn its links. A contact force F on the object then takes from their stiffness if the finger pushes along its length.
//!
//! The forces may also buckle the grasp in a motion that the load does not cause, as for a strut in line with its load. Therefore the second part is
//! compared with the elastic part in every motion, too, for one object and for several bodies.

use nalgebra::{SMatrix, SVector};

use super::answer::Equilibrium;
use super::contact_answer::ContactAnswer;
use super::too_far::TooFar;
use crate::contact::State;
use crate::grasp::{Engine, Hold, PointsOfAction, Site, Wrench, size_of};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{
    IntoList, PositiveBand, Square, Vector, chosen, dot, mapped, matrix_of, symmetric_eigen,
};
use crate::object::tangent_stiffness;
use crate::prelude::*;
use crate::words::LinkKind;

impl Engine {
    /// The fraction [`Verdict::left_out`](crate::hold::Verdict::left_out) of the resistance that geometric stiffness adds or takes away in the
    /// equilibrium `there`. Without the equilibrium `rest`, from which only the load has changed, only what forces take in `there` counts. `None` if
    /// `there` buckles or turns over.
    pub(crate) fn left_out_between(
        &self,
        rest: Option<&Equilibrium<3>>,
        there: &Equilibrium<3>,
    ) -> Option<f64> {
        if there.too_far.as_ref().is_some_and(TooFar::is_unstable) {
            return None;
        }
        // The first fraction does not count the turning of the load. If the points of action of the load are known, it is already decided whether
        // the grasp buckles. A fraction of -1 or less, which contradicts that decision, is then dropped.
        let is_undecided = |part: &f64| *part > -1.0 || !self.may_buckle(&there.load);
        let by_the_load =
            rest.and_then(|rest| self.left_out_by_small_motions(rest, there)).filter(is_undecided);
        let by_forces = self.taken_by_forces(there, &there.load);
        let by_rotations = rest.and_then(|rest| self.lost_resistance(rest, there));
        [by_the_load, by_forces, by_rotations].into_iter().flatten().min_by(f64::total_cmp)
    }

    /// The geometric stiffness as a fraction of the resistance to the motion q: `Σ [(F·r) |θ|² - (F·θ)(r·θ)] / (ΔW·q)`. The motion q leads from the
    /// equilibrium `rest` under the base load, which acts before the load of the question grows, to the equilibrium `there`, with the same commands.
    /// F are the contact forces in `rest`, and r their arms about the origin of twists, the centroid of the contacts. θ is the rotation in q, and ΔW
    /// the change of the load.
    ///
    /// The fraction is negative if the forces lower the resistance. The geometric stiffness of the base load is not included. `None` if the size of the
    /// fraction is at most [`LEAST_FRACTION`], or for several bodies, or if `ΔW·q` is not positive.
    fn left_out_by_small_motions(&self, rest: &Equilibrium<3>, there: &Equilibrium<3>) -> Option<f64> {
        if self.bodies().is_some() {
            return None;
        }
        let (load, twist) = (there.load - rest.load, there.twist.components());
        let moved = twist.iter().zip(rest.twist.components()).map(|(to, from)| to - from);
        let moved: Vec<f64> = moved.list();
        let kept: f64 = dot(&moved, load.components());
        // Twists have six components here: translations, then rotations. In the plane only the last rotation, about the axis out of the plane, is not
        // zero.
        let rotation: SVector<f64, 3> = SVector::from_column_slice(&moved[3..]);
        let left_out = rotation.dot(
            &(self.stiffness_of_arms(0, self.origin(), &forces_in(&rest.contacts), &Wrench::ZERO) * rotation),
        );
        (kept > 0.0).then(|| left_out / kept).filter(|part| part.abs() > LEAST_FRACTION)
    }

    /// Minus the largest fraction of the springs' resistance that the contact forces of an equilibrium take away, over all motions that springs
    /// resist. This value is -1/t for the least t for which `K + t K_g` is not positive definite. K is the stiffness if all closed contacts
    /// stick, and K_g the geometric stiffness of the contact forces.
    ///
    /// `None` if the size of the fraction is below [`LEAST_TAKEN`]. `None` also for a grasp with more than
    /// [`MOST_COORDINATES`].
    fn taken_by_forces(&self, there: &Equilibrium<3>, load: &Wrench<3>) -> Option<f64> {
        let (mut stable, mut unstable) = (0.0, 1.0 / LEAST_TAKEN);
        let stiffness =
            self.unstable_at(unstable, &forces_in(&there.contacts), &is_open_in(&there.local.states), load)?;
        // Thirty bisections of the factor t give nine digits, of which two are printed.
        for _ in 0..30 {
            let middle = 0.5 * (stable + unstable);
            *(if is_stable(&stiffness, middle) { &mut stable } else { &mut unstable }) = middle;
        }
        Some(-1.0 / unstable)
    }

    /// Whether the grasp buckles under the contact forces `forces`, N, along the coordinate axes, and the load `load`. It buckles if `K + K_g` is not
    /// positive definite on the motions that springs resist, with the stiffness K and the geometric stiffness K_g. Stability along all other motions
    /// is decided in `turns_over`.
    pub(crate) fn buckles(
        &self,
        forces: &[SVector<f64, 3>],
        is_open: &(dyn Fn(usize) -> bool + Sync),
        load: &Wrench<3>,
    ) -> bool {
        self.unstable_at(1.0, forces, is_open, load).is_some()
    }

    /// Whether the grasp buckles in an equilibrium with these contacts under this load. Also false if the load's points of action are unknown, or if
    /// the grasp has more than [`MOST_COORDINATES`].
    pub(super) fn buckles_in(
        &self,
        contacts: &[ContactAnswer<3>],
        states: &[State],
        load: &Wrench<3>,
    ) -> bool {
        self.may_buckle(load) && self.buckles(&forces_in(contacts), &is_open_in(states), load)
    }

    /// Whether [`Self::buckles`] answers for this load: its points of action are known, and the grasp has at most [`MOST_COORDINATES`].
    pub(crate) fn may_buckle(&self, load: &Wrench<3>) -> bool {
        self.is_asked_for_buckling() && self.acts_at_known_points(load)
    }

    /// Whether the grasp has at most [`MOST_COORDINATES`], so that it is asked whether it buckles.
    pub(crate) fn is_asked_for_buckling(&self) -> bool {
        size_of(self.sites()).count() <= MOST_COORDINATES
    }

    /// Whether the points of action of the load on every body are known.
    pub(crate) fn acts_at_known_points(&self, load: &Wrench<3>) -> bool {
        self.loads_of_bodies(load).iter().all(|load| load.points_of_action().stiffness().is_some())
    }

    /// Two matrices: the stiffness K if all closed contacts stick, and the geometric stiffness K_g. `None` unless K is positive definite, and `K + t
    /// K_g` is not, for t = `times`. Motions that springs do not resist cannot buckle here: K gets a stiffness along them as large as its largest
    /// eigenvalue, and K_g none. `None` also if the grasp has more than [`MOST_COORDINATES`].
    fn unstable_at(
        &self,
        times: f64,
        forces: &[SVector<f64, 3>],
        is_open: &(dyn Fn(usize) -> bool + Sync),
        load: &Wrench<3>,
    ) -> Option<(Square, Square)> {
        if !self.is_asked_for_buckling() {
            return None;
        }
        let mut both = self.stiffnesses(forces, is_open, load);
        // A grasp that is stable in every motion does not buckle, so its free motions (which no spring resists) need not be found.
        if is_stable(&both, times) {
            return None;
        }
        let (resisted, largest) = self.resisted_motions(&both.0);
        both.1 = &(&resisted * &both.1) * &resisted;
        add_to_free_motions(&mut both.0, (&resisted, largest));
        (!is_stable(&both, times) && is_stable(&both, 0.0)).then_some(both)
    }

    /// The stiffness K if all closed contacts stick, and the geometric stiffness K_g of the contact forces `forces`, N, along the coordinate axes, and
    /// of the load.
    pub(super) fn stiffnesses(
        &self,
        forces: &[SVector<f64, 3>],
        is_open: &(dyn Fn(usize) -> bool + Sync),
        load: &Wrench<3>,
    ) -> (Square, Square) {
        let springs =
            |i: usize| if is_open(i) { SMatrix::zeros() } else { sticking_springs(&self.sites()[i]) };
        (tangent_stiffness(self.sites(), &springs), self.geometric_stiffness(forces, load))
    }

    /// The projection matrix on the motions that springs with the stiffness K resist, and the largest eigenvalue of K.
    pub(super) fn resisted_motions(&self, stiffness: &Square) -> (Square, f64) {
        let size = size_of(self.sites());
        let count = size.count();
        let (values, motions) = symmetric_eigen(&matrix_of(count, count, &|i, j| stiffness[(i, j)]));
        let mut resisted = Square::zeros(size);
        for k in 0..count {
            resisted[(k, k)] = 1.0;
        }
        for k in chosen(count, &|k| values[*k] <= NEGLIGIBLE * values[0]) {
            let motion = &motions.as_slice()[k * count..][..count];
            resisted.add_product(&mapped(motion, &|x| -x), motion);
        }
        (resisted, values[0])
    }

    /// The geometric stiffness of contact forces F in the engine's coordinates: for the rotation θ of each body `Σ [(F·r) |θ|² - (F·θ)(r·θ)]`.
    /// The arms r of the forces are about the point to which the coordinates of the body refer. A rope or spring with the pull T and the length L
    /// adds `T |u|²/L` for the displacement u of one end relative to the other, across the rope. Joints of a hand turn the displacements behind them.
    pub(crate) fn geometric_stiffness(&self, forces: &[SVector<f64, 3>], load: &Wrench<3>) -> Square {
        let mut stiffness = Square::zeros(size_of(self.sites()));
        let (axes, object) = (self.space().axes(), self.space().of_the_object());
        let (bodies, loads) = (self.bodies(), self.loads_of_bodies(load));
        for body in 0..bodies.map_or(1, |bodies| bodies.places.len()) {
            let (first, centre) = self.reference_of(body);
            let length = |k: usize| self.rotation_length(first, k);
            let of_body = self.stiffness_of_arms(body, &centre, forces, &loads[body]);
            let axis = |k: usize| if axes == 3 { k } else { 2 };
            for k in 0..object - axes {
                for l in 0..object - axes {
                    stiffness[(first + axes + k, first + axes + l)] =
                        of_body[(axis(k), axis(l))] / (length(k) * length(l));
                }
            }
        }
        if let Some(linkage) = self.linkage() {
            for contact in forces.iter().enumerate().take(self.len()) {
                linkage.add_geometric_stiffness(contact, object, &mut stiffness);
            }
        }
        for (i, force) in forces.iter().enumerate() {
            let (Some(length), site) = (self.rope(i), &self.sites()[i]) else { continue };
            let pull = force.dot(&site.frame.column(0).into_owned());
            for across in [1, 2].map(|axis| self.across(i, axis)) {
                stiffness.add_product((&across * (pull / length)).as_slice(), across.as_slice());
            }
        }
        stiffness
    }

    /// The displacement of a rope's or spring's first end relative to its other end, along an axis of its frame, per unit of each coordinate. The grasp
    /// map takes the second body's displacement at the first end.
    pub(crate) fn across(&self, site: usize, axis: usize) -> Vector {
        let mut across = self.sites()[site].map.column(axis);
        let Some(body) = self.bodies().and_then(|bodies| bodies.sides[site].1) else { return across };
        let (first, _) = self.reference_of(body);
        let along = self.sites()[site].frame.column(axis).into_owned();
        let moments = self.space().wrench_of(&self.contacts()[site].normal, &along);
        for k in 0..self.space().planes().len() {
            let at = self.space().axes() + k;
            across[first + at] -= moments[at] / self.rotation_length(first, k);
        }
        across
    }

    /// The length, m, of a rope or spring between two points; `None` for other contacts and drives.
    pub(crate) fn rope(&self, site: usize) -> Option<f64> {
        let contact = self.contacts().get(site)?;
        matches!(contact.link, Some(LinkKind::Cable | LinkKind::Spring)).then(|| contact.normal.norm())
    }

    /// The point at which the force of a contact acts on the body on its other side, m: the contact point, or the other end of a rope or spring.
    pub(super) fn far_end(&self, site: usize) -> SVector<f64, 3> {
        let contact = &self.contacts()[site];
        if self.rope(site).is_some() { contact.point + contact.normal } else { contact.point }
    }

    /// The index of the first coordinate of a body, and the point to which its coordinates refer, m.
    pub(super) fn reference_of(&self, body: usize) -> (usize, SVector<f64, 3>) {
        let place = self.bodies().map(|bodies| &bodies.places[body]).filter(|place| place.first > 0);
        place.map_or((0, *self.origin()), |place| (place.first, place.centre))
    }

    /// The length, m, by which the rotation k of a body is multiplied in its coordinates; `first` is the index of the body's first coordinate.
    pub(super) fn rotation_length(&self, first: usize, k: usize) -> f64 {
        match (self.linkage(), first) {
            (None, _) | (_, 0) => self.length(),
            (Some(linkage), _) => linkage.lengths[first + self.space().axes() + k],
        }
    }

    /// The symmetric matrix M of a body's rotation θ with `θ·Mθ = Σ [(F·r) |θ|² - (F·θ)(r·θ)]`, N m. F are the contact forces on the body and the
    /// forces of `load`, if their points are known. The arms r are about `centre`. In the plane θ is along the third axis, and forces and arms have
    /// no component along this axis.
    fn stiffness_of_arms(
        &self,
        body: usize,
        centre: &SVector<f64, 3>,
        forces: &[SVector<f64, 3>],
        load: &Wrench<3>,
    ) -> SMatrix<f64, 3, 3> {
        let mut sum = PointsOfAction::NO_FORCE;
        for (i, (contact, force)) in self.contacts().iter().zip(forces).enumerate() {
            let sign = self.bodies().map_or(1.0, |bodies| bodies.sign(i, body));
            let point = if sign < 0.0 { self.far_end(i) } else { contact.point };
            sum = sum.moved(&(force * sign), &(point - centre));
        }
        let load = load.points_of_action().moved(&load.force_part(), &-centre);
        [sum, load].iter().filter_map(|points| points.stiffness()).sum()
    }
}

/// Whether a contact is open, or the spring of a joint or tendon yields, by index.
fn is_open_in(states: &[State]) -> impl Fn(usize) -> bool + Sync + '_ {
    move |i| states[i].is_open()
}

pub(crate) fn forces_in(contacts: &[ContactAnswer<3>]) -> Vec<SVector<f64, 3>> {
    mapped(contacts, &|answer| answer.force_world)
}

/// Number of coordinates up to which a grasp is asked whether it buckles: forty bodies in the plane, twenty in space.
///
/// If larger, each equilibrium takes longer, as the cube of this number. If smaller, stacks and linkages that buckle are said to hold.
const MOST_COORDINATES: usize = 120;

/// Largest fraction of the resistance to a motion of which answers say nothing if small motions leave it out.
///
/// A smaller value would add a caution to ordinary verdicts; a larger value would hide a loss of stability until it is near.
pub(crate) const LEAST_FRACTION: f64 = 0.1;

/// The least size of the fraction that [`Engine::taken_by_forces`] returns. A smaller value would add a caution to ordinary squeezes of soft fingers;
/// a larger value would leave too little reserve before the grasp buckles.
const LEAST_TAKEN: f64 = 0.5;

/// Adds the stiffness `largest` to the stiffness matrix along the motions that springs do not resist; `resisted` is the projection on all others.
pub(super) fn add_to_free_motions(stiffness: &mut Square, (resisted, largest): (&Square, f64)) {
    let count = stiffness.size().count();
    for j in 0..count {
        for i in 0..count {
            stiffness[(i, j)] += largest * (if i == j { 1.0 } else { 0.0 } - resisted[(i, j)]);
        }
    }
}

/// Whether `K + t K_g` is positive definite for t = `times`, with the elastic stiffness K and the geometric stiffness K_g.
fn is_stable((elastic, geometric): &(Square, Square), times: f64) -> bool {
    positive_factors(elastic.size().count(), &|i, j| elastic[(i, j)] + times * geometric[(i, j)]).is_some()
}

/// The Cholesky factors of a symmetric matrix; `None` unless it is positive definite.
pub(super) fn positive_factors(count: usize, entry: &dyn Fn(usize, usize) -> f64) -> Option<PositiveBand> {
    let mut factors = PositiveBand::zeros(count, count - 1);
    for j in 0..count {
        for i in j..count {
            factors.add(i, j, entry(i, j));
        }
    }
    factors.factor().map(|()| factors)
}

/// The stiffness of a contact that sticks, or of a drive that holds; without friction it resists along its normal alone.
pub(super) fn sticking_springs(site: &Site) -> SMatrix<f64, 3, 3> {
    let resists = if site.hold != Hold::Bonded && site.friction.is_frictionless() { 1 } else { 3 };
    let mut stiffness: SMatrix<f64, 3, 3> = SMatrix::zeros();
    for axis in 0..resists {
        stiffness.set_column(axis, &site.springs.force(&SVector::ith(axis, 1.0)));
    }
    stiffness
}
