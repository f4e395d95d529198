//! Text forms of fields that are numbers, rows (one number per axis) or lists of rows: `#[serde(with = "AsGiven::<T>")]` in questions, `AsComputed`
//! in answers.

use std::marker::PhantomData;

use nalgebra::SVector;
use serde::de::{Deserialize, DeserializeOwned, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::numbers::{Computed, Given, Kind, Number};
use super::rows::AxisRow;
use crate::numerics::{mapped, moved};

/// A value that consists of numbers: a number, a row with one number per axis, or a list or option of these. The type `K` says which numbers are
/// accepted: [`Given`] finite ones up to 1e50 in magnitude, [`Computed`] any.
pub(crate) trait Numeric<K>: Sized {
    type Written: Serialize + DeserializeOwned;
    fn write(&self) -> Self::Written;
    fn read(written: Self::Written) -> Self;
}

impl<K: Kind> Numeric<K> for f64 {
    type Written = Number<K>;
    fn write(&self) -> Number<K> {
        Number::new(*self)
    }
    fn read(written: Number<K>) -> Self {
        written.0
    }
}

impl<K: Kind, const C: usize> Numeric<K> for SVector<f64, C> {
    type Written = AxisRow<K, C>;
    fn write(&self) -> AxisRow<K, C> {
        AxisRow::new(*self)
    }
    fn read(written: AxisRow<K, C>) -> Self {
        written.0
    }
}

impl<K, T: Numeric<K>> Numeric<K> for Option<T> {
    type Written = Option<T::Written>;
    fn write(&self) -> Self::Written {
        self.as_ref().map(T::write)
    }
    fn read(written: Self::Written) -> Self {
        written.map(T::read)
    }
}

impl<K, T: Numeric<K>> Numeric<K> for Vec<T> {
    type Written = Vec<T::Written>;
    fn write(&self) -> Self::Written {
        mapped(self, &T::write)
    }
    fn read(written: Self::Written) -> Self {
        moved(written, &T::read)
    }
}

/// The text form of a field of type `T` that consists of numbers. The type `K` says which numbers are accepted, see [`Numeric`].
pub(crate) struct As<K, T>(PhantomData<(K, T)>);

/// The text form of a field that the user gives, in a scene or a question: finite numbers up to 1e50 in magnitude.
pub(crate) type AsGiven<T> = As<Given, T>;
/// The text form of a field of an answer: any numbers, also infinite ones and NaN.
pub(crate) type AsComputed<T> = As<Computed, T>;

impl<K, T: Numeric<K>> As<K, T> {
    pub(crate) fn serialize<S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
        value.write().serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
        T::Written::deserialize(deserializer).map(T::read)
    }
}

/// Whether a number is positive zero and may be left out of the text; a negative zero is written.
#[allow(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes fields by reference; what is small depends on the processor"
)]
pub(crate) fn is_absent(x: &f64) -> bool {
    x.to_bits() == 0
}
