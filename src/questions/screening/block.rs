//! The data of several grasps, side by side in the lanes of vectors.

use super::lanes::Packed;

/// The most contacts of a grasp that is screened alone, not in a batch.
pub(super) const MOST_SCREENED: usize = 5;
/// The most contact points of a grasp in a batch.
pub(super) const MOST_POINTS: usize = 64;
/// The number of contacts, clamped to the length of arrays ([`MOST_POINTS`]), so that no index exceeds it.
#[inline(always)]
pub(super) fn count(contacts: usize) -> usize {
    contacts.min(MOST_POINTS)
}

/// The entry of contact `i` in each of these rows.
#[inline(always)]
pub(super) fn entries<X: Copy, const K: usize>(rows: &[&[X]; K], i: usize) -> [X; K] {
    let mut all = [rows[0][i]; K];
    for row in 1..K {
        all[row] = rows[row][i];
    }
    all
}

/// Grasps with the same number of contacts, one in each lane. Each row has one number per contact; three [`Sizes`] follow. The number of contacts is
/// known only at run time, so that kernels are compiled once for the plane and once for space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<'a, const C: usize, X: Packed> {
    pub(super) contacts: usize,
    /// Bit i is set if contact point i is the last one of its finger; a pad has several.
    pub(super) ends: u64,
    pub(super) numbers: &'a [X],
    /// Commands along the normals, then clearances. The rows in `numbers` hold their difference; only questions that scale the commands need both.
    pub(super) parted: &'a [X],
}

/// Commanded displacements less clearances, m: along the normal, and across it as in [`super::finger::Force`]. The two are stored apart: a long
/// command along the normal, rotated into coordinate axes, leaves rounding across it, which a stiff tangential spring would turn into a force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Commanded<'a, const C: usize, X: Packed> {
    pub(super) pressed: &'a [X],
    pub(super) sheared: [&'a [X]; C],
}

/// The sizes of summed terms, by which the rounding of forces is bounded: for the commands, for a unit moment and for a unit force. They are zero
/// where forces are found by motions of the object.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes<X: Packed> {
    pub(super) commands: X,
    pub(super) moment: X,
    pub(super) force: X,
}

/// The index of each row in the data of a block.
pub(super) struct Layout<const C: usize>;

impl<const C: usize> Layout<C> {
    pub(super) const POINT: usize = 0;
    /// Unit normals into the object.
    pub(super) const NORMAL: usize = C;
    pub(super) const SHEARED: usize = 2 * C;
    /// Normal and tangential stiffness, N/m. Where forces are found along edges between contacts (see [`super::method`]) the rows hold compliances.
    pub(super) const SPRINGS: usize = 3 * C;
    pub(super) const PRESSED: usize = 3 * C + 2;
    /// Coefficients of friction, or one of the codes [`OPENS_ONLY`](super::cone::OPENS_ONLY) and [`STAYS`](super::cone::STAYS).
    pub(super) const FRICTION: usize = 3 * C + 3;
    const OF_A_CONTACT: usize = 3 * C + 4;
    /// The number of components of loads and of motions of the object.
    pub(super) const COORDINATES: usize = 3 * (C - 1);

    /// How many numbers the rows of one grasp have.
    pub(super) const fn numbers(contacts: usize) -> usize {
        Self::OF_A_CONTACT * contacts + 3
    }

    /// How many numbers one grasp has, including commands and clearances that are also stored apart.
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

/// The data of one grasp, row by row, before they become a lane of a [`Block`]. The array `A` has room for these rows, then for commands and
/// clearances.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneScene<const C: usize, A: ?Sized = [f64; Layout::<3>::with_parts(MOST_SCREENED)]> {
    contacts: usize,
    /// Bit i is set if contact point i is the last one of its finger.
    ends: u64,
    numbers: A,
}

/// The data of one grasp with any number of contacts.
pub(super) type AnyScene<const C: usize> = OneScene<C, [f64]>;
/// The data of one grasp, with room for as many contacts as a grasp of a batch may have.
pub(super) type WideScene<const C: usize> = OneScene<C, [f64; Layout::<3>::with_parts(MOST_POINTS)]>;

impl<const C: usize, const R: usize> OneScene<C, [f64; R]> {
    /// A grasp of `contacts` contacts whose data are all zero. The array must have room for them.
    pub(super) fn new(contacts: usize) -> Self {
        Self { contacts: count(contacts), ends: u64::MAX, numbers: [0.0; R] }
    }
}

impl<const C: usize> AnyScene<C> {
    /// Begins a grasp of this many contacts. Their data are written later.
    pub(super) fn begin(&mut self, contacts: usize) {
        (self.contacts, self.ends) = (count(contacts), u64::MAX);
        self.measure(&Sizes { commands: 0.0, moment: 0.0, force: 0.0 });
    }

    pub(super) fn block(&self) -> Block<'_, C, f64> {
        let rows = Layout::<C>::numbers(self.contacts);
        let (numbers, parted) = self.numbers[..rows + 2 * self.contacts].split_at(rows);
        Block { contacts: self.contacts, ends: self.ends, numbers, parted }
    }

    /// The entry of one contact in a row.
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
