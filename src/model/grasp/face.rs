//! Conversion of arguments and answers between the public interface, with vectors of two or three components, and the engine, with three.
//!
//! A vector of the plane gets a third component of zero. A wrench or a twist of the plane becomes a wrench or a twist of space whose moment or
//! rotation is about z. The engine is thus compiled only once, and values for space need no conversion.

use alloc::borrow::Cow;
use alloc::collections::BTreeMap;
use alloc::sync::Arc;
use core::any::Any;

use nalgebra::{DMatrix, SMatrix, SVector};

use super::bodies::{BodyLoad, BodyMotion};
use super::commands::CommandAxes;
use super::contact::{Contact, Hold};
use super::motion::Motion;
use super::stiffness::Stiffness;
use super::wrench::{Twist, Wrench};
use crate::numerics::{Harmonic, Space, by_axis};
use crate::prelude::*;
use crate::words::LinkKind;

/// A type of the public interface, of arguments or answers, that can be converted to the engine's type and back.
pub(crate) trait Face: Sized + Clone + 'static {
    /// The corresponding type in the engine, with three components per vector.
    type Inside: Clone + 'static;

    /// Whether `Self` and [`Self::Inside`] are the same type, as in space. Then neither [`Self::widen`] nor [`Self::narrow`] is compiled.
    const SAME: bool;

    /// Converts a value of the plane to three components per vector.
    fn widen(&self) -> Self::Inside;

    /// Converts a planar value of the engine to two components per vector.
    fn narrow(inside: Self::Inside) -> Self;

    /// Converts this value to the engine's type.
    fn into_inside(self) -> Self::Inside {
        if const { Self::SAME } { same(self) } else { self.widen() }
    }

    /// Converts a copy of this value to the engine's type.
    fn to_inside(&self) -> Self::Inside {
        if const { Self::SAME } { same(self.clone()) } else { self.widen() }
    }

    /// Converts a value of the engine's type to the caller's type; a value for space is only moved.
    fn from_inside(inside: Self::Inside) -> Self {
        if const { Self::SAME } { same(inside) } else { Self::narrow(inside) }
    }
}

/// Converts a value between two types that the caller knows to be the same, although the compiler does not.
fn same<A: 'static, B: 'static>(value: A) -> B {
    let mut value = Some(value);
    let same = (&mut value as &mut dyn Any).downcast_mut::<Option<B>>().and_then(Option::take);
    same.expect("both names are of one type")
}

/// The value in the engine's type; a value for space is borrowed, not copied.
pub(crate) fn inside<T: Face>(value: &T) -> Cow<'_, T::Inside> {
    if const { T::SAME } {
        Cow::Borrowed((value as &dyn Any).downcast_ref::<T::Inside>().expect("both names are of one type"))
    } else {
        Cow::Owned(value.widen())
    }
}

/// Copies of the values in the engine's type.
pub(crate) fn all_inside<T: Face>(values: &[T]) -> Vec<T::Inside> {
    if const { T::SAME } {
        return same(values.to_vec());
    }
    let mut all = Vec::with_capacity(values.len());
    for value in values {
        all.push(value.widen());
    }
    all
}

/// Converts a value of the engine's type to the caller's type; a value for space is only moved.
pub(crate) fn outside<T: Face>(inside: T::Inside) -> T {
    T::from_inside(inside)
}

/// Implements [`Face`] for structures, field by field. A second type parameter is a type that needs no conversion: its [`Face::Inside`] is itself.
macro_rules! face_of_struct {
    ($($name:ident $(<$same:ident>)? { $($(#[$when:meta])? $field:ident),* $(,)? })*) => {$(
        impl<const C: usize $(, $same: crate::grasp::Face<Inside = $same>)?> crate::grasp::Face for $name<C $(, $same)?> {
            type Inside = $name<3 $(, $same)?>;
            const SAME: bool = C == 3;

            fn widen(&self) -> Self::Inside {
                let Self { $($(#[$when])? $field),* } = self;
                $name { $($(#[$when])? $field: crate::grasp::Face::to_inside($field)),* }
            }

            fn narrow(inside: Self::Inside) -> Self {
                let $name { $($(#[$when])? $field),* } = inside;
                Self { $($(#[$when])? $field: crate::grasp::Face::from_inside($field)),* }
            }
        }
    )*};
}
pub(crate) use face_of_struct;

/// Implements [`Face`] for enumerations, field by field. The fields of a tuple variant are written `0: name`.
macro_rules! face_of_enum {
    ($($name:ident $(<$same:ident>)? { $($variant:ident { $($key:tt : $field:ident),* $(,)? }),* $(,)? })*) => {$(
        impl<const C: usize $(, $same: crate::grasp::Face<Inside = $same>)?> crate::grasp::Face for $name<C $(, $same)?> {
            type Inside = $name<3 $(, $same)?>;
            const SAME: bool = C == 3;

            fn widen(&self) -> Self::Inside {
                match self {
                    $(Self::$variant { $($key: $field),* } =>
                        $name::$variant { $($key: crate::grasp::Face::to_inside($field)),* },)*
                }
            }

            fn narrow(inside: Self::Inside) -> Self {
                match inside {
                    $($name::$variant { $($key: $field),* } =>
                        Self::$variant { $($key: crate::grasp::Face::from_inside($field)),* },)*
                }
            }
        }
    )*};
}
pub(crate) use face_of_enum;

/// Implements [`Face`] for types without vectors, which are the same in the public interface and in the engine.
macro_rules! same_on_both_sides {
    ($($name:ty),* $(,)?) => {$(
        impl crate::grasp::Face for $name {
            type Inside = Self;
            const SAME: bool = true;

            #[inline]
            fn widen(&self) -> Self {
                self.clone()
            }

            #[inline]
            fn narrow(inside: Self) -> Self {
                inside
            }

            #[inline]
            fn into_inside(self) -> Self {
                self
            }

            #[inline]
            fn to_inside(&self) -> Self {
                self.clone()
            }

            #[inline]
            fn from_inside(inside: Self) -> Self {
                inside
            }
        }
    )*};
}
pub(crate) use same_on_both_sides;

same_on_both_sides! {
    bool, f64, usize, &'static str, String, Arc<str>, DMatrix<f64>, Space, super::WholeContact, super::PartLabel, crate::error::ContactLabel,
}

impl<T: Face> Face for Vec<T> {
    type Inside = Vec<T::Inside>;
    const SAME: bool = T::SAME;

    fn widen(&self) -> Self::Inside {
        all_inside(self)
    }

    fn narrow(inside: Self::Inside) -> Self {
        let mut all = Self::with_capacity(inside.len());
        for value in inside {
            all.push(T::from_inside(value));
        }
        all
    }
}

impl<T: Face> Face for Option<T> {
    type Inside = Option<T::Inside>;
    const SAME: bool = T::SAME;

    fn widen(&self) -> Self::Inside {
        self.as_ref().map(T::to_inside)
    }

    fn narrow(inside: Self::Inside) -> Self {
        inside.map(T::from_inside)
    }
}

impl<T: Face> Face for BTreeMap<String, T> {
    type Inside = BTreeMap<String, T::Inside>;
    const SAME: bool = T::SAME;

    fn widen(&self) -> Self::Inside {
        let mut all = BTreeMap::new();
        for (key, value) in self {
            all.insert(key.clone(), value.to_inside());
        }
        all
    }

    fn narrow(inside: Self::Inside) -> Self {
        let mut all = Self::new();
        for (key, value) in inside {
            all.insert(key, T::from_inside(value));
        }
        all
    }
}

impl<T: Face> Face for Box<T> {
    type Inside = Box<T::Inside>;
    const SAME: bool = T::SAME;

    fn widen(&self) -> Self::Inside {
        Box::new(T::to_inside(self))
    }

    fn narrow(inside: Self::Inside) -> Self {
        Self::new(T::from_inside(*inside))
    }
}

impl<A: Face, B: Face> Face for (A, B) {
    type Inside = (A::Inside, B::Inside);
    const SAME: bool = A::SAME && B::SAME;

    fn widen(&self) -> Self::Inside {
        (self.0.to_inside(), self.1.to_inside())
    }

    fn narrow(inside: Self::Inside) -> Self {
        (A::from_inside(inside.0), B::from_inside(inside.1))
    }
}

impl<T: Face> Face for Harmonic<T> {
    type Inside = Harmonic<T::Inside>;
    const SAME: bool = T::SAME;

    fn widen(&self) -> Self::Inside {
        Harmonic {
            constant: self.constant.to_inside(),
            cosine: self.cosine.to_inside(),
            sine: self.sine.to_inside(),
        }
    }

    fn narrow(inside: Self::Inside) -> Self {
        let Harmonic { constant, cosine, sine } = inside;
        Self {
            constant: T::from_inside(constant),
            cosine: T::from_inside(cosine),
            sine: T::from_inside(sine),
        }
    }
}

impl<const C: usize> Face for SVector<f64, C> {
    type Inside = SVector<f64, 3>;
    const SAME: bool = C == 3;

    #[inline]
    fn widen(&self) -> SVector<f64, 3> {
        by_axis(|a| if a < C { self[a] } else { 0.0 })
    }

    #[inline]
    fn narrow(inside: SVector<f64, 3>) -> Self {
        by_axis(|a| inside[a])
    }
}

/// Converts a contact frame from the engine to `C` rows and columns: two in the plane, three in space.
pub(crate) fn frame_outside<const C: usize>(inside: &SMatrix<f64, 3, 3>) -> SMatrix<f64, C, C> {
    SMatrix::from_fn(|a, b| inside[(a, b)])
}

impl<const C: usize> Face for [f64; C] {
    type Inside = [f64; 3];
    const SAME: bool = C == 3;

    fn widen(&self) -> [f64; 3] {
        SVector::from(*self).widen().into()
    }

    fn narrow(inside: [f64; 3]) -> Self {
        SVector::<f64, C>::from_inside(inside.into()).into()
    }
}

/// Implements [`Face`] for pairs of a linear and an angular part; in the plane the angular part is about z.
macro_rules! face_of_six {
    ($name:ident $(, $keeps:ident $points:ident)?) => {
        impl<const C: usize> Face for $name<C> {
            type Inside = $name<3>;
            const SAME: bool = C == 3;

            #[inline]
            fn widen(&self) -> $name<3> {
                let space = Space::of::<C>();
                $name::among(space, &self.coordinates(space))$(.$keeps(self.$points()))?
            }

            #[inline]
            fn narrow(inside: $name<3>) -> Self {
                let space = Space::of::<C>();
                Self::among(space, &inside.coordinates(space))$(.$keeps(inside.$points()))?
            }
        }
    };
}
face_of_six!(Wrench, acting_at points_of_action);
face_of_six!(Twist);

face_of_struct! {
    Motion { object, joints, bodies }
    BodyLoad { body, load }
    BodyMotion { body, twist, centre, reach }
}

same_on_both_sides! { CommandAxes, Hold, LinkKind }

face_of_struct! {
    Contact {
        space, name, point, normal, tangent, stiffness, friction, kinetic, command, command_axes, press, at_rest, force, suction, clearance, hold,
        point_of_pad, on, against, link,
    }
}

/// The plane has no second tangent. The engine's stiffness along it is a copy of the first tangential stiffness, since a stiffness must be in range;
/// no spring uses it.
impl<const C: usize> Face for Stiffness<C> {
    type Inside = Stiffness<3>;
    const SAME: bool = C == 3;

    fn widen(&self) -> Stiffness<3> {
        let filled = |k: &SVector<f64, C>| by_axis(|a| k[a.min(C - 1)]);
        match self {
            Self::BodyAndFinger { body, finger } => {
                Stiffness::BodyAndFinger { body: filled(body), finger: filled(finger) }
            }
            Self::Series(k) => Stiffness::Series(filled(k)),
        }
    }

    fn narrow(inside: Stiffness<3>) -> Self {
        match inside {
            Stiffness::BodyAndFinger { body, finger } => {
                Self::BodyAndFinger { body: Face::from_inside(body), finger: Face::from_inside(finger) }
            }
            Stiffness::Series(k) => Self::Series(Face::from_inside(k)),
        }
    }
}
