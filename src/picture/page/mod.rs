//! A spatial grasp as a page that one can turn with the mouse, and as a picture that stands still.

mod data;
mod drawing;
mod eye;
mod frame;
mod html;
mod leaving;
mod legend;
mod marks;
mod paint;
mod solid;
mod spatial_page;
mod still;
mod table;
mod text;

pub use self::eye::View;
pub use self::spatial_page::SpatialPage;
