//! How serde writes outcomes: vectors as lists, `{"solved": {"z": …, "w": …, "basis": [0, 1], …}}`, `{"infeasible": {"y": …, "pivots": 3}}`, …

use super::basis::Basis;
use nalgebra::DVector;
use serde::{Serialize, Serializer};

/// A basis is serialised as the list of the i with z_i basic.
impl Serialize for Basis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

/// Serialises a vector as a list.
pub(crate) fn list<S: Serializer>(v: &DVector<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    v.as_slice().serialize(serializer)
}
