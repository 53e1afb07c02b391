//! What the tests of the command line read on stderr.

/// All lines but those that say how far a command is: on a machine that is busy there may be any number of them.
pub fn notes(stderr: &str) -> Vec<&str> {
    stderr.lines().filter(|line| !line.ends_with("so far") && !line.ends_with("% done")).collect()
}
