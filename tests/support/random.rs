//! Random cases that are the same in every run, so that failures are reproducible.

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

pub fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}
