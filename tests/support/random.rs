//! Random cases that are the same in every run, so that failures are reproducible.

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// A case that fails is made smaller so many times: some take seconds.
const SHRUNK: u32 = 32;

pub fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, max_shrink_iters: SHRUNK, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}
