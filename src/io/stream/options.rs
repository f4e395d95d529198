//! Options of a stream. A leg is a section of a load program, whose load path is followed from event to event.

/// Options for answering a stream of scenes: number of threads, short or full answers, and limits, so that no scene delays all later ones for long.
///
/// ```
/// use grasp_lcp::stream::{StreamOptions, answer_lines};
///
/// let scene = r#"{"format": "grasp-lcp/1", "id": "a", "planar": {"contacts": [
///     {"point": [-1, 0], "normal": [1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10},
///     {"point": [1, 0], "normal": [-1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10}],
///     "questions": [{"onset": {"direction": {"force": [0, -2]}}}]}}"#.replace('\n', "");
/// let mut output = Vec::new();
/// answer_lines(scene.as_bytes(), &mut output, &StreamOptions::default().in_brief())?;
/// let brief = r#"{"line":1,"id":"a","brief":[{"question":"onset","outcome":"at","factor":5.0,"first":"contact 0","state":"slides"}]}"#;
/// assert_eq!(String::from_utf8_lossy(&output).trim_end(), brief);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
#[must_use]
pub struct StreamOptions {
    /// Number of worker threads; the output does not depend on it. All cores by default.
    pub threads: usize,
    /// Whether answers are [short](crate::scene::Brief).
    pub brief: bool,
    /// Largest number of contact points. A scene with more points is refused, because all later lines wait for its answer. 2 000 by default.
    pub most_points: usize,
    /// Largest number of combinations of contact states that a scene may try, even if its settings allow more. 20 000 by default.
    pub most_states: usize,
    /// Largest number of integration steps within a leg of a load path, even if the settings of a scene allow more. Steps are needed along parts of
    /// the path on which slip directions turn. 20 000 by default.
    pub most_steps: usize,
    /// For tests of panics: answering a scene panics if its line number is a multiple of this number; 0 for no panics.
    #[doc(hidden)]
    pub fails_every: usize,
}

impl Default for StreamOptions {
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self {
            threads,
            brief: false,
            most_points: 2000,
            most_states: 20_000,
            most_steps: 20_000,
            fails_every: 0,
        }
    }
}

impl StreamOptions {
    setters! {
        /// These options with this number of workers, at least one.
        pub fn on_threads(mut self, threads: usize) { self.threads = threads; }

        /// These options with short answers.
        pub fn in_brief(mut self) { self.brief = true; }
    }
}
