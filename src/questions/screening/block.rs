//! The data of several scenes, side by side in lanes.

use super::lanes::Packed;

/// Upper limit of the number of contacts of a grasp that is asked alone.
pub(super) const MOST_SCREENED: usize = 5;
/// Upper limit of the number of contact points of a grasp in a batch.
pub(super) const MOST_POINTS: usize = 64;
/// The number of contacts, which is at most the length of arrays, [`MOST_POINTS`].
#[inline(always)]
pub(super) fn count(contacts: usize) -> usize {
    contacts.min(MOST_POINTS)
}

/// Scenes of equally many contacts, one in each lane: rows of one number per contact, then three sizes. The number of contacts is known at run time
/// alone, so that kernels are compiled once for the plane and once for space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<'a, const C: usize, X: Packed> {
    pub(super) contacts: usize,
    /// Bit i is one if contact i is the last point of its finger.
    pub(super) ends: u64,
    pub(super) numbers: &'a [X],
    /// Commands along the normals, then clearances; `numbers` holds their difference. Only questions that change the commands need both.
    pub(super) parted: &'a [X],
}

/// Commanded displacements less the clearance, m: along the normal, and across it as in [`super::finger::Force`]. Rotating a long command along the
/// normal would leave rounding across it, which a stiff tangential spring turns into a force. Both parts are therefore kept apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct Commanded<'a, const C: usize, X: Packed> {
    pub(super) pressed: &'a [X],
    pub(super) sheared: [&'a [X]; C],
}

/// Scales of the rounding of forces, for the commands, for a unit moment, and for a unit force: the sum of the sizes of all terms. Zero where forces
/// are found by motions of the object.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes<X: Packed> {
    pub(super) commands: X,
    pub(super) moment: X,
    pub(super) force: X,
}

/// The rows of a block, as offsets.
pub(super) struct Layout<const C: usize>;

impl<const C: usize> Layout<C> {
    pub(super) const POINT: usize = 0;
    /// Unit normals into the object.
    pub(super) const NORMAL: usize = C;
    pub(super) const SHEARED: usize = 2 * C;
    /// Normal and tangential stiffness, N/m; compliances where forces are found along edges, see [`super::method`].
    pub(super) const SPRINGS: usize = 3 * C;
    pub(super) const PRESSED: usize = 3 * C + 2;
    /// Friction coefficients, or codes; see [`super::cone`].
    pub(super) const FRICTION: usize = 3 * C + 3;
    const OF_A_CONTACT: usize = 3 * C + 4;
    /// The number of components of loads and of motions of the object.
    pub(super) const COORDINATES: usize = 3 * (C - 1);

    /// The count of numbers of one scene.
    pub(super) const fn numbers(contacts: usize) -> usize {
        Self::OF_A_CONTACT * contacts + 3
    }

    /// The count of numbers of one scene, together with the commands and clearances that are also stored apart.
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
    pub(super) fn sizes(&self) -> Sizes<X> {
        let sizes = &self.numbers[Layout::<C>::OF_A_CONTACT * self.contacts..][..3];
        Sizes { commands: sizes[0], moment: sizes[1], force: sizes[2] }
    }

    /// Commands along the normals, and clearances.
    #[inline(always)]
    pub(super) fn parted(&self) -> [&'a [X]; 2] {
        let (commanded, clearance) = self.parted[..2 * self.contacts].split_at(self.contacts);
        [commanded, clearance]
    }
}

/// The data of one scene, row by row, before it becomes a [`Block`]. The array `A` has room for the rows of [`Block`], and then for its commands and
/// clearances.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneScene<const C: usize, A: ?Sized = [f64; Layout::<3>::with_parts(MOST_SCREENED)]> {
    contacts: usize,
    /// Bit i is one if contact i is the last point of its finger.
    ends: u64,
    numbers: A,
}

/// The data of one scene of any number of contacts.
pub(super) type AnyScene<const C: usize> = OneScene<C, [f64]>;
/// The data of one scene of as many contacts as a batch may have.
pub(super) type WideScene<const C: usize> = OneScene<C, [f64; Layout::<3>::with_parts(MOST_POINTS)]>;

impl<const C: usize, const R: usize> OneScene<C, [f64; R]> {
    /// A scene of `contacts` contacts, which must not be more than the array has room for, with all numbers zero.
    pub(super) fn new(contacts: usize) -> Self {
        Self { contacts: count(contacts), ends: u64::MAX, numbers: [0.0; R] }
    }
}

impl<const C: usize> AnyScene<C> {
    /// Begins a scene of this many contacts. The data of the contacts are written later.
    pub(super) fn begin(&mut self, contacts: usize) {
        (self.contacts, self.ends) = (count(contacts), u64::MAX);
        self.measure(&Sizes { commands: 0.0, moment: 0.0, force: 0.0 });
    }

    pub(super) fn block(&self) -> Block<'_, C, f64> {
        let rows = Layout::<C>::numbers(self.contacts);
        let (numbers, parted) = self.numbers[..rows + 2 * self.contacts].split_at(rows);
        Block { contacts: self.contacts, ends: self.ends, numbers, parted }
    }

    /// The number of one contact in a row.
    pub(super) fn at(&mut self, row: usize, contact: usize) -> &mut f64 {
        &mut self.numbers[row * self.contacts + contact]
    }

    /// Sets the command along the normal and the clearance of a contact, m.
    pub(super) fn part(&mut self, contact: usize, [command, clearance]: [f64; 2]) {
        let first = Layout::<C>::numbers(self.contacts) + contact;
        self.numbers[first] = command;
        self.numbers[first + self.contacts] = clearance;
    }

    pub(super) fn measure(&mut self, sizes: &Sizes<f64>) {
        let first = Layout::<C>::OF_A_CONTACT * self.contacts;
        self.numbers[first..first + 3].copy_from_slice(&[sizes.commands, sizes.moment, sizes.force]);
    }

    /// Makes this contact a point of the same finger as the next one.
    pub(super) fn join_to_next(&mut self, contact: usize) {
        self.ends &= !(1 << contact);
    }
}
