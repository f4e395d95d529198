//! Friction that falls as a contact begins to slide.
//!
//! ```text
//! at rest   |F_t| <= μ_s F_n
//! sliding    F_t  =  μ_k F_n p,      μ_k <= μ_s
//! ```
//!
//! A contact has one cone at a time, which depends on its state. When it begins to slide, its springs answer the same stretch with the smaller
//! cone: they relax, and the contact slips by the loss of their force, `Δs = -K_t⁻¹ ΔF_t`.

use nalgebra::SVector;

use super::answer::ContactResponse;
use super::law::LocalLaw;

impl LocalLaw<'_> {
    /// State and force on the sliding cone of a contact that has just begun to slide, at the stretch at which it left the cone of rest. `None`
    /// where its force does not change: from an apex it starts without force.
    pub(crate) fn relaxed(&self, stretch: &SVector<f64, 3>) -> Option<ContactResponse> {
        let answer = self.response(stretch, 0.0);
        answer.state.slides().then_some(answer)
    }
}
