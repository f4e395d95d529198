//! Lemke's method with lists of contact states as bases, for one contact or a hundred thousand.
//!
//! The contacts are coupled only by the motion of the object. With every contact in a known state
//! its law is linear. So a complementary basis is a list of contact states, and a pivot solves one
//! system with d + 1 rows. The matrix of the complementarity problem is never formed. The pivots
//! are those of the dense solver on [`Form`](crate::forms::Form).
//!
//! | file | idea |
//! |---|---|
//! | `contact_form` | the kinematic form contact by contact |
//! | `basis` | a complementary basis as a list of contact states |
//! | `variables` | the ratio test of one contact |
//! | `path` | Lemke's path from basis to basis |
//! | `proposal` | contact states for the ladder of `search` |

mod basis;
mod contact_form;
mod path;
mod proposal;
mod tolerances;
mod variables;

pub(crate) use proposal::propose;
