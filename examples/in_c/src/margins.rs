//! Load and margins of the watch, for C.

use grasp_lcp::screening::{ScreeningVerdict, Watched};
use grasp_lcp::spatial::Wrench;
use safer_ffi::prelude::*;

use crate::finger::Vector;

/// A load on the object.
#[derive_ReprC(rename = "grasp_lcp_load")]
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Load {
    /// Force, N.
    pub force: Vector,
    /// Moment about the origin, N m.
    pub moment: Vector,
}

impl Load {
    pub(crate) fn wrench(&self) -> Wrench {
        Wrench::new(self.force.components(), self.moment.components())
    }
}

/// Margins of measured forces. A quantity that the watch does not know is NAN.
#[derive_ReprC(rename = "grasp_lcp_watched")]
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Margins {
    /// The least margin of a finger, `μ F_n - |F_t|`, N. It is negative if the finger slides already.
    pub margin: f64,
    /// The finger with the least margin, from 0.
    pub tightest: usize,
    /// The multiple of the load to come at which the first finger slides; INFINITY if no finger ever slides.
    pub first_slip: f64,
    /// The least increase of all commanded forces, as a part of them, with which the load to come is held; 0 if no increase is needed.
    pub extra_squeeze: f64,
}

impl From<Watched> for Margins {
    fn from(seen: Watched) -> Self {
        let slip = seen.first_slip();
        let never = if slip.verdict() == ScreeningVerdict::Never { f64::INFINITY } else { f64::NAN };
        Self {
            margin: seen.margin(),
            tightest: seen.tightest(),
            first_slip: slip.factor().unwrap_or(never),
            extra_squeeze: seen.extra_squeeze().factor().unwrap_or(f64::NAN),
        }
    }
}
