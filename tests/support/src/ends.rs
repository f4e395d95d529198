//! Assertions about the end of a load path and the behaviour beyond it.

use grasp_lcp::load_path::{Beyond, LoadPath, Loss, LossKind};

/// The loss of a path that ends at a limit load: no equilibrium exists beyond.
///
/// # Panics
/// If the path ended in another way.
pub fn limit_load<'p, const C: usize>(path: &'p LoadPath<'_, C>) -> &'p Loss<C> {
    match (path.end().and_then(|end| end.loss()), path.beyond()) {
        (Some(loss), Some(Beyond::LimitLoad)) => loss,
        (_, beyond) => panic!("{:?}, beyond it {beyond:?}", path.end()),
    }
}

/// The loss of a path that ends while other equilibria exist beyond.
///
/// # Panics
/// If the path ended in another way.
pub fn snap<'p, const C: usize>(path: &'p LoadPath<'_, C>, kind: LossKind) -> &'p Loss<C> {
    match (path.end().and_then(|end| end.loss()), path.beyond()) {
        (Some(loss), Some(Beyond::Snap)) if loss.kind == kind => loss,
        (_, beyond) => panic!("{:?}, beyond it {beyond:?}", path.end()),
    }
}
