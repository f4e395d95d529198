//! Friction that falls as a contact begins to slide.
//!
//! ```text
//! at rest   |F_t| <= μ_s F_n
//! sliding    F_t  =  μ_k F_n p,      μ_k <= μ_s
//! ```
//!
//! A contact has one cone at a time, and what it does says which. Where it begins to slide its springs answer the same stretch with the smaller cone: they
//! relax, and what their force loses the contact slips, `Δs = -K_t⁻¹ ΔF_t`.

use nalgebra::SVector;

use super::answer::ContactResponse;
use super::law::LocalLaw;

impl<const C: usize> LocalLaw<'_, C> {
    /// What a contact that has just begun to slide answers, with its cone of sliding, to the stretch at which it left that of rest. `None` where its force
    /// stays: from an apex it sets out with none.
    pub(crate) fn relaxed(&self, stretch: &SVector<f64, C>) -> Option<ContactResponse<C>> {
        let answer = if self.on_round_cone {
            self.answer(stretch, 0.0)
        } else {
            let (state, force, _) = self.answer_on_polygon(stretch);
            ContactResponse { state: state.into(), force }
        };
        answer.state.slides().then_some(answer)
    }
}
