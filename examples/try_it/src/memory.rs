//! Texts cross the border of the module through a buffer that Rust owns: they are written into it and read from it.
//!
//! The page calls [`room`], writes the scene there, calls [`answer`], and reads that number of bytes at [`text`]. Each call may move the buffer. Rust
//! reads the buffer as a vector of bytes, so that no unsafe block is needed.
#![expect(unsafe_code, reason = "names that a page can call are given by attributes that count as unsafe")]

use std::cell::RefCell;

thread_local! {
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Room for a scene of `length` bytes.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_mut_ptr()
    })
}

/// Replaces the scene by its answer, and returns its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    TEXT.with_borrow_mut(|text| {
        *text = crate::reply(text).into_bytes();
        text.len()
    })
}

/// Address of the text.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(Vec::as_ptr)
}
