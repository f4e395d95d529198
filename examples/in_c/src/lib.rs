//! Functions of grasp-lcp for C: the watch of a control loop, for two to five fingers in space. `grasp_lcp.h` declares them; the test of this package
//! writes that header.

mod finger;
mod fingers;
mod margins;

pub use finger::{Finger, Vector};
pub use fingers::{
    ReadyFingers, grasp_lcp_fingers, grasp_lcp_fingers_free, grasp_lcp_text_free, grasp_lcp_watch,
};
pub use margins::{Load, Margins};

#[cfg(test)]
mod tests {
    /// Compares the header with the generated one, or writes it anew if `WRITE_HEADER` is set.
    #[test]
    fn the_header_is_that_of_these_functions() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/grasp_lcp.h");
        let mut header = Vec::new();
        let written =
            safer_ffi::headers::builder().with_guard("GRASP_LCP_H").to_writer(&mut header).generate();
        written.expect("a list takes all of it");
        if std::env::var_os("WRITE_HEADER").is_some() {
            std::fs::write(path, &header).expect("the file may be written");
        }
        let kept = std::fs::read(path).expect("the header stands beside this package");
        assert!(kept == header, "{path} is old: WRITE_HEADER=1 cargo test --package grasp-lcp-c --lib");
    }
}
