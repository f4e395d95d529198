//! The load and the answer of the watch.

use grasp_lcp::screening::{ScreeningVerdict, Watched};
use grasp_lcp::spatial::Wrench;
use safer_ffi::prelude::*;

use crate::finger::Vector;

/// A load on the object.
#[derive_ReprC(rename = "grasp_lcp_load")]
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Load {
    /// N.
    pub force: Vector,
    /// About the origin, N m.
    pub moment: Vector,
}

impl Load {
    pub(crate) fn wrench(&self) -> Wrench {
        Wrench::new(self.force.components(), self.moment.components())
    }
}

/// What measured forces have left. What the watch does not know is NAN.
#[derive_ReprC(rename = "grasp_lcp_watched")]
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    /// The least margin of a finger, `μ F_n - |F_t|`, N: negative where it slides already.
    pub margin: f64,
    /// The finger with that margin, from 0.
    pub tightest: usize,
    /// At which multiple of the load to come the first finger slides; INFINITY if none ever does.
    pub first_slip: f64,
    /// The least part of all presses to be put on top so that the load to come is held; 0 if it is without.
    pub extra_squeeze: f64,
}

impl From<Watched> for Seen {
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
