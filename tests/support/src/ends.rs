//! Ends of load paths, with what lies beyond.

use grasp_lcp::load_path::{Beyond, LoadPath, Loss, LossKind};

/// Where a path was lost at a limit load: nothing holds beyond.
///
/// # Panics
/// If the path ended otherwise.
pub fn limit_load<'p, const C: usize>(path: &'p LoadPath<'_, C>) -> &'p Loss<C> {
    match (path.end().and_then(|end| end.loss()), path.beyond()) {
        (Some(loss), Some(Beyond::LimitLoad)) => loss,
        (_, beyond) => panic!("{:?}, beyond it {beyond:?}", path.end()),
    }
}

/// Where a path was lost while other equilibria exist beyond.
///
/// # Panics
/// If the path ended otherwise.
pub fn snap<'p, const C: usize>(path: &'p LoadPath<'_, C>, kind: LossKind) -> &'p Loss<C> {
    match (path.end().and_then(|end| end.loss()), path.beyond()) {
        (Some(loss), Some(Beyond::Snap)) if loss.kind == kind => loss,
        (_, beyond) => panic!("{:?}, beyond it {beyond:?}", path.end()),
    }
}
