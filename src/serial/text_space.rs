//! Whether the text that is read or written belongs to a planar or a spatial scene.
//!
//! Text forms are compiled only for vectors of three components. In the text of a planar scene a row nevertheless has two numbers, and a moment is
//! one number. A thread-local variable therefore holds the space, planar or spatial, to which the text belongs.

use std::cell::Cell;

use crate::numerics::Space;

thread_local! {
    static SPACE: Cell<Option<Space>> = const { Cell::new(None) };
}

/// The space to which rows and wrenches with `C` axes belong, in the text that this thread reads or writes. Three axes may belong to either space;
/// the result is then the space that [`in_text_of`] has set for this thread.
pub(crate) fn space_of_text<const C: usize>() -> Space {
    let own = Space::of::<C>();
    if own == Space::Spatial { SPACE.get().unwrap_or(own) } else { own }
}

/// Calls `act`, which reads or writes a text of this space.
pub(crate) fn in_text_of<T>(space: Space, act: impl FnOnce() -> T) -> T {
    let _text = TextOf { outer: SPACE.replace(Some(space)) };
    act()
}

/// Keeps the space of the surrounding text, planar or spatial, which is restored when this value is dropped.
struct TextOf {
    outer: Option<Space>,
}

impl Drop for TextOf {
    fn drop(&mut self) {
        SPACE.set(self.outer);
    }
}
