//! Objects of a text, that is, sets of named fields, which are checked as a whole after they are read.

use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};

/// Reads an object of the text as `W` and converts it by `make` to a `T`. If the text is no object, the message says that `what` is expected. The
/// conversion takes place while the deserializer is still inside the object. If `make` fails, a format with lines and columns therefore adds the
/// right position to the message: the end of the object, not a later position in the text.
pub(crate) fn read<'de, W, T, D>(
    deserializer: D,
    what: &'static str,
    make: impl FnOnce(W) -> Result<T, String>,
) -> Result<T, D::Error>
where
    W: Deserialize<'de>,
    D: Deserializer<'de>,
{
    deserializer.deserialize_map(Object { what, make, written: PhantomData })
}

struct Object<W, F> {
    what: &'static str,
    make: F,
    written: PhantomData<W>,
}

impl<'de, W, T, F> Visitor<'de> for Object<W, F>
where
    W: Deserialize<'de>,
    F: FnOnce(W) -> Result<T, String>,
{
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        // Text with an example, in { }, already shows that an object is expected; a mere name does not.
        let brackets = if self.what.contains('{') { "" } else { ", an object in { }" };
        write!(f, "{}{brackets}", self.what)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
        let written = W::deserialize(MapAccessDeserializer::new(map))?;
        (self.make)(written).map_err(A::Error::custom)
    }
}

/// Reads and writes a type by the fields that it derives with `#[serde(remote = "Self")]`, and refuses text that is no object.
macro_rules! read_as_object {
    ($what:expr, $name:ident $(, $dimension:ident)?) => {
        impl<$(const $dimension: usize)?> serde::Serialize for $name<$($dimension)?> {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                Self::serialize(self, serializer)
            }
        }

        impl<'de $(, const $dimension: usize)?> serde::Deserialize<'de> for $name<$($dimension)?> {
            fn deserialize<S: serde::Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
                struct Fields<T>(T);

                impl<'de $(, const $dimension: usize)?> serde::Deserialize<'de> for Fields<$name<$($dimension)?>> {
                    fn deserialize<S: serde::Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
                        $name::deserialize(deserializer).map(Self)
                    }
                }

                crate::serial::object::read(deserializer, $what, |Fields(value)| Ok(value))
            }
        }
    };
}
pub(crate) use read_as_object;
