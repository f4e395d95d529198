//! Contacts of many grasps as arrays: one array for each datum, of shape (grasps, contacts) or (grasps, contacts, axes).

use grasp_lcp::grasp::{Contact, Hold};
use numpy::ndarray::{ArrayView1, ArrayView2, ArrayView3};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3};
use pyo3::prelude::*;

/// Arrays from Python. All have the same number B of grasps and n of contacts; broadcast axes have strides of zero. Absent data are `None`.
#[derive(FromPyObject)]
pub(crate) struct GivenColumns<'py> {
    #[pyo3(item)]
    points: PyReadonlyArray3<'py, f64>,
    #[pyo3(item)]
    normals: PyReadonlyArray3<'py, f64>,
    #[pyo3(item)]
    tangents: Option<PyReadonlyArray3<'py, f64>>,
    #[pyo3(item)]
    body_stiffness: Option<PyReadonlyArray3<'py, f64>>,
    #[pyo3(item)]
    finger_stiffness: Option<PyReadonlyArray3<'py, f64>>,
    #[pyo3(item)]
    series_stiffness: Option<PyReadonlyArray3<'py, f64>>,
    #[pyo3(item)]
    friction: PyReadonlyArray2<'py, f64>,
    #[pyo3(item)]
    command: Option<PyReadonlyArray3<'py, f64>>,
    #[pyo3(item)]
    command_world: Option<PyReadonlyArray3<'py, f64>>,
    #[pyo3(item)]
    pressed_with: Option<PyReadonlyArray2<'py, f64>>,
    #[pyo3(item)]
    clearance: Option<PyReadonlyArray2<'py, f64>>,
    /// Code of each contact, shape (n,): 0 unilateral, 1 kept closed, 2 bonded.
    #[pyo3(item)]
    hold: Option<PyReadonlyArray1<'py, u8>>,
}

/// Views of the arrays in place, for threads that do not hold the interpreter's lock.
pub(crate) struct Columns<'a> {
    points: ArrayView3<'a, f64>,
    normals: ArrayView3<'a, f64>,
    tangents: Option<ArrayView3<'a, f64>>,
    body_stiffness: Option<ArrayView3<'a, f64>>,
    finger_stiffness: Option<ArrayView3<'a, f64>>,
    series_stiffness: Option<ArrayView3<'a, f64>>,
    friction: ArrayView2<'a, f64>,
    command: Option<ArrayView3<'a, f64>>,
    command_world: Option<ArrayView3<'a, f64>>,
    pressed_with: Option<ArrayView2<'a, f64>>,
    clearance: Option<ArrayView2<'a, f64>>,
    hold: Option<ArrayView1<'a, u8>>,
}

impl GivenColumns<'_> {
    pub(crate) fn view(&self) -> Columns<'_> {
        fn three<'a>(given: Option<&'a PyReadonlyArray3<'_, f64>>) -> Option<ArrayView3<'a, f64>> {
            given.map(|array| array.as_array())
        }
        fn two<'a>(given: Option<&'a PyReadonlyArray2<'_, f64>>) -> Option<ArrayView2<'a, f64>> {
            given.map(|array| array.as_array())
        }
        Columns {
            points: self.points.as_array(),
            normals: self.normals.as_array(),
            tangents: three(self.tangents.as_ref()),
            body_stiffness: three(self.body_stiffness.as_ref()),
            finger_stiffness: three(self.finger_stiffness.as_ref()),
            series_stiffness: three(self.series_stiffness.as_ref()),
            friction: self.friction.as_array(),
            command: three(self.command.as_ref()),
            command_world: three(self.command_world.as_ref()),
            pressed_with: two(self.pressed_with.as_ref()),
            clearance: two(self.clearance.as_ref()),
            hold: self.hold.as_ref().map(|array| array.as_array()),
        }
    }
}

impl Columns<'_> {
    /// Number of grasps.
    pub(crate) fn rows(&self) -> usize {
        self.points.shape()[0]
    }

    /// Number of axes of a contact, 2 in the plane and 3 in space.
    pub(crate) fn axes(&self) -> usize {
        self.points.shape()[2]
    }

    /// Number of contacts of each grasp.
    pub(crate) fn contacts(&self) -> usize {
        self.points.shape()[1]
    }

    /// Contact `i` of the grasp in row `row`, not validated.
    #[inline]
    pub(crate) fn contact<const C: usize>(&self, row: usize, i: usize) -> Contact<C> {
        let axes = |of: &ArrayView3<'_, f64>| -> [f64; C] { std::array::from_fn(|k| of[[row, i, k]]) };
        let mut contact =
            Contact::new(axes(&self.points), axes(&self.normals)).friction(self.friction[[row, i]]);
        if let Some(k) = &self.body_stiffness {
            contact = contact.body_stiffness_axes(axes(k));
        }
        if let Some(k) = &self.finger_stiffness {
            contact = contact.finger_stiffness_axes(axes(k));
        }
        if let Some(k) = &self.series_stiffness {
            contact = contact.series_stiffness_axes(axes(k));
        }
        if let Some(tangent) = &self.tangents {
            contact = contact.tangent(axes(tangent));
        }
        if let Some(u) = &self.command {
            contact = contact.command(axes(u));
        }
        if let Some(u) = &self.command_world {
            contact = contact.command_world(axes(u));
        }
        if let Some(force) = &self.pressed_with {
            contact = contact.pressed_with(force[[row, i]]);
        }
        if let Some(gap) = &self.clearance {
            contact = contact.clearance(gap[[row, i]]);
        }
        match self.hold.as_ref().and_then(|hold| hold_of(hold[i])) {
            Some(Hold::KeptClosed) => contact.kept_closed(),
            Some(Hold::Bonded) => contact.bonded(),
            _ => contact,
        }
    }
}

fn hold_of(code: u8) -> Option<Hold> {
    [Hold::Unilateral, Hold::KeptClosed, Hold::Bonded].get(usize::from(code)).copied()
}
