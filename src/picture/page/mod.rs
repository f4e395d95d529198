//! Grasps as pages: a spatial one that one can turn with the mouse, and as a picture that stands still; a planar one whose answers a slider goes through.

mod data;
mod drawing;
mod eye;
mod frame;
mod html;
mod leaving;
mod legend;
mod marks;
mod paint;
mod planar_page;
mod solid;
mod spatial_page;
mod still;
mod table;
mod text;

pub use self::eye::View;
pub use self::planar_page::PlanarPage;
pub use self::spatial_page::SpatialPage;
