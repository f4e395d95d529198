//! The data of scenes side by side.

use super::lanes::Packed;

/// Contacts that a grasp has at most.
pub(super) const MOST_CONTACTS: usize = 5;
/// How many contacts there are, where there is room for `M`: as many, but in kernels of batches with the largest room. So all other loops are
/// unrolled.
#[inline(always)]
pub(super) fn count<const M: usize, X: Packed>(contacts: usize) -> usize {
    if M < MOST_CONTACTS || X::ALONE { M } else { contacts.min(M) }
}

/// `L` scenes of as many contacts each: rows of numbers, one for each contact, then three sizes. How many contacts there are is known at run
/// time alone, so that kernels are compiled once for the plane and once for space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<'a, const C: usize, X: Packed> {
    pub(super) contacts: usize,
    pub(super) numbers: &'a [X],
    /// Commands along the normals and clearances apart, of which `numbers` has the difference: only who
    /// changes the commands asks for them.
    pub(super) parted: &'a [X],
}

/// Commanded displacements less the clearance: along the normal, and across it as in
/// [`super::finger::Force`]. Kept apart, for a stiff tangential spring would make a force of
/// what rounding turns of a long way along the normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Commanded<'a, const C: usize, X: Packed> {
    pub(super) pressed: &'a [X],
    pub(super) sheared: [&'a [X]; C],
}

/// What the rounding of forces is measured against, for the commands, for a unit moment, and for a
/// unit force: the sum of the sizes of all terms. Zero where forces are found by motions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes<X: Packed> {
    pub(super) commands: X,
    pub(super) moment: X,
    pub(super) force: X,
}

/// What stands in which row.
pub(super) struct Layout<const C: usize>;

impl<const C: usize> Layout<C> {
    pub(super) const POINT: usize = 0;
    /// Unit normals into the object.
    pub(super) const NORMAL: usize = C;
    pub(super) const SHEARED: usize = 2 * C;
    /// Normal and tangential stiffness; compliances where forces go along edges, see [`super::method`].
    pub(super) const SPRINGS: usize = 3 * C;
    pub(super) const PRESSED: usize = 3 * C + 2;
    /// Friction coefficients, or codes; see [`super::cone`].
    pub(super) const FRICTION: usize = 3 * C + 3;
    const ALL: usize = 3 * C + 4;

    /// The numbers of a scene.
    pub(super) const fn numbers(contacts: usize) -> usize {
        Self::ALL * contacts + 3
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

    /// By axes.
    #[inline(always)]
    pub(super) fn points(&self) -> [&'a [X]; C] {
        self.vectors(Layout::<C>::POINT)
    }

    /// By axes.
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
        let sizes = &self.numbers[Layout::<C>::ALL * self.contacts..][..3];
        Sizes { commands: sizes[0], moment: sizes[1], force: sizes[2] }
    }

    /// Commands along the normals, and clearances.
    #[inline(always)]
    pub(super) fn parted(&self) -> [&'a [X]; 2] {
        let (commanded, clearance) = self.parted[..2 * self.contacts].split_at(self.contacts);
        [commanded, clearance]
    }
}

/// One scene, as it is written.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneScene<const C: usize, const N: usize> {
    /// With room for the rows in space, and for the sizes in two more.
    numbers: [[f64; N]; 15],
    parted: [[f64; N]; 2],
}

impl<const C: usize, const N: usize> OneScene<C, N> {
    /// Nothing yet.
    pub(super) const EMPTY: Self = Self { numbers: [[0.0; N]; 15], parted: [[0.0; N]; 2] };

    #[inline(always)]
    pub(super) fn block(&self) -> Block<'_, C, f64> {
        let numbers = &self.numbers.as_flattened()[..Layout::<C>::numbers(N)];
        Block { contacts: N, numbers, parted: self.parted.as_flattened() }
    }

    /// A number of a contact.
    pub(super) fn at(&mut self, row: usize, contact: usize) -> &mut f64 {
        &mut self.numbers[row][contact]
    }

    /// Command along the normal and clearance of a contact.
    pub(super) fn part(&mut self, contact: usize, [command, clearance]: [f64; 2]) {
        self.parted[0][contact] = command;
        self.parted[1][contact] = clearance;
    }

    pub(super) fn measure(&mut self, sizes: &Sizes<f64>) {
        self.numbers.as_flattened_mut()[Layout::<C>::ALL * N..][..3].copy_from_slice(&[
            sizes.commands,
            sizes.moment,
            sizes.force,
        ]);
    }
}
