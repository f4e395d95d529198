//! The error of pictures.

/// A picture could not be drawn; the message gives the reason.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the picture could not be drawn: {0}")]
pub struct PictureError(pub(super) String);
