//! How much memory a surface may take: what is free on the machine where the system tells it, else a fixed number, as in a
//! browser. So the largest surface that is read depends on the machine, and nothing else does.

/// What a triangle takes, from the file to the map: two million take 1.2 GB.
pub(super) const BYTES_PER_TRIANGLE: u64 = 600;

/// What a vertex takes while the file is read.
pub(super) const BYTES_PER_VERTEX: u64 = 24;

/// What every surface may take, however little is said to be free: a million triangles.
pub(super) const ALWAYS: u64 = 1_000_000 * BYTES_PER_TRIANGLE;

/// What a surface may take where the free memory is not known: four million triangles, more than half of what 32-bit addresses
/// reach.
const USUAL: u64 = 4_000_000 * BYTES_PER_TRIANGLE;

/// The bytes that a surface may take.
pub(super) fn available() -> u64 {
    if usize::BITS < 64 {
        return USUAL;
    }
    std::fs::read_to_string("/proc/meminfo").ok().and_then(|text| free_in(&text)).unwrap_or(USUAL)
}

/// The free bytes, and those that the system can free, in Linux's `/proc/meminfo`.
fn free_in(meminfo: &str) -> Option<u64> {
    let line = meminfo.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    kilobytes.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_free_memory_is_read_from_meminfo() {
        assert_eq!(free_in("MemTotal:  9 kB\nMemAvailable:   20480 kB\n"), Some(20 << 20));
        for other in ["MemTotal:  9 kB\n", "MemAvailable: many kB\n", "MemAvailable: 20480\n", ""] {
            assert_eq!(free_in(other), None, "{other:?}");
        }
        assert!(available() > 0);
    }
}
