//! The machine that times are measured on, in words and in reports.

use crate::counted::counted;

/// A machine and how the program was built for it.
#[derive(serde::Serialize)]
pub struct Machine {
    cpu: Option<String>,
    cores: Option<usize>,
    threads: usize,
    system: String,
    optimised: bool,
}

impl Machine {
    /// The machine that the program runs on.
    pub fn this() -> Self {
        Self {
            cpu: std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| model_name(&text)),
            cores: std::thread::available_parallelism().ok().map(std::num::NonZero::get),
            threads: 1,
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            optimised: !cfg!(debug_assertions),
        }
    }

    /// In words.
    pub fn say(&self) -> String {
        let cpu = self.cpu.as_deref().unwrap_or("a processor that does not say its name");
        let cores = self.cores.map_or_else(String::new, |cores| counted!(cores, ", 1 core", ", {cores} cores"));
        let build = if self.optimised { "" } else { "; not a release build: times are too long" };
        format!("{cpu}{cores} ({}); one thread{build}", self.system)
    }
}

/// The name of the first processor in Linux's `/proc/cpuinfo`.
fn model_name(cpuinfo: &str) -> Option<String> {
    let line = cpuinfo.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn processor_is_read_from_cpuinfo() {
        assert_eq!(model_name("processor\t: 0\nmodel name\t: A B @ 2 GHz\n"), Some("A B @ 2 GHz".to_owned()));
        assert_eq!(model_name("Features : fp"), None);
    }
}
