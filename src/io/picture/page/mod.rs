//! Grasps as HTML pages. On a page a spatial grasp can be turned with the mouse; it can also be drawn as a still picture. A slider selects the answers
//! of a planar grasp.

mod content;
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
mod still;
mod table;

pub use self::content::Page;
pub use self::eye::View;
