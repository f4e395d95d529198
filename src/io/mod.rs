//! Scenes and answers as JSON or another text, and pictures of them.

#[cfg(feature = "plot")]
pub mod picture;
#[cfg(feature = "serde")]
pub mod scene;
#[cfg(feature = "schema")]
pub mod schema;
#[cfg(feature = "json")]
pub mod stream;
