//! Prepared fingers, and the questions to them.

use std::fmt::Debug;

use grasp_lcp::spatial::{Contact, Fingers, Wrench};
use safer_ffi::prelude::*;

use crate::finger::{Finger, Vector};
use crate::seen::{Load, Seen};

/// Fingers made ready for the watch: made by `grasp_lcp_fingers`, freed by `grasp_lcp_fingers_free`.
#[derive_ReprC(rename = "grasp_lcp_fingers")]
#[repr(opaque)]
#[derive(Debug)]
pub struct ReadyFingers {
    ready: Box<dyn Watching>,
}

/// Fingers whose number is known at run time alone.
trait Watching: Debug {
    fn watch(&self, forces: &[Vector], to_come: &Wrench) -> Result<Seen, String>;
}

impl<const N: usize> Watching for Fingers<N> {
    fn watch(&self, forces: &[Vector], to_come: &Wrench) -> Result<Seen, String> {
        let Ok(forces) = <&[Vector; N]>::try_from(forces) else {
            return Err(format!("forces: {} given, must be {N}, one a finger", forces.len()));
        };
        let seen = self.watch(&forces.map(Vector::components), to_come);
        seen.map(Seen::from).map_err(|error| error.to_string())
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

/// A text for C, without the zero bytes that would end it.
fn text(message: String) -> char_p::Box {
    char_p::new(message.replace('\0', ""))
}

/// Checks two to five fingers and makes them ready. Returns NULL and the fingers in `made`; or what is wrong with which finger, a text to be freed
/// by `grasp_lcp_text_free`, and NULL in `made`.
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

/// What forces on the object measured just now have left, N, one a finger, while `to_come` comes on top of the present load. Returns NULL, having allocated nothing;
/// or what is wrong, a text to be freed by `grasp_lcp_text_free`, and leaves `seen` as it is.
#[ffi_export]
pub fn grasp_lcp_watch(
    fingers: &ReadyFingers,
    forces: c_slice::Ref<'_, Vector>,
    to_come: &Load,
    seen: &mut Seen,
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
