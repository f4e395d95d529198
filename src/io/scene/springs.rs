//! Stiffness in the text of a scene.

use crate::numerics::by_axis;
use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use crate::serial::{ShortList, SpringStiffness, space_of_text};

/// Stiffness, N/m: one number for all directions, two numbers (normal and tangential), or one number for each axis.
pub(super) struct Springs<const C: usize>(pub(super) SVector<f64, C>);

impl<const C: usize> Serialize for Springs<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let axes = space_of_text::<C>().axes();
        ShortList::<SpringStiffness, 3>::of(&self.0.as_slice()[..axes]).serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for Springs<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        ShortList::<SpringStiffness, 3>::read(deserializer, Self::of_given)
    }
}

impl<const C: usize> Springs<C> {
    fn of_given(given: &[f64]) -> Result<Self, String> {
        let axes_of_text = space_of_text::<C>().axes();
        match *given {
            [all] => Ok(Self(SVector::repeat(all))),
            [n, t] => Ok(Self(by_axis(|a| if a == 0 { n } else { t }))),
            ref axes if axes.len() == axes_of_text => Ok(Self(SVector::from_column_slice(axes))),
            ref other => {
                let or_axes = if axes_of_text == 3 { " or 3 (normal, two tangential)" } else { "" };
                Err(format!(
                    "{} given, must be one for all directions, or 2 (normal, tangential){or_axes}, each a number or \"rigid\"",
                    other.len()
                ))
            }
        }
    }
}
