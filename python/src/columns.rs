//! Contacts of many grasps as arrays: one array for each quantity, of shape (grasps, contacts) or (grasps, contacts, axes).

use grasp_lcp::grasp::{Contact, Hold, SoftFingertip};
use grasp_lcp::scene::FingertipPatch;
use numpy::ndarray::{ArrayView1, ArrayView2, ArrayView3};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3};
use pyo3::prelude::*;

use crate::errors::{of_json, wrong};

/// Arrays from Python, all for the same number B of grasps and n of contacts; broadcast axes have strides of zero. Absent quantities are `None`.
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
    #[pyo3(item("kinetic_friction"), default)]
    kinetic: Option<PyReadonlyArray2<'py, f64>>,
    /// The pad (soft fingertip) of each contact in JSON, as in scenes; `null` for a single point.
    #[pyo3(item, default)]
    soft: Option<String>,
    /// Code of each contact, shape (n,): 0 unilateral, 1 kept closed, 2 bonded.
    #[pyo3(item)]
    hold: Option<PyReadonlyArray1<'py, u8>>,
}

/// Views of the arrays, without copies, for threads that do not hold the interpreter's lock.
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
    kinetic: Option<ArrayView2<'a, f64>>,
    soft: Option<&'a str>,
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
            kinetic: two(self.kinetic.as_ref()),
            soft: self.soft.as_deref(),
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

    /// The pads (soft fingertips) of all contacts; `None` for a contact that is a single point.
    ///
    /// # Errors
    /// A text that is no list of pads; a pad that is out of range, or belongs to the other space.
    pub(crate) fn pads<const C: usize>(&self) -> PyResult<Pads<C>> {
        let mut pads = self.soft.map_or_else(|| Ok(Vec::new()), read_pads)?;
        pads.resize_with(self.contacts(), || None);
        Ok(Pads(pads))
    }

    /// Appends the points of all contacts of the grasp in a row to a list. A malformed contact is appended as one point, which the grasp then
    /// refuses.
    pub(crate) fn fill<const C: usize>(&self, pads: &Pads<C>, row: usize, points: &mut Vec<Contact<C>>) {
        for (i, pad) in pads.0.iter().enumerate() {
            let contact = self.contact(row, i);
            match pad.as_ref().and_then(|pad| pad.contacts(&contact).ok()) {
                Some(spread) => points.extend(spread),
                None => points.push(contact),
            }
        }
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
        if let Some(kinetic) = &self.kinetic {
            contact = contact.kinetic(kinetic[[row, i]]);
        }
        match self.hold.as_ref().and_then(|hold| hold_of(hold[i])) {
            Some(Hold::KeptClosed) => contact.kept_closed(),
            Some(Hold::Bonded) => contact.bonded(),
            _ => contact,
        }
    }
}

/// For each contact its pad (soft fingertip), or `None` for a single point.
pub(crate) struct Pads<const C: usize>(Vec<Option<SoftFingertip<C>>>);

impl<const C: usize> Pads<C> {
    /// The number of points of each contact.
    pub(crate) fn counts(&self) -> Vec<usize> {
        self.0.iter().map(|pad| pad.as_ref().map_or(1, |pad| pad.points().len())).collect()
    }
}

/// The offsets of the points of a pad along the tangents, m, and their shares of the springs.
type PadPoints = (Vec<Vec<f64>>, Vec<f64>);

/// The points of each pad (soft fingertip) of a JSON list, in the plane or in space. The list has an entry for each contact; `null` is a single
/// point.
#[pyfunction]
pub(crate) fn points_of_pads(soft: &str, axes: usize) -> PyResult<Vec<PadPoints>> {
    if axes == 2 { pad_points::<2>(soft) } else { pad_points::<3>(soft) }
}

fn pad_points<const C: usize>(soft: &str) -> PyResult<Vec<PadPoints>> {
    let of = |pad: &Option<SoftFingertip<C>>| match pad {
        Some(pad) => pad.points().map(|(offset, share)| (offset.as_slice()[1..].to_vec(), share)).unzip(),
        None => (vec![vec![0.0; C - 1]], vec![1.0]),
    };
    Ok(read_pads::<C>(soft)?.iter().map(of).collect())
}

fn read_pads<const C: usize>(soft: &str) -> PyResult<Vec<Option<SoftFingertip<C>>>> {
    let mut pads = Vec::new();
    let tips: Vec<Option<FingertipPatch>> =
        serde_json::from_str(soft).map_err(|error| of_json("soft", &error))?;
    for (index, tip) in tips.iter().enumerate() {
        let pad = tip.as_ref().map(FingertipPatch::spread::<C>).transpose();
        pads.push(pad.map_err(|error| wrong(format_args!("soft[{index}]: {error}")))?);
    }
    Ok(pads)
}

fn hold_of(code: u8) -> Option<Hold> {
    [Hold::Unilateral, Hold::KeptClosed, Hold::Bonded].get(usize::from(code)).copied()
}
