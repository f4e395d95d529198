//! Watches measured contact forces of one grasp in a control loop: margin, next slip, and the squeeze that would suffice.

use grasp_lcp::Error;
use grasp_lcp::grasp::Contact;
use grasp_lcp::screening::{Fingers, Watched};
use numpy::PyReadonlyArray2;
use numpy::ndarray::ArrayView2;
use pyo3::prelude::*;

use crate::errors::{refused, shown, wrong};
use crate::loads::wrench;
use crate::onsets::ended;

/// Least margin (N) and its contact; status, load factor and contacts of the first slip; the least relative increase of the squeeze that suffices.
type WatchRow = (f64, usize, u8, f64, Vec<usize>, Option<f64>);

/// A grasp whose measured contact forces can be watched, for any number of contacts and axes.
trait Watches: Send + Sync {
    fn look(&self, forces: &ArrayView2<'_, f64>, to_come: &Bound<'_, PyAny>) -> PyResult<Watched>;
}

impl<const C: usize, const N: usize> Watches for Fingers<C, N> {
    fn look(&self, forces: &ArrayView2<'_, f64>, to_come: &Bound<'_, PyAny>) -> PyResult<Watched> {
        if forces.dim() != (N, C) {
            let (rows, axes) = forces.dim();
            return Err(wrong(format_args!("forces: shape ({rows}, {axes}) given, must be ({N}, {C})")));
        }
        let forces = std::array::from_fn(|i| std::array::from_fn(|k| forces[[i, k]]));
        self.watch(&forces, &wrench("to_come", to_come)?).map_err(|error| match error {
            Error::Contact { contact, value, allowed, .. } => {
                wrong(format_args!("forces[{}] is {}, must be {allowed}", contact.index, shown(value)))
            }
            other => refused(other),
        })
    }
}

/// See `grasp_lcp.Watch`.
#[pyclass(frozen, module = "grasp_lcp._grasp_lcp")]
pub(crate) struct Watch(Box<dyn Watches>);

#[pymethods]
impl Watch {
    fn look(&self, forces: PyReadonlyArray2<'_, f64>, to_come: &Bound<'_, PyAny>) -> PyResult<WatchRow> {
        let watched = self.0.look(&forces.as_array(), to_come)?;
        let first_slip = watched.first_slip();
        let (status, factor) = ended(&first_slip);
        let leaving = first_slip.leaving().collect();
        let enough = watched.extra_squeeze().factor();
        Ok((watched.margin(), watched.tightest(), status as u8, factor, leaving, enough))
    }
}

/// Planar or spatial contacts; a grasp of two to five of them can be watched.
pub(crate) trait Watchable: Sized {
    fn watch(contacts: &[Self]) -> PyResult<Watch>;
}

impl Watchable for Contact<2> {
    fn watch(contacts: &[Self]) -> PyResult<Watch> {
        watch_of::<2>(contacts)
    }
}

impl Watchable for Contact<3> {
    fn watch(contacts: &[Self]) -> PyResult<Watch> {
        watch_of::<3>(contacts)
    }
}

fn watch_of<const C: usize>(contacts: &[Contact<C>]) -> PyResult<Watch> {
    match contacts.len() {
        2 => fingers::<C, 2>(contacts),
        3 => fingers::<C, 3>(contacts),
        4 => fingers::<C, 4>(contacts),
        _ => fingers::<C, 5>(contacts),
    }
}

fn fingers<const C: usize, const N: usize>(contacts: &[Contact<C>]) -> PyResult<Watch> {
    let given = contacts.len();
    let contacts = contacts
        .try_into()
        .map_err(|_| wrong(format_args!("watch: a grasp of {given} contacts given, must be of 2 to 5")))?;
    Ok(Watch(Box::new(Fingers::<C, N>::new(contacts).map_err(refused)?)))
}
