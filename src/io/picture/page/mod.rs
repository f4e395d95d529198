//! Grasps as HTML pages. On a page a spatial grasp can be turned with the mouse; it can also be drawn as a still picture. A slider selects the answers
//! of a planar grasp.

mod data;
mod drawing;
mod eye;
mod frame;
mod html;
mod json;
mod leaving;
mod legend;
mod mark;
mod marks;
mod paint;
mod planar_page;
mod solid;
mod spatial_page;
mod still;
mod table;

pub use self::eye::View;
pub use self::planar_page::PlanarPage;
pub use self::spatial_page::SpatialPage;
