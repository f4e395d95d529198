//! Pictures of grasps in equilibrium, for notebooks.

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::picture::{Page, View, draw_grasp};
use pyo3::PyResult;

use crate::errors::{refused, wrong};
use crate::stored_grasp::StoredGrasp;

/// Pictures of a grasp, in the plane and in space.
pub(crate) trait PythonPicture<const C: usize> {
    /// The grasp with its forces, as SVG.
    fn svg(&self, state: &Equilibrium<C>, title: &str) -> PyResult<String>;
    /// The grasp with its forces as a page whose view can be rotated; `None` in the plane.
    fn page(&self, state: &Equilibrium<C>, title: &str) -> PyResult<Option<String>>;
}

impl PythonPicture<2> for StoredGrasp<2> {
    fn svg(&self, state: &Equilibrium<2>, title: &str) -> PyResult<String> {
        let grasp = self.without_joints("pictures").map_err(refused)?;
        let outline: Vec<[f64; 2]> = self.setup.outline.iter().map(|corner| (*corner).into()).collect();
        draw_grasp(grasp, state, Some(&outline), title).map_err(wrong)
    }

    fn page(&self, _: &Equilibrium<2>, _: &str) -> PyResult<Option<String>> {
        Ok(None)
    }
}

impl PythonPicture<3> for StoredGrasp<3> {
    fn svg(&self, state: &Equilibrium<3>, title: &str) -> PyResult<String> {
        self.with_state(state, title)?.to_svg(Some(0), View::default()).map_err(wrong)
    }

    fn page(&self, state: &Equilibrium<3>, title: &str) -> PyResult<Option<String>> {
        self.with_state(state, title)?.to_html().map(Some).map_err(wrong)
    }
}

impl StoredGrasp<3> {
    fn with_state(&self, state: &Equilibrium<3>, title: &str) -> PyResult<Page> {
        let grasp = self.without_joints("pictures").map_err(refused)?;
        let mut page = Page::new(grasp, "Forces on the object").frame(title, state);
        if !self.setup.outline.is_empty() {
            page = page.outline(self.setup.outline.iter().map(|corner| <[f64; 3]>::from(*corner)));
        }
        Ok(page)
    }
}
