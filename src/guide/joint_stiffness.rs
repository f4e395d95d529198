//! From the joint stiffness of a hand to the stiffness of its contacts.
//!
//! A finger with joint angles θ, Jacobian `J` of its tip (m/rad, in the contact frame: rows normal, tangential) and joint stiffness `K_θ` (N m/rad: gears,
//! tendons and the position controller's gain) gives way at the tip by its **compliance**
//!
//! ```text
//! C_finger = J K_θ⁻¹ Jᵀ        δu = C_finger F        [m/N]
//! ```
//!
//! and a commanded change of the joint angles moves the tip by `u_f = J δθ` – the [`command`](crate::grasp::Contact::command) of the contact. Tip, pad and
//! object are springs in series: **compliances add**, each along the axes of the contact frame,
//!
//! ```text
//! 1/k = C_finger + C_pad + C_body
//! ```
//!
//! so that [`finger_stiffness_axes`](crate::grasp::Contact::finger_stiffness_axes) takes `1/(C_finger + C_pad)` for each axis.
//! [`body_stiffness_axes`](crate::grasp::Contact::body_stiffness_axes) takes `1/C_body`.
//!
//! # What is left out
//!
//! A contact of this crate has one spring for each axis of its frame: the off-diagonal `C_nt` of the finger's compliance
//! is not represented. Pushing a tilted finger also shifts its tip sideways, and that part is lost. How much it matters
//! says the coupling
//!
//! ```text
//! ρ = C_nt / √(C_nn C_tt),      |ρ| <= 1
//! ```
//!
//! of the *sum* of compliances, pad and body included: soft pads make it small. In space, turn the [`tangent`](crate::grasp::Contact::tangent) to a
//! principal axis of the tangential block, and only coupling with the normal is left.
//!
//! Where the joints' torque is limited, `τ = Jᵀ F` of the answer's force on the object, the torque with which the joints hold it (N m), says whether
//! they reach it.
//!
//! ```
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//! use nalgebra::{Matrix2, Vector2};
//!
//! // Two links of 50 mm, the first along x, the second along y beside the object: the tip presses along -x.
//! // Contact frame: normal (-1, 0), tangent t = (n_y, -n_x) = (0, 1).
//! let (l, k): (f64, [f64; 2]) = (0.05, [4.0, 2.0]); // m, N m/rad
//! let tip_by_joints = Matrix2::<f64>::new(-l, -l, l, 0.0); // rows x, y for θ = (0, 90°)
//! let frame = Matrix2::new(-1.0, 0.0, 0.0, 1.0); // rows n, t
//! let jacobian = frame * tip_by_joints;
//! let joints = Matrix2::from_diagonal(&Vector2::new(1.0 / k[0], 1.0 / k[1]));
//! let finger = jacobian * joints * jacobian.transpose();
//! assert!((finger[(0, 0)] - l * l * (1.0 / k[0] + 1.0 / k[1])).abs() < 1e-15);
//!
//! // A silicone pad of 2 kN/m under it, and a rigid object.
//! let pad = 1.0 / 2e3;
//! let compliance = [finger[(0, 0)] + pad, finger[(1, 1)] + pad];
//! let coupling = finger[(0, 1)] / (compliance[0] * compliance[1]).sqrt();
//! assert!((coupling - 0.3824).abs() < 1e-4); // the joints alone have 0.577
//!
//! let close = jacobian * Vector2::new(0.0, 0.1); // the outer joint closes by 0.1 rad
//! let finger = |side: f64| {
//!     Contact::new([0.03 * side, 0.0], [-side, 0.0])
//!         .finger_stiffness(1.0 / compliance[0], 1.0 / compliance[1])
//!         .friction(0.6)
//!         .command([close[0], 0.0])
//! };
//! let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
//! // Squeezed with u_n / C_nn each, the pair slides at 2 μ N.
//! let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?.factor();
//! let exact = 2.0 * 0.6 * close[0] / compliance[0];
//! assert!(onset.is_some_and(|newtons| (newtons / exact - 1.0).abs() < 1e-14));
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
