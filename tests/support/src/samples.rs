//! How many random scenes a test draws, and which. Each family has a default count and a default seed.
//!
//! `GRASP_LCP_SAMPLES=10` draws ten times as many scenes of every family, `GRASP_LCP_SEED=7` draws others.

use proptest::test_runner::{Config, RngAlgorithm, RngSeed, TestRng, TestRunner};

use super::splitmix::Random;

/// The default count of a family times the factor `GRASP_LCP_SAMPLES`.
pub fn samples(default: usize) -> usize {
    default * usize::try_from(variable("GRASP_LCP_SAMPLES").unwrap_or(1)).expect("a count")
}

/// Asserts that each count is above its bound, times the factor `GRASP_LCP_SAMPLES`: every kind of scene is met.
#[track_caller]
pub fn assert_met(counts: &[(usize, usize)]) {
    let is_met = counts.iter().all(|(count, bound)| *count > samples(*bound));
    assert!(is_met, "{counts:?}");
}

/// The random numbers of a family with this default seed. `GRASP_LCP_SEED` sets the upper bits of its seed.
pub fn seeded(default: u64) -> Random {
    Random(default ^ variable("GRASP_LCP_SEED").unwrap_or(0) << 32)
}

/// The settings of a property with this default count, the same scenes in every run.
pub fn config(default: usize) -> Config {
    Config {
        cases: u32::try_from(samples(default)).expect("a count"),
        rng_seed: RngSeed::Fixed(1 ^ variable("GRASP_LCP_SEED").unwrap_or(0) << 32),
        failure_persistence: None,
        ..Config::default()
    }
}

/// The random generator for scenes of a property outside of `proptest!`, the same in every run.
pub fn runner(config: Config) -> TestRunner {
    let rng = match variable("GRASP_LCP_SEED") {
        None => TestRng::deterministic_rng(RngAlgorithm::ChaCha),
        Some(seed) => TestRng::from_seed(RngAlgorithm::ChaCha, &seed.to_le_bytes().repeat(4)),
    };
    TestRunner::new_with_rng(config, rng)
}

fn variable(name: &str) -> Option<u64> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name} {text}")))
}
