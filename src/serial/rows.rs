//! Rows of numbers: points, forces, stiffnesses along the axes.

use std::fmt;
use std::marker::PhantomData;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeSeq, Serializer};

use super::numbers::{Kind, Number, NumberVisitor};
use super::text_space::space_of_text;
use crate::numerics::Space;

/// A list of at most `MOST` numbers; a single number is read as a list of one. K is the [`Kind`] of the numbers, which determines the allowed values.
pub(crate) struct ShortList<K, const MOST: usize> {
    pub(crate) values: [f64; MOST],
    pub(crate) count: usize,
    kind: PhantomData<K>,
}

impl<K, const MOST: usize> ShortList<K, MOST> {
    pub(crate) fn of(list: &[f64]) -> Self {
        let mut values = [0.0; MOST];
        values[..list.len()].copy_from_slice(list);
        Self { values, count: list.len(), kind: PhantomData }
    }

    pub(crate) fn as_slice(&self) -> &[f64] {
        &self.values[..self.count]
    }
}

impl<K: Kind, const MOST: usize> Serialize for ShortList<K, MOST> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut seq = serializer.serialize_seq(Some(self.count))?;
        for x in self.as_slice() {
            seq.serialize_element(&Number::<K>::new(*x))?;
        }
        seq.end()
    }
}

impl<'de, K: Kind, const MOST: usize> Deserialize<'de> for ShortList<K, MOST> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::read(deserializer, |list| Ok(Self::of(list)))
    }
}

impl<K: Kind, const MOST: usize> ShortList<K, MOST> {
    /// Reads a list and converts it to a `T`. If the conversion fails, its error is returned before the deserializer has left the list. The parser of
    /// the format then adds to the message the position of the end of this list.
    pub(crate) fn read<'de, D: Deserializer<'de>, T>(
        deserializer: D,
        make: fn(&[f64]) -> Result<T, String>,
    ) -> Result<T, D::Error> {
        deserializer.deserialize_any(FewVisitor::<K, T, MOST> { make, kind: PhantomData })
    }
}

struct FewVisitor<K, T, const MOST: usize> {
    make: fn(&[f64]) -> Result<T, String>,
    kind: PhantomData<K>,
}

impl<'de, K: Kind, T, const MOST: usize> Visitor<'de> for FewVisitor<K, T, MOST> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "a list of at most {MOST} numbers")
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<T, E> {
        let x = NumberVisitor::<K>::new().visit_f64(x)?;
        (self.make)(&[x]).map_err(E::custom)
    }

    fn visit_u64<E: Error>(self, x: u64) -> Result<T, E> {
        self.visit_f64(x as f64)
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<T, E> {
        self.visit_f64(x as f64)
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<T, E> {
        let x = NumberVisitor::<K>::new().visit_str(word)?;
        (self.make)(&[x]).map_err(E::custom)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<T, A::Error> {
        let (mut values, mut count) = ([0.0; MOST], 0);
        while let Some(number) = seq.next_element::<Number<K>>()? {
            if count < MOST {
                values[count] = number.0;
            }
            count += 1;
        }
        if count > MOST {
            return Err(A::Error::invalid_length(count, &self));
        }
        (self.make)(&values[..count]).map_err(A::Error::custom)
    }
}

/// A row of a text with one number for each axis, two in the plane and three in space. K is the [`Kind`] of the numbers, which determines the allowed
/// values.
pub(crate) struct AxisRow<K, const C: usize>(pub(crate) SVector<f64, C>, PhantomData<K>);

impl<K, const C: usize> AxisRow<K, C> {
    pub(crate) fn new(row: SVector<f64, C>) -> Self {
        Self(row, PhantomData)
    }
}

impl<K: Kind, const C: usize> Serialize for AxisRow<K, C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let axes = space_of_text::<C>().axes();
        ShortList::<K, C>::of(&self.0.as_slice()[..axes]).serialize(serializer)
    }
}

impl<'de, K: Kind, const C: usize> Deserialize<'de> for AxisRow<K, C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let row = deserializer.deserialize_seq(RowVisitor::<K, C>(PhantomData))?;
        Ok(Self::new(row))
    }
}

struct RowVisitor<K, const C: usize>(PhantomData<K>);

impl<'de, K: Kind, const C: usize> Visitor<'de> for RowVisitor<K, C> {
    type Value = SVector<f64, C>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let space = space_of_text::<C>();
        let name = if space == Space::Planar { "planar" } else { "spatial" };
        write!(f, "{} numbers in a {name} scene", space.axes())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
        let axes = space_of_text::<C>().axes();
        let (mut row, mut count) = (SVector::zeros(), 0);
        while let Some(number) = seq.next_element::<Number<K>>()? {
            if count < axes {
                row[count] = number.0;
            }
            count += 1;
        }
        if count == axes { Ok(row) } else { Err(A::Error::invalid_length(count, &self)) }
    }
}
