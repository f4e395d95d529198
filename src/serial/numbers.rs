//! Numbers as text, with words for values that JSON cannot express.
//!
//! serde_json writes an infinite number as `null`, without a warning. Words avoid that: a rigid spring is "rigid", friction without limit is
//! "infinite". An answer that is not finite is "infinite", "-infinite" or "not a number".

use std::fmt;
use std::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::error::{MODERATE, is_moderate};

/// A kind of number, with the words for its non-finite values, and the condition for a number to be accepted.
pub(crate) trait Kind {
    const EXPECTED: &'static str;
    /// Words in the text, with the numbers that they express.
    const WORDS: &'static [(&'static str, f64)] = &[];
    fn allows(_: f64) -> bool {
        true
    }
}

/// A number that the user gives in a scene or a question: finite and at most 1e50 in magnitude.
pub(crate) enum Given {}
/// Coefficients of friction, or the word "infinite".
pub(crate) enum Friction {}
/// Stiffnesses of springs, or the word "rigid".
pub(crate) enum SpringStiffness {}
/// A number in an answer, of any value.
pub(crate) enum Computed {}

impl Kind for Given {
    const EXPECTED: &'static str = "a number";
    fn allows(x: f64) -> bool {
        is_moderate(x)
    }
}

impl Kind for Friction {
    const EXPECTED: &'static str = "a number or \"infinite\"";
    const WORDS: &'static [(&'static str, f64)] = &[("infinite", f64::INFINITY)];
}

impl Kind for SpringStiffness {
    const EXPECTED: &'static str = "a number or \"rigid\"";
    const WORDS: &'static [(&'static str, f64)] = &[("rigid", f64::INFINITY)];
}

impl Kind for Computed {
    const EXPECTED: &'static str = "a number, \"infinite\", \"-infinite\" or \"not a number\"";
    const WORDS: &'static [(&'static str, f64)] =
        &[("infinite", f64::INFINITY), ("-infinite", f64::NEG_INFINITY), ("not a number", f64::NAN)];
}

/// The word for a number that is not finite. If the kind `K` has no word of its own for it, the word is that of [`Computed`], the kind of numbers in
/// answers.
fn word<K: Kind>(x: f64) -> &'static str {
    let stands_for =
        |(_, value): &&(&str, f64)| value.total_cmp(&x).is_eq() || (value.is_nan() && x.is_nan());
    let mut words = K::WORDS.iter().chain(Computed::WORDS);
    words.find(stands_for).map_or("not a number", |(word, _)| word)
}

/// A number of kind `K` in its text form.
pub(crate) struct Number<K>(pub(crate) f64, PhantomData<K>);

impl<K> Number<K> {
    pub(crate) fn new(x: f64) -> Self {
        Self(x, PhantomData)
    }
}

impl<K: Kind> Serialize for Number<K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.is_finite() {
            serializer.serialize_f64(self.0)
        } else {
            serializer.serialize_str(word::<K>(self.0))
        }
    }
}

impl<'de, K: Kind> Deserialize<'de> for Number<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor::<K>::new()).map(Self::new)
    }
}

pub(crate) struct NumberVisitor<K>(PhantomData<K>);

impl<K> NumberVisitor<K> {
    pub(crate) fn new() -> Self {
        Self(PhantomData)
    }
}

impl<K: Kind> Visitor<'_> for NumberVisitor<K> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(K::EXPECTED)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<f64, E> {
        if K::allows(x) { Ok(x) } else { Err(E::custom(format_args!("{x:e} must be {MODERATE}"))) }
    }

    fn visit_u64<E: Error>(self, x: u64) -> Result<f64, E> {
        self.visit_f64(x as f64)
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<f64, E> {
        self.visit_f64(x as f64)
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<f64, E> {
        let known = K::WORDS.iter().find(|(known, _)| *known == word);
        known.map(|(_, value)| *value).ok_or_else(|| E::invalid_value(Unexpected::Str(word), &self))
    }
}
