//! Fields that are numbers, rows of numbers or lists of rows: their form in a file, by
//! `#[serde(with = "given")]` in questions and `#[serde(with = "found")]` in answers.

use nalgebra::SVector;
use serde::de::{Deserialize, DeserializeOwned, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::numbers::{Found, Given, Kind, Number};
use super::rows::Row;

/// A value made of numbers of a kind.
pub(super) trait Numbers<K>: Sized {
    type Written: Serialize + DeserializeOwned;
    fn write(&self) -> Self::Written;
    fn read(written: Self::Written) -> Self;
}

impl<K: Kind> Numbers<K> for f64 {
    type Written = Number<K>;
    fn write(&self) -> Number<K> {
        Number::new(*self)
    }
    fn read(written: Number<K>) -> Self {
        written.0
    }
}

impl<K: Kind, const C: usize> Numbers<K> for SVector<f64, C> {
    type Written = Row<K, C>;
    fn write(&self) -> Row<K, C> {
        Row::new(*self)
    }
    fn read(written: Row<K, C>) -> Self {
        written.0
    }
}

impl<K, T: Numbers<K>> Numbers<K> for Option<T> {
    type Written = Option<T::Written>;
    fn write(&self) -> Self::Written {
        self.as_ref().map(T::write)
    }
    fn read(written: Self::Written) -> Self {
        written.map(T::read)
    }
}

impl<K, T: Numbers<K>> Numbers<K> for Vec<T> {
    type Written = Vec<T::Written>;
    fn write(&self) -> Self::Written {
        self.iter().map(T::write).collect()
    }
    fn read(written: Self::Written) -> Self {
        written.into_iter().map(T::read).collect()
    }
}

macro_rules! fields_of {
    ($kind:ident, $name:ident) => {
        pub(super) mod $name {
            use super::{Deserialize, Deserializer, Numbers, Serialize, Serializer, $kind};

            pub(in super::super) fn serialize<S: Serializer>(
                value: &impl Numbers<$kind>,
                serializer: S,
            ) -> Result<S::Ok, S::Error> {
                value.write().serialize(serializer)
            }

            pub(in super::super) fn deserialize<'de, T: Numbers<$kind>, D: Deserializer<'de>>(
                deserializer: D,
            ) -> Result<T, D::Error> {
                T::Written::deserialize(deserializer).map(T::read)
            }
        }
    };
}

fields_of!(Given, given);
fields_of!(Found, found);
