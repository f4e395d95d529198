//! Inside coordinates: moments and rotations about the centroid of the contact points, in their own unit of length.
//!
//! Wrenches and twists of a question are moved there and those of an answer are moved back, so that neither a far away
//! reference point nor the unit of the user costs digits.

use nalgebra::SVector;

use super::held_object::Grasp;
use super::rotation::{displacement_of, planes, wrench_of};
use super::wrench::{Twist, Wrench};
use crate::error::{Error, is_moderate};
use crate::twice::Twice;

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// A checked wrench, moved to the centroid and to the inside unit of length.
    pub(crate) fn inside(&self, wrench: &Wrench<D>, what: &'static str) -> Result<SVector<f64, D>, Error> {
        let w = wrench.as_vector();
        if let Some(component) = w.iter().position(|x| !is_moderate(*x)) {
            return Err(Error::Wrench { what, component, value: w[component] });
        }
        Ok(self.inside_unchecked(wrench))
    }

    /// The same for a wrench that was checked before.
    pub(crate) fn inside_unchecked(&self, wrench: &Wrench<D>) -> SVector<f64, D> {
        let w = wrench.as_vector();
        let force = SVector::<f64, C>::from_fn(|a, _| w[a]);
        let carried = wrench_of::<D, C>(&self.origin, &force);
        SVector::from_fn(|k, _| if k < C { w[k] } else { (w[k] - carried[k]) / self.length })
    }

    /// What rounding takes from a wrench moved inside.
    pub(crate) fn inside_rest(&self, wrench: &Wrench<D>) -> SVector<f64, D> {
        let (w, inside) = (wrench.as_vector(), self.inside_unchecked(wrench));
        let mut rest = SVector::zeros();
        for (k, &(i, j)) in planes::<C>().iter().enumerate() {
            let mut moment = Twice::new(w[C + k]);
            moment.add_product(-self.origin[i], w[j]);
            moment.add_product(self.origin[j], w[i]);
            moment.add_product(-inside[C + k], self.length);
            rest[C + k] = moment.value() / self.length;
        }
        rest
    }

    /// Root mean square distance of the contact points from their centroid.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// A wrench as the user sees it, from inside coordinates.
    pub(crate) fn wrench_outside(&self, w: &SVector<f64, D>) -> Wrench<D> {
        let force = SVector::<f64, C>::from_fn(|a, _| w[a]);
        let carried = wrench_of::<D, C>(&self.origin, &force);
        Wrench::from_vector(SVector::from_fn(
            |k, _| if k < C { w[k] } else { w[k] * self.length + carried[k] },
        ))
    }

    /// A twist in inside coordinates: about the centroid, rotations times the inside unit of length.
    pub(crate) fn inside_twist(&self, twist: &Twist<D>) -> SVector<f64, D> {
        let moved = displacement_of::<D, C>(&self.origin, twist.as_vector());
        SVector::from_fn(|k, _| if k < C { moved[k] } else { twist.as_vector()[k] * self.length })
    }

    /// A twist as the user sees it, from inside coordinates.
    pub(crate) fn outside(&self, q: &SVector<f64, D>) -> Twist<D> {
        let mut twist = SVector::from_fn(|k, _| if k < C { q[k] } else { q[k] / self.length });
        let moved = displacement_of::<D, C>(&-self.origin, &twist);
        for a in 0..C {
            twist[a] = moved[a];
        }
        Twist::from_vector(twist)
    }
}
