//! How texts cross the border of the module: they are written into, and read from, a buffer that Rust owns.
//!
//! The page asks for [`room`], writes the scene there, calls [`answer`], and reads so many bytes from [`text`] on. Each call may move
//! the buffer. Rust reads the buffer as what it is, a vector of bytes, so that no unsafe block is needed.
#![expect(unsafe_code, reason = "names that a page can call are given by attributes that count as unsafe")]

use std::cell::RefCell;

thread_local! {
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Room for a scene of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_mut_ptr()
    })
}

/// Puts the answer in the place of the scene, and returns its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    TEXT.with_borrow_mut(|text| {
        *text = crate::reply(text).into_bytes();
        text.len()
    })
}

/// Where the text begins.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(Vec::as_ptr)
}
