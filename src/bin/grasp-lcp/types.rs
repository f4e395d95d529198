//! Scenes and answers as the program has them: vectors have three components, in the plane too, where the third is zero.

use grasp_lcp::scene;

pub(crate) type Setup = scene::Setup<3>;
pub(crate) type Question = scene::Question<3>;
pub(crate) type Answer = scene::Answer<3>;
