//! Questions of designers about a load path.

use super::ramp::Ramp;
use crate::error::Error;
use crate::grasp::Engine;
use crate::search::Settings;

/// The range of load factors in which no contact stops sticking; see [`Sensitivity::sticking_range`](crate::ask::Sensitivity::sticking_range).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StickingRange {
    /// The least factor, at most 0; minus infinity if there is none.
    pub from: f64,
    /// The largest factor, at least 0; infinity if there is none.
    pub to: f64,
}

impl StickingRange {
    /// Whether a factor lies in the range, ends included.
    #[must_use]
    pub fn contains(&self, factor: f64) -> bool {
        (self.from..=self.to).contains(&factor)
    }
}

impl Engine {
    /// [`Sensitivity::sticking_range`](crate::ask::Sensitivity::sticking_range).
    pub(crate) fn sticking_range(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
    ) -> Result<Option<StickingRange>, Error> {
        let back = ramp.times(-1.0);
        let (to, from) = (self.onset(ramp, settings)?.factor(), self.onset(&back, settings)?.factor());
        Ok(to.zip(from).map(|(to, from)| StickingRange { from: -from, to }))
    }
}
