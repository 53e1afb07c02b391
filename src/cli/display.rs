//! Suppresses messages about a missing display: the commands need none.
//!
//! Mesa's Vulkan layer "device select" connects to Wayland to learn which device the desktop uses. Without
//! a desktop (containers, services, ssh) libwayland reports on stderr that `XDG_RUNTIME_DIR` is not set, once for each
//! list of adapters. It needs that folder only to complete a relative socket name: if `WAYLAND_DISPLAY` is an absolute
//! path, the connection fails silently.

use std::env;
use std::ffi::OsStr;
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::Command;

/// An absolute path that is never a Wayland socket.
const NO_DISPLAY: &str = "/dev/null";

/// Restarts the process with an environment that names a display, so that libwayland does not complain about a
/// missing one. The restart (same process, same arguments) is used because changing the environment of a running
/// process is unsafe. Returns if no restart is necessary, or if it fails; then only the messages remain.
pub fn name_one() {
    let [folder, display, socket] = ["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].map(env::var_os);
    if socket.is_some() || is_complete(folder.as_deref(), display.as_deref()) {
        return;
    }
    let Ok(program) = env::current_exe() else { return };
    let mut arguments = env::args_os();
    let mut command = Command::new(&program);
    command.arg0(arguments.next().unwrap_or_else(|| program.into_os_string()));
    // `exec` returns only if it fails.
    let _error = command.args(arguments).env("WAYLAND_DISPLAY", NO_DISPLAY).exec();
}

/// Whether libwayland gets an absolute path to a server from these variables.
fn is_complete(folder: Option<&OsStr>, display: Option<&OsStr>) -> bool {
    [folder, display].into_iter().flatten().any(|path| Path::new(path).is_absolute())
}

#[cfg(test)]
mod tests {
    use super::{NO_DISPLAY, is_complete};
    use std::ffi::OsStr;

    #[test]
    fn a_display_is_complete_with_a_folder_or_by_an_absolute_path() {
        let complete =
            |folder: Option<&str>, display: Option<&str>| is_complete(folder.map(OsStr::new), display.map(OsStr::new));
        assert!(!complete(None, None));
        assert!(!complete(None, Some("wayland-0")));
        assert!(!complete(Some(""), None));
        assert!(complete(Some("/run/user/1000"), None));
        assert!(complete(None, Some("/run/user/1000/wayland-0")));
    }

    #[test]
    fn a_restarted_process_is_not_restarted_again() {
        assert!(is_complete(None, Some(OsStr::new(NO_DISPLAY))));
    }
}
