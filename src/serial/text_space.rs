//! The space of a text that is read or written.
//!
//! Scenes and answers have their text forms for contacts of three axes alone, so that these are compiled once. In the text of a planar scene a row
//! has two numbers, and a moment is one number.

use std::cell::Cell;

use crate::numerics::Space;

thread_local! {
    static SPACE: Cell<Option<Space>> = const { Cell::new(None) };
}

/// The space of rows and wrenches with `C` axes in the text that this thread reads or writes.
pub(crate) fn space_of_text<const C: usize>() -> Space {
    let own = Space::of::<C>();
    if own == Space::Spatial { SPACE.get().unwrap_or(own) } else { own }
}

/// Reads or writes a text of a space.
pub(crate) fn in_text_of<T>(space: Space, act: impl FnOnce() -> T) -> T {
    let _text = TextOf { outer: SPACE.replace(Some(space)) };
    act()
}

/// A text that is read or written, until it is dropped.
struct TextOf {
    outer: Option<Space>,
}

impl Drop for TextOf {
    fn drop(&mut self) {
        SPACE.set(self.outer);
    }
}
