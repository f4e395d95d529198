//! A site: a contact, or a drive, which is the spring of a joint or tendon of a hand with its force limit. The engine treats both as points with
//! springs and a contact law. In the engine's coordinates moments and rotations refer to the centroid of the contacts, and all coordinates are
//! lengths.

use crate::numerics::{DoubleDouble, Map, Size, Space, Vector, WHOLE};
use alloc::sync::Arc;
use core::ops::Range;

use nalgebra::{SMatrix, SVector};

use super::contact::{Contact, Hold};
use super::support::Support;
use crate::contact::{Compliance, Coulomb, Law, Polygon};
use crate::error::Error;

/// One contact or one drive in the engine's coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Site {
    /// Grasp map G_i of this site. A column holds the generalised forces in all coordinates due to a unit force of the site along one axis of its
    /// frame.
    pub(crate) map: Map,
    /// Rounding error of the grasp map G_i for the given point and frame: the exact map minus G_i.
    pub(crate) map_rounding_error: Map,
    /// Norm of the grasp map G_i. Rounding errors of displacements at the contact are proportional to it.
    size: f64,
    /// Coordinates in which the grasp map G_i has nonzero entries.
    pub(crate) support: Support,
    /// Contact frame: its columns are the normal, the first tangent and, in space, the second tangent.
    pub(crate) frame: SMatrix<f64, 3, 3>,
    pub(crate) space: Space,
    pub(crate) springs: Compliance,
    pub(crate) friction: Coulomb,
    /// Kinetic friction cone; `None` if it equals the static friction cone.
    pub(crate) kinetic: Option<Coulomb>,
    pub(crate) hold: Hold,
    /// Polygon that replaces the friction cone even where the settings ask for the round cone. Only drives that slip at a force limit have one.
    pub(crate) polygon: Option<Arc<Polygon>>,
}

impl Site {
    /// The site of a contact. The lever arms in its grasp map are measured from the centroid `origin`, in units of `length`.
    ///
    /// # Errors
    /// [`Error::Contact`] if the contact has no frame.
    pub(super) fn new(
        space: Space,
        size: Size,
        (contact, index): (&Contact<3>, usize),
        (origin, length): (&SVector<f64, 3>, f64),
    ) -> Result<Self, Error> {
        let frame = contact.frame(index)?;
        let axes = contact.springs();
        let series = contact.stiffness.series();
        let (mut map, mut map_rounding_error) =
            space.grasp_map_in_twice(size, &contact.point, origin, length, &frame);
        Ok(Self {
            size: map.norm(),
            support: Support::of(space, &mut map, &mut map_rounding_error),
            map,
            map_rounding_error,
            frame,
            space,
            springs: Compliance::new(&series, axes),
            friction: Coulomb::new(contact.friction),
            kinetic: contact
                .kinetic
                .filter(|kinetic| *kinetic < contact.friction && contact.friction.is_finite())
                .map(Coulomb::new),
            hold: contact.hold,
            polygon: None,
        })
    }

    /// A copy of this site, a contact or drive, with another grasp map. The rounding error of this map counts as zero.
    pub(crate) fn with_map(&self, mut map: Map) -> Self {
        let mut map_rounding_error = Map::zeros(map.size());
        let (size, support) = (map.norm(), Support::of(self.space, &mut map, &mut map_rounding_error));
        Self { map, map_rounding_error, size, support, ..self.clone() }
    }

    /// The site of a drive, whose force acts along only one axis of its frame.
    pub(super) fn of_axis(
        space: Space,
        size: Size,
        (axis, along): (usize, &Vector),
        springs: Compliance,
        hold: Hold,
    ) -> Self {
        let (mut map, mut map_rounding_error) = (Map::zeros(size), Map::zeros(size));
        map.set_column(axis, along);
        Self {
            size: map.norm(),
            support: Support::of(space, &mut map, &mut map_rounding_error),
            map,
            map_rounding_error,
            frame: SMatrix::identity(),
            space,
            springs,
            friction: Coulomb::new(0.0),
            kinetic: None,
            hold,
            polygon: None,
        }
    }

    /// Adds to the grasp map how the contact moves with joints and other bodies. An entry of `motions` belongs to one coordinate: its index, counted
    /// after the object's coordinates, and the displacement of the contact along x, y and z per unit of it. The displacements are divided by the
    /// reference `lengths` of the coordinates, m, so that all coordinates are lengths. The contact force acts on the object with the factor
    /// `on_object`: 1, -1, or 0 if it acts on other bodies only.
    pub(super) fn move_with(
        &mut self,
        space: Space,
        motions: &[(usize, SVector<f64, 3>)],
        lengths: &Vector,
        on_object: f64,
    ) {
        let (object, axes) = (space.of_the_object(), space.axes());
        if on_object != 1.0 {
            for k in 0..object {
                for a in 0..axes {
                    self.map[(k, a)] *= on_object;
                    self.map_rounding_error[(k, a)] *= on_object;
                }
            }
        }
        for (coordinate, motion) in motions {
            let k = object + coordinate;
            for a in 0..axes {
                // A motion of the finger stretches the springs like the opposite motion of the object, hence the minus sign.
                let entry = -self.frame.column(a).into_owned().dot(motion) / lengths[k];
                let mut rest = DoubleDouble::new(-entry * lengths[k]);
                for b in 0..axes {
                    rest.add_product(-self.frame[(b, a)], motion[b]);
                }
                (self.map[(k, a)], self.map_rounding_error[(k, a)]) = (entry, rest.value() / lengths[k]);
            }
        }
        self.size = self.map.norm();
        self.support = Support::of(space, &mut self.map, &mut self.map_rounding_error);
    }

    /// Entries of a column of the grasp map within a range of coordinates, and the rounding errors of these entries.
    #[inline(always)]
    pub(crate) fn column_in_twice(&self, axis: usize, range: Range<usize>) -> (&[f64], &[f64]) {
        (self.map.column_within(axis, range.clone()), self.map_rounding_error.column_within(axis, range))
    }

    /// A column of the grasp map and its rounding errors; `None` if the grasp has more than six coordinates.
    #[inline]
    pub(crate) fn whole_column_in_twice(&self, axis: usize) -> Option<[&[f64; WHOLE]; 2]> {
        Some([self.map.whole_column(axis)?, self.map_rounding_error.whole_column(axis)?])
    }

    /// Number of coordinates of the grasp to which this site belongs.
    #[inline]
    pub(crate) fn coordinates(&self) -> Size {
        self.map.size()
    }

    /// The contact law in an equilibrium: the whole friction cone, or no limit for a bonded contact, which neither opens nor slips. The rates of
    /// force and stretch as the load grows may obey another [`Law`].
    pub(crate) fn whole_law(&self) -> Law {
        match self.hold {
            Hold::Unilateral => Law::Cone { gap: true },
            Hold::KeptClosed => Law::Cone { gap: false },
            Hold::Bonded => Law::Bonded,
        }
    }

    /// Stretch of the springs, `a - Gᵀq`, with the offset a (commanded displacement of the finger, less clearance), the grasp map G and the
    /// displacements q of all coordinates.
    #[inline(always)]
    pub(crate) fn stretch(&self, offset: &SVector<f64, 3>, twist: &Vector) -> SVector<f64, 3> {
        offset - self.map.tr_mul(twist)
    }

    /// Upper bound of the terms of the stretch `a - Gᵀq`, m, to which the rounding error of the stretch is proportional. `offset` is a, and `twist`
    /// is q. Translation and rotation may cancel at the contact; their rounding errors do not.
    #[inline(always)]
    pub(crate) fn span(&self, offset: &SVector<f64, 3>, twist: &Vector) -> f64 {
        self.span_moved(offset, twist.norm())
    }

    /// Upper bound of the terms of the stretch `a - Gᵀq`, m. `offset` is a, and `twist` is the norm of q.
    #[inline(always)]
    pub(crate) fn span_moved(&self, offset: &SVector<f64, 3>, twist: f64) -> f64 {
        offset.norm() + self.size * twist
    }
}

/// Number of coordinates of a grasp with these contacts and drives.
#[inline]
pub(crate) fn size_of(sites: &[Site]) -> Size {
    sites.first().map_or(Size::default(), Site::coordinates)
}
