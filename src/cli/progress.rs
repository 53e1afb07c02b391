//! Progress messages on stderr, for commands that take long.
//!
//! Each is a whole line that begins with "riemap:". Every two seconds a line says what part of the current work is
//! done, or for how long the command has run. A command that ends before that prints nothing.

use crate::conformal::Stage;
use std::io::Write;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// The time before the first line, and between lines.
const PAUSE: Duration = Duration::from_secs(2);

/// Prints progress lines from a thread of its own until it is dropped.
#[derive(Debug)]
pub struct Progress {
    shared: Arc<Shared>,
    printer: Option<JoinHandle<()>>,
}

#[derive(Debug)]
struct Shared {
    work: Mutex<Work>,
    over: Condvar,
}

#[derive(Debug)]
struct Work {
    words: String,
    /// When the command started.
    since: Instant,
    /// The fraction that is done, if known.
    done: Option<f64>,
    is_over: bool,
}

impl Progress {
    /// Starts reporting; `words` names the current work.
    pub fn new(words: impl Into<String>) -> Self {
        Self::to(std::io::stderr(), PAUSE, words)
    }

    fn to(out: impl Write + Send + 'static, pause: Duration, words: impl Into<String>) -> Self {
        let work = Work { words: words.into(), since: Instant::now(), done: None, is_over: false };
        let shared = Arc::new(Shared { work: Mutex::new(work), over: Condvar::new() });
        let printed = Arc::clone(&shared);
        // if no thread can be started, nothing is printed
        let printer = std::thread::Builder::new().spawn(move || printed.print_lines(out, pause)).ok();
        Self { shared, printer }
    }

    /// Starts the next piece of work.
    pub fn enter(&self, words: impl Into<String>) {
        let mut work = self.shared.work();
        (work.words, work.done) = (words.into(), None);
    }

    /// Sets the fraction that is done.
    pub fn report(&self, done: f64) {
        self.shared.work().done = Some(done);
    }

    /// A callback for the preparation of the side called `name` that enters each stage.
    pub fn preparing(&self, name: &str) -> impl FnMut(Stage) {
        move |stage| self.enter(format!("{name}: {}", stage_words(stage)))
    }
}

/// The words for a stage.
fn stage_words(stage: Stage) -> String {
    let words = match stage {
        Stage::Read => "reading the surface",
        Stage::Sample => "sampling the boundary",
        Stage::Mesh => "triangulating",
        Stage::Assemble => "assembling the Laplacian",
        Stage::Order => "ordering",
        Stage::Factor => "factoring",
        Stage::Integral => "the integral equation",
        Stage::Table { percent } => return format!("harmonic coordinates: {percent} %"),
    };
    words.to_owned()
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.shared.work().is_over = true;
        self.shared.over.notify_all();
        if let Some(printer) = self.printer.take() {
            let _ = printer.join(); // if the thread has panicked, there is nothing left to print
        }
    }
}

impl Shared {
    fn work(&self) -> MutexGuard<'_, Work> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Prints lines until the work is over or writing fails.
    fn print_lines(&self, mut out: impl Write, pause: Duration) {
        while let Some(line) = self.next_line(pause) {
            if writeln!(out, "{line}").is_err() {
                return;
            }
        }
    }

    /// Waits for one or more pauses and returns the next line; `None` when the work is over. The lock is released on
    /// return, so that slow output blocks nobody.
    fn next_line(&self, pause: Duration) -> Option<String> {
        let mut work = self.work();
        loop {
            let waited = self.over.wait_timeout_while(work, pause, |work| !work.is_over);
            work = waited.unwrap_or_else(PoisonError::into_inner).0;
            if work.is_over {
                return None;
            }
            if let Some(line) = work.line(Instant::now()) {
                return Some(line);
            }
        }
    }
}

impl Work {
    fn line(&self, now: Instant) -> Option<String> {
        let words = &self.words;
        match self.done {
            Some(done) if done >= 1.0 => None,
            Some(done) => Some(format!("riemap: {words}: {:.0} % done", (100.0 * done).floor())),
            None => Some(format!("riemap: {words}, {} s so far", now.duration_since(self.since).as_secs())),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_far_the_work_is_or_for_how_long_the_command_has_run() {
        let progress = Progress::new("the picture");
        let since = progress.shared.work().since;
        let line = |seconds| progress.shared.work().line(since + Duration::from_secs_f64(seconds));
        assert_eq!(line(2.01).as_deref(), Some("riemap: the picture, 2 s so far"));
        progress.report(0.459);
        assert_eq!(line(9.0).as_deref(), Some("riemap: the picture: 45 % done"));
        progress.report(1.0);
        assert_eq!(line(9.0), None, "it is done");
        progress.preparing("a.obj")(Stage::Factor);
        assert_eq!(line(12.3).as_deref(), Some("riemap: a.obj: factoring, 12 s so far"));
    }

    /// A fake output: the written bytes, or `None` for one whose writes fail.
    #[derive(Clone)]
    struct Reader(Option<Arc<Mutex<Vec<u8>>>>);

    impl Write for Reader {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            let gone = || std::io::Error::from(std::io::ErrorKind::BrokenPipe);
            self.0.as_ref().ok_or_else(gone)?.lock().unwrap().write(bytes)
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    /// Waits until `holds`, for ten seconds at most.
    fn wait_until(holds: impl Fn() -> bool) -> bool {
        let start = Instant::now();
        while !holds() && start.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(1));
        }
        holds()
    }

    #[test]
    fn progress_lines_name_the_current_work() {
        let written = Arc::new(Mutex::new(Vec::new()));
        let progress = Progress::to(Reader(Some(Arc::clone(&written))), Duration::from_millis(1), "reading");
        let said =
            |line: &str| String::from_utf8_lossy(&written.lock().unwrap()).lines().filter(|l| *l == line).count();
        assert!(wait_until(|| said("riemap: reading, 0 s so far") > 2));
        progress.enter("the animation");
        progress.report(0.5);
        assert!(wait_until(|| said("riemap: the animation: 50 % done") > 2));
        drop(progress);
        let lines = written.lock().unwrap().clone();
        std::thread::sleep(Duration::from_millis(5));
        assert_eq!(*written.lock().unwrap(), lines, "nothing after the end");
    }

    #[test]
    fn progress_ends_silently_when_writing_fails() {
        let mut progress = Progress::to(Reader(None), Duration::from_millis(1), "reading");
        assert!(wait_until(|| progress.printer.as_ref().is_some_and(JoinHandle::is_finished)));
        assert!(progress.printer.take().unwrap().join().is_ok(), "no panic");
    }

    #[test]
    fn progress_ends_at_once_with_the_work() {
        let start = Instant::now();
        let progress = Progress::new("a stage");
        let shared = Arc::downgrade(&progress.shared);
        drop(progress);
        assert!(shared.upgrade().is_none() && start.elapsed() < PAUSE);
    }
}
