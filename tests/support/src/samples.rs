//! How many random scenes a test draws.

/// As many as the environment variable `GRASP_LCP_SAMPLES` says, or else this many.
pub fn samples(otherwise: usize) -> usize {
    number("GRASP_LCP_SAMPLES").unwrap_or(otherwise)
}

/// The seed that the environment variable `GRASP_LCP_SEED` says, or else this one.
pub fn seed(otherwise: u64) -> u64 {
    number("GRASP_LCP_SEED").map_or(otherwise, |seed| seed as u64)
}

fn number(variable: &str) -> Option<usize> {
    std::env::var(variable).ok()?.parse().ok()
}
