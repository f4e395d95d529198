//! Exchange of texts between page and module, through a buffer that Rust owns.
//!
//! The page calls [`room`] and writes the scene there. Then it calls [`answer`], which returns a length, and reads that number of bytes at
//! [`text`]. Each call may move the buffer. For Rust the buffer is a vector of bytes, so that no unsafe block is needed.
#![expect(unsafe_code, reason = "names that a page can call are given by attributes that count as unsafe")]

use std::cell::RefCell;

thread_local! {
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Reserves the buffer for a scene of `length` bytes, and returns its address.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_mut_ptr()
    })
}

/// Replaces the scene in the buffer by its answer, and returns the length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    TEXT.with_borrow_mut(|text| {
        *text = crate::reply(text).into_bytes();
        text.len()
    })
}

/// The address of the buffer.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(Vec::as_ptr)
}
