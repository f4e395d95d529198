//! The data of several grasps, side by side in the lanes of SIMD vectors, as screening uses them. Screening computes, for many grasps, the load
//! factor of first slip, at which the first contact ceases to stick. A command is the displacement that a finger would make if there were no object.
//! A clearance is the gap between finger and object before the command; it is negative if they overlap.

use super::lanes::Packed;

/// Upper limit of the number of contacts of a grasp in the batches `Fingers` and `Batch`; a [`PointBatch`](super::PointBatch) allows more.
pub(super) const MOST_SCREENED: usize = 5;
/// Upper limit of the number of contact points of a grasp in a [`PointBatch`](super::PointBatch).
pub(super) const MOST_POINTS: usize = 64;
/// The number of contacts, limited to the length [`MOST_POINTS`] of the arrays, so that no index exceeds this length.
#[inline(always)]
pub(super) fn count(contacts: usize) -> usize {
    contacts.min(MOST_POINTS)
}

/// The entry of contact `i` in each of the given rows, which have one number per contact.
#[inline(always)]
pub(super) fn entries<X: Copy, const K: usize>(rows: &[&[X]; K], i: usize) -> [X; K] {
    let mut all = [rows[0][i]; K];
    for row in 1..K {
        all[row] = rows[row][i];
    }
    all
}

/// The data of several grasps with the same number of contacts, one grasp in each lane of a vector. Each row of `numbers` has one entry per contact;
/// the three numbers of [`TermSizes`] follow. The number of contacts is a run-time value. Thus the functions of screening are compiled once for the
/// plane and once for space, not for each number of contacts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<'a, const C: usize, X: Packed> {
    pub(super) contacts: usize,
    /// Bit i is set if contact point i is the last point of its finger. A soft fingertip has several points, any other contact has one.
    pub(super) ends: u64,
    pub(super) numbers: &'a [X],
    /// Commands along the normals of all contacts, m, then their clearances, m. `numbers` has only the differences; questions that scale the commands
    /// need both.
    pub(super) commands_and_clearances: &'a [X],
}

/// Commanded displacements less clearances, m: the component along the normal (`pressed`), and the tangential vector (`sheared`). In space the latter
/// is along the coordinate axes; in the plane its only component is along (n_y, -n_x). If both were stored as one vector along the coordinate axes,
/// the tangential part would have the rounding error of a large normal component, and a stiff tangential spring would turn this error into a force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Commanded<'a, const C: usize, X: Packed> {
    pub(super) pressed: &'a [X],
    pub(super) sheared: [&'a [X]; C],
}

/// Bounds on the sums of the magnitudes of the terms that add up to a contact force. The rounding error of the force is proportional to such a sum.
/// The bounds are zero if forces are found from the motion of the object ([`Method::Motions`](super::method::Method::Motions)), which bounds the
/// rounding of each force in another way.
#[derive(Debug, Clone, Copy)]
pub(super) struct TermSizes<X: Packed> {
    /// Bound on the sum of the magnitudes of the terms of a contact force that are due to the commands, N.
    pub(super) commands: X,
    /// Bound, N, on the sum of the magnitudes of the terms of a contact force that are due to a moment of 1 N m about one axis.
    pub(super) moment: X,
    /// Bound, N, on the sum of the magnitudes of the terms of a contact force that are due to a load of 1 N.
    pub(super) force: X,
}

/// The order of the rows in `numbers` of a [`Block`]. Each constant is the index of the first row of a quantity; a vector has one row per axis.
pub(super) struct Layout<const C: usize>;

impl<const C: usize> Layout<C> {
    pub(super) const POINT: usize = 0;
    /// Unit normals into the object, one row per axis.
    pub(super) const NORMAL: usize = C;
    pub(super) const SHEARED: usize = 2 * C;
    /// Rows of normal and of tangential stiffness, N/m. They are compliances, m/N, in grasps whose forces are found along the lines between contacts
    /// ([`Method::Edges`](super::method::Method::Edges)).
    pub(super) const SPRINGS: usize = 3 * C;
    pub(super) const PRESSED: usize = 3 * C + 2;
    /// The row of coefficients of friction. In place of a coefficient there may be a code: [`OPENS_ONLY`](super::cone::OPENS_ONLY) for a contact that
    /// ceases to stick only by opening, [`STAYS`](super::cone::STAYS) for one that never ceases to stick.
    pub(super) const FRICTION: usize = 3 * C + 3;
    const OF_A_CONTACT: usize = 3 * C + 4;
    /// The number of components of loads and of motions of the object.
    pub(super) const COORDINATES: usize = 3 * (C - 1);

    /// The number of entries that `numbers` of a [`Block`] has for grasps of this many contacts.
    pub(super) const fn numbers(contacts: usize) -> usize {
        Self::OF_A_CONTACT * contacts + 3
    }

    /// The number of entries of [`GraspData`]: the numbers of a [`Block`], then commands and clearances separately.
    const fn with_parts(contacts: usize) -> usize {
        Self::numbers(contacts) + 2 * contacts
    }
}

impl<'a, const C: usize, X: Packed> Block<'a, C, X> {
    #[inline(always)]
    fn row(&self, row: usize) -> &'a [X] {
        &self.numbers[row * self.contacts..][..self.contacts]
    }

    #[inline(always)]
    fn vectors(&self, first: usize) -> [&'a [X]; C] {
        let mut rows = [self.row(first); C];
        for axis in 1..C {
            rows[axis] = self.row(first + axis);
        }
        rows
    }

    /// Contact points, m, one row per axis.
    #[inline(always)]
    pub(super) fn points(&self) -> [&'a [X]; C] {
        self.vectors(Layout::<C>::POINT)
    }

    /// Unit normals into the object, one row per axis.
    #[inline(always)]
    pub(super) fn normals(&self) -> [&'a [X]; C] {
        self.vectors(Layout::<C>::NORMAL)
    }

    #[inline(always)]
    pub(super) fn springs(&self) -> [&'a [X]; 2] {
        [self.row(Layout::<C>::SPRINGS), self.row(Layout::<C>::SPRINGS + 1)]
    }

    #[inline(always)]
    pub(super) fn commands(&self) -> Commanded<'a, C, X> {
        Commanded { pressed: self.row(Layout::<C>::PRESSED), sheared: self.vectors(Layout::<C>::SHEARED) }
    }

    #[inline(always)]
    pub(super) fn friction(&self) -> &'a [X] {
        self.row(Layout::<C>::FRICTION)
    }

    #[inline(always)]
    pub(super) fn sizes(&self) -> TermSizes<X> {
        let sizes = &self.numbers[Layout::<C>::OF_A_CONTACT * self.contacts..][..3];
        TermSizes { commands: sizes[0], moment: sizes[1], force: sizes[2] }
    }

    /// Commands along the normals, and clearances, m, one row each with one entry per contact.
    #[inline(always)]
    pub(super) fn commands_and_clearances(&self) -> [&'a [X]; 2] {
        let (commanded, clearance) =
            self.commands_and_clearances[..2 * self.contacts].split_at(self.contacts);
        [commanded, clearance]
    }
}

/// The data of one grasp, ordered as in a [`Block`] but with one lane. The array `A` has room for the rows of `numbers`, then for commands and
/// clearances.
#[derive(Debug, Clone, Copy)]
pub(super) struct GraspData<const C: usize, A: ?Sized = [f64; Layout::<3>::with_parts(MOST_SCREENED)]> {
    contacts: usize,
    /// Bit i is set if contact point i is the last point of its finger. Without soft fingertips each contact is a single point, and the bits of all
    /// contacts are set.
    ends: u64,
    numbers: A,
}

/// The data of one grasp with any number of contacts.
pub(super) type AnyGraspData<const C: usize> = GraspData<C, [f64]>;
/// The data of one grasp, with room for as many contacts as a grasp of a batch may have.
pub(super) type WideGraspData<const C: usize> = GraspData<C, [f64; Layout::<3>::with_parts(MOST_POINTS)]>;

impl<const C: usize, const R: usize> GraspData<C, [f64; R]> {
    /// A grasp of `contacts` contacts whose data are all zero. The array must have room for them.
    pub(super) fn new(contacts: usize) -> Self {
        Self { contacts: count(contacts), ends: u64::MAX, numbers: [0.0; R] }
    }
}

impl<const C: usize> AnyGraspData<C> {
    /// Starts to store a grasp of this many contacts, each of them a finger of its own. The data of the contacts are written later.
    pub(super) fn begin(&mut self, contacts: usize) {
        (self.contacts, self.ends) = (count(contacts), u64::MAX);
        self.measure(&TermSizes { commands: 0.0, moment: 0.0, force: 0.0 });
    }

    pub(super) fn block(&self) -> Block<'_, C, f64> {
        let rows = Layout::<C>::numbers(self.contacts);
        let (numbers, commands_and_clearances) = self.numbers[..rows + 2 * self.contacts].split_at(rows);
        Block { contacts: self.contacts, ends: self.ends, numbers, commands_and_clearances }
    }

    /// The entry of one contact in one row of `numbers`.
    pub(super) fn at(&mut self, row: usize, contact: usize) -> &mut f64 {
        &mut self.numbers[row * self.contacts + contact]
    }

    /// Sets the command along the normal and the clearance of a contact, m.
    pub(super) fn set_command_and_clearance(&mut self, contact: usize, [command, clearance]: [f64; 2]) {
        let first = Layout::<C>::numbers(self.contacts) + contact;
        self.numbers[first] = command;
        self.numbers[first + self.contacts] = clearance;
    }

    pub(super) fn measure(&mut self, sizes: &TermSizes<f64>) {
        let first = Layout::<C>::OF_A_CONTACT * self.contacts;
        self.numbers[first..first + 3].copy_from_slice(&[sizes.commands, sizes.moment, sizes.force]);
    }

    /// Joins this contact point and the next one to the same soft fingertip.
    pub(super) fn join_to_next(&mut self, contact: usize) {
        self.ends &= !(1 << contact);
    }
}
