//! Functions for C: prepares fingers, evaluates the watch, and frees memory.

use std::fmt::Debug;

use grasp_lcp::spatial::{Contact, Fingers, Wrench};
use safer_ffi::prelude::*;

use crate::finger::{Finger, Vector};
use crate::margins::{Load, Margins};

/// Fingers prepared for the watch. `grasp_lcp_fingers` makes them, `grasp_lcp_fingers_free` frees them.
#[derive_ReprC(rename = "grasp_lcp_fingers")]
#[repr(opaque)]
#[derive(Debug)]
pub struct ReadyFingers {
    ready: Box<dyn Watching>,
}

/// The watch of any number of fingers, which is a type parameter in Rust and known only at run time in C.
trait Watching: Debug {
    fn watch(&self, forces: &[Vector], to_come: &Wrench) -> Result<Margins, String>;
}

impl<const N: usize> Watching for Fingers<N> {
    fn watch(&self, forces: &[Vector], to_come: &Wrench) -> Result<Margins, String> {
        let Ok(forces) = <&[Vector; N]>::try_from(forces) else {
            return Err(format!("forces: {} given, must be {N}, one a finger", forces.len()));
        };
        let seen = self.watch(&forces.map(Vector::components), to_come);
        seen.map(Margins::from).map_err(|error| error.to_string())
    }
}

fn ready(contacts: &[Contact]) -> Result<Box<dyn Watching>, String> {
    match contacts.len() {
        2 => of::<2>(contacts),
        3 => of::<3>(contacts),
        4 => of::<4>(contacts),
        _ => of::<5>(contacts),
    }
}

fn of<const N: usize>(contacts: &[Contact]) -> Result<Box<dyn Watching>, String> {
    let Ok(contacts) = <&[Contact; N]>::try_from(contacts) else {
        return Err(format!("fingers: {} given, must be from 2 to 5", contacts.len()));
    };
    let fingers = Fingers::new(contacts).map_err(|error| error.to_string())?;
    Ok(Box::new(fingers))
}

/// A text for C. NUL characters are removed, because C ends a text at the first one.
fn text(message: String) -> char_p::Box {
    char_p::new(message.replace('\0', ""))
}

/// Checks two to five fingers and prepares them for the watch. On success it returns NULL and stores the fingers in `made`. On failure it returns a
/// message that names the finger, to be freed by `grasp_lcp_text_free`, and stores NULL in `made`.
#[ffi_export]
pub fn grasp_lcp_fingers(
    fingers: c_slice::Ref<'_, Finger>,
    made: Out<'_, Option<repr_c::Box<ReadyFingers>>>,
) -> Option<char_p::Box> {
    let contacts: Vec<Contact> = fingers.iter().map(Finger::contact).collect();
    let (ready, wrong) = match ready(&contacts) {
        Ok(ready) => (Some(Box::new(ReadyFingers { ready }).into()), None),
        Err(wrong) => (None, Some(text(wrong))),
    };
    made.write(ready);
    wrong
}

/// Computes the margins of measured forces on the object, N, one a finger, before the load `to_come` is added to the present one. On success it
/// stores them in `seen`, returns NULL and has allocated nothing. On failure it returns a message, to be freed by `grasp_lcp_text_free`, and leaves
/// `seen` unchanged.
#[ffi_export]
pub fn grasp_lcp_watch(
    fingers: &ReadyFingers,
    forces: c_slice::Ref<'_, Vector>,
    to_come: &Load,
    seen: &mut Margins,
) -> Option<char_p::Box> {
    match fingers.ready.watch(&forces, &to_come.wrench()) {
        Ok(answer) => {
            *seen = answer;
            None
        }
        Err(wrong) => Some(text(wrong)),
    }
}

/// Frees fingers; NULL does nothing.
#[ffi_export]
pub fn grasp_lcp_fingers_free(fingers: Option<repr_c::Box<ReadyFingers>>) {
    drop(fingers);
}

/// Frees a text; NULL does nothing.
#[ffi_export]
pub fn grasp_lcp_text_free(text: Option<char_p::Box>) {
    drop(text);
}
