//! System packages for the tests: the Vulkan loader with lavapipe (a software GPU, the same
//! on every machine) and Chromium. On Debian and Ubuntu they are installed with apt if that needs no password;
//! otherwise the error shows the command to run.

use crate::shell::{Failure, ask, find_on_path, run};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const VULKAN_PACKAGES: [&str; 2] = ["libvulkan1", "mesa-vulkan-drivers"];
const CHROMIUM_NAMES: [&str; 4] = ["chromium", "google-chrome-stable", "google-chrome", "chromium-browser"];
const DRIVER_FOLDERS: [&str; 3] = ["/usr/share/vulkan/icd.d", "/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d"];
const CHROME_FOR_UBUNTU: &str = "on Ubuntu, where apt has no Chromium but the snap, install Chrome: \
    wget https://dl.google.com/linux/direct/google-chrome-stable_current_amd64.deb && \
    sudo apt-get install --yes ./google-chrome-stable_current_amd64.deb";

/// The path of lavapipe's driver description, for `VK_ICD_FILENAMES`.
pub fn ensure_lavapipe() -> Result<PathBuf, Failure> {
    if let Some(driver) = lavapipe() {
        return Ok(driver);
    }
    apt_install("installing lavapipe", &VULKAN_PACKAGES)?;
    lavapipe().ok_or_else(|| Failure::new("installing lavapipe", "its driver is not where Debian and Ubuntu put it"))
}

/// The Chromium or Chrome used for tests: `CHROMIUM`, or the first one on `PATH`.
pub fn ensure_chromium() -> Result<PathBuf, Failure> {
    if let Some(chromium) = chromium() {
        return Ok(chromium);
    }
    let step = "installing Chromium";
    if ask("apt-cache", &["show", "chromium"]).is_none() && ask("apt-cache", &["show", "chromium-browser"]).is_some() {
        return Err(Failure::new(step, CHROME_FOR_UBUNTU));
    }
    apt_install(step, &["chromium"])?;
    chromium().ok_or_else(|| Failure::new(step, "apt installed it, but it does not start"))
}

/// Installs the Debian package `package` unless `program` is on `PATH`.
pub fn ensure_program(program: &str, package: &str) -> Result<PathBuf, Failure> {
    if let Some(found) = find_on_path(program) {
        return Ok(found);
    }
    let step = format!("installing {program}");
    apt_install(&step, &[package])?;
    find_on_path(program).ok_or_else(|| Failure::new(step, "apt installed it, but it is not on PATH"))
}

fn lavapipe() -> Option<PathBuf> {
    let is_lavapipe = |file: &PathBuf| {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        name.starts_with("lvp_icd") && !name.contains("i686")
    };
    let files_in = |folder: &&str| fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let driver = DRIVER_FOLDERS.iter().flat_map(files_in).find(is_lavapipe)?;
    has_vulkan_loader().then_some(driver)
}

fn has_vulkan_loader() -> bool {
    let library_folders = ["/usr/lib", "/usr/lib64", "/usr/local/lib"].map(Path::new);
    let multiarch = fs::read_dir("/usr/lib").into_iter().flatten().flatten().map(|entry| entry.path());
    multiarch.chain(library_folders.map(Path::to_path_buf)).any(|folder| folder.join("libvulkan.so.1").exists())
}

fn chromium() -> Option<PathBuf> {
    let named = env::var_os("CHROMIUM").map(PathBuf::from);
    let on_path = CHROMIUM_NAMES.iter().filter_map(|name| find_on_path(name));
    named.into_iter().chain(on_path).find(|program| ask(program, &["--version"]).is_some())
}

fn apt_install(step: &str, packages: &[&str]) -> Result<(), Failure> {
    let install = ["apt-get", "install", "--yes", "--no-install-recommends"];
    let by_hand = format!("sudo {} {}", install.join(" "), packages.join(" "));
    let Some(prefix) = privilege() else {
        return Err(Failure::new(step, format!("needs a password, or there is no apt; please run: {by_hand}")));
    };
    // a new system has no package lists, and outdated ones name files that no longer exist
    let mut update = prefix.to_vec();
    update.extend(["apt-get", "update", "--quiet"]);
    run(step, &mut words(&update))?;
    let mut line = prefix.to_vec();
    line.extend(install);
    line.extend(packages);
    run(step, words(&line).env("DEBIAN_FRONTEND", "noninteractive"))
}

/// The command that must precede `apt-get`, if it works without a password.
fn privilege() -> Option<&'static [&'static str]> {
    find_on_path("apt-get")?;
    if ask("id", &["-u"])?.trim() == "0" {
        return Some(&[]);
    }
    ask("sudo", &["-n", "true"]).map(|_| ["sudo", "-n"].as_slice())
}

fn words(line: &[&str]) -> Command {
    let mut command = Command::new(line.first().copied().unwrap_or_default());
    command.args(line.iter().skip(1));
    command
}
