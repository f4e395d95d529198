//! Limits up to which rotations and slips are taken as small.

use crate::error::{Error, is_moderate};

/// Limits of small motions. All computations use the contact points and normals of the undeformed grasp, so an answer beyond these limits is
/// unreliable. A [`Verdict`](crate::hold::Verdict) never claims that a load holds beyond them.
///
/// A translation of the object while every contact sticks only deflects springs. It changes neither normals nor the relative positions of the
/// contacts, and has no limit.
///
/// Where forces that turn with the parts enlarge a motion by more than a tenth, to its limit, it is measured with finite rotations of all parts. That is
/// so while nothing slides, if the points of action of the load are known and springs resist every motion. All other motions are those of the linear
/// theory.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields, default)
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SmallMotions {
    /// Upper limit of the rotation of any body, and of any revolute joint that moves a closed contact, rad (default 0.1).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub rotation: f64,
    /// Upper limit of the slip and of the opening of any contact, as a fraction of the grasp's size (default 0.1). The size is the root mean square
    /// distance of contact points from their centroid. A grasp at a single point has no size, and no limit of this kind.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub slip: f64,
}

impl Default for SmallMotions {
    fn default() -> Self {
        Self { rotation: 0.1, slip: 0.1 }
    }
}

impl SmallMotions {
    /// Returns an error for the first limit, rotation or slip, that is not positive or exceeds 1e50.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let allowed = "more than 0 and at most 1e50";
        let limits = [("rotation of small motions", self.rotation), ("slip of small motions", self.slip)];
        for (what, value) in limits {
            if !(value > 0.0 && is_moderate(value)) {
                return Err(Error::Argument { what, value, allowed });
            }
        }
        Ok(())
    }
}
