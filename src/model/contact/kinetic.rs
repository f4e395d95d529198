//! Friction that decreases as a contact begins to slide.
//!
//! ```text
//! sticking  |F_t| <= μ_s F_n
//! sliding    F_t  =  μ_k F_n p,      μ_k <= μ_s
//! ```
//!
//! Here p is the direction of the friction force, μ_s and μ_k are the static and the kinetic coefficient, and K_t is the tangential stiffness. A
//! contact has one cone at a time, which depends on its state. When it begins to slide, the same stretch is evaluated with the smaller cone. The
//! springs relax, and the contact slips by the loss of their deflection, `Δs = -K_t⁻¹ ΔF_t`.

use nalgebra::SVector;

use super::answer::ContactResponse;
use super::law::LocalLaw;

impl LocalLaw<'_> {
    /// State and force of a contact that has just begun to slide, on the kinetic cone. `stretch` is the stretch at which the force left the static
    /// cone, m. `None` if the contact does not slide at this stretch, as at the apex, where the force is zero.
    pub(crate) fn relaxed(&self, stretch: &SVector<f64, 3>) -> Option<ContactResponse> {
        let answer = self.response(stretch, 0.0);
        answer.state.slides().then_some(answer)
    }
}
