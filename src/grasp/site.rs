//! One contact as the arithmetic sees it.

use crate::numerics::{Map, Size, Vector};
use alloc::sync::Arc;
use core::ops::Range;

use nalgebra::{SMatrix, SVector};

use super::contact::{Contact, Hold};
use super::rotation::{grasp_map_in_twice, of_the_object};
use super::support::Support;
use crate::contact::{Compliance, Coulomb, Law, Polygon};
use crate::error::Error;
use crate::numerics::DoubleDouble;

/// What the arithmetic needs of one contact, in inside coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Site<D: Size, const C: usize> {
    /// Grasp map G_i.
    pub(crate) map: Map<D, C>,
    /// What rounding took from G_i, given the points and the frame.
    pub(crate) map_rest: Map<D, C>,
    /// Norm of G_i.
    size: f64,
    /// Where G_i has entries.
    pub(crate) support: Support<D>,
    /// Contact frame, columns n, t….
    pub(crate) frame: SMatrix<f64, C, C>,
    pub(crate) springs: Compliance<C>,
    pub(crate) friction: Coulomb,
    /// The cone while it slides, if that is a smaller one.
    pub(crate) kinetic: Option<Coulomb>,
    pub(crate) hold: Hold,
    /// The polygon that stands for the cone whatever the question says.
    pub(crate) polygon: Option<Arc<Polygon<C>>>,
}

impl<D: Size, const C: usize> Site<D, C> {
    /// The contact with this index, about the centroid `origin` and in the inside unit of `length`.
    ///
    /// # Errors
    /// [`Error::Contact`] if the contact has no frame.
    pub(super) fn new(
        size: D,
        (contact, index): (&Contact<C>, usize),
        (origin, length): (&SVector<f64, C>, f64),
    ) -> Result<Self, Error> {
        let frame = contact.frame(index)?;
        let axes = contact.springs();
        let series = contact.stiffness.series();
        let (mut map, mut map_rest) = grasp_map_in_twice(size, &contact.point, origin, length, &frame);
        Ok(Self {
            size: map.norm(),
            support: Support::of(&mut map, &mut map_rest),
            map,
            map_rest,
            frame,
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

    /// This site with another map, exactly.
    pub(crate) fn with_map(&self, mut map: Map<D, C>) -> Self {
        let mut map_rest = Map::zeros(map.size());
        let (size, support) = (map.norm(), Support::of(&mut map, &mut map_rest));
        Self { map, map_rest, size, support, ..self.clone() }
    }

    /// A site whose only force acts along one axis of its own: a drive of a hand.
    pub(super) fn of_axis(
        size: D,
        (axis, along): (usize, &Vector<D>),
        springs: Compliance<C>,
        hold: Hold,
    ) -> Self {
        let (mut map, mut map_rest) = (Map::zeros(size), Map::zeros(size));
        map.set_column(axis, along);
        Self {
            size: map.norm(),
            support: Support::of(&mut map, &mut map_rest),
            map,
            map_rest,
            frame: SMatrix::identity(),
            springs,
            friction: Coulomb::new(0.0),
            kinetic: None,
            hold,
            polygon: None,
        }
    }

    /// Lets joints move the contact: columns of its Jacobian along the coordinate axes, and the lengths that measure joint displacements. Its force acts on
    /// the object with this sign, or not at all.
    pub(super) fn move_with(
        &mut self,
        motions: &[(usize, SVector<f64, C>)],
        lengths: &Vector<D>,
        on_object: f64,
    ) {
        let object = of_the_object::<C>();
        if on_object != 1.0 {
            for (k, a) in (0..object).flat_map(|k| (0..C).map(move |a| (k, a))) {
                self.map[(k, a)] *= on_object;
                self.map_rest[(k, a)] *= on_object;
            }
        }
        for (coordinate, motion) in motions {
            let k = object + coordinate;
            for a in 0..C {
                // The object gives way where the finger comes: the sign is the other one.
                let entry = -self.frame.column(a).dot(motion) / lengths[k];
                let mut rest = DoubleDouble::new(-entry * lengths[k]);
                for b in 0..C {
                    rest.add_product(-self.frame[(b, a)], motion[b]);
                }
                (self.map[(k, a)], self.map_rest[(k, a)]) = (entry, rest.value() / lengths[k]);
            }
        }
        self.size = self.map.norm();
        self.support = Support::of(&mut self.map, &mut self.map_rest);
    }

    /// Some entries of a column of G_i, each with what rounding took from it.
    #[inline(always)]
    pub(crate) fn column_in_twice(
        &self,
        axis: usize,
        range: Range<usize>,
    ) -> impl Iterator<Item = (f64, f64)> {
        let map = self.map.column_within(axis, range.clone());
        let rest = self.map_rest.column_within(axis, range);
        map.iter().copied().zip(rest.iter().copied())
    }

    /// How many coordinates there are.
    #[inline]
    pub(crate) fn coordinates(&self) -> D {
        self.map.size()
    }

    /// The law of the contact at rest.
    pub(crate) fn whole_law(&self) -> Law<C> {
        match self.hold {
            Hold::Unilateral => Law::Cone { gap: true },
            Hold::KeptClosed => Law::Cone { gap: false },
            Hold::Bonded => Law::Bonded,
        }
    }

    /// `a - G_iᵀq`.
    #[inline(always)]
    pub(crate) fn stretch(&self, drive: &SVector<f64, C>, twist: &Vector<D>) -> SVector<f64, C> {
        drive - self.map.tr_mul(twist)
    }

    /// Size of the displacements at the contact: translation and rotation may cancel there, their rounding does not.
    #[inline(always)]
    pub(crate) fn span(&self, drive: &SVector<f64, C>, twist: &Vector<D>) -> f64 {
        self.span_moved(drive, twist.norm())
    }

    /// [`Self::span`], of a twist with this norm.
    #[inline(always)]
    pub(crate) fn span_moved(&self, drive: &SVector<f64, C>, twist: f64) -> f64 {
        drive.norm() + self.size * twist
    }
}

/// How many coordinates these sites move in: a grasp has one site at least.
#[inline]
pub(crate) fn size_of<D: Size, const C: usize>(sites: &[Site<D, C>]) -> D {
    sites.first().map_or(D::default(), Site::coordinates)
}
