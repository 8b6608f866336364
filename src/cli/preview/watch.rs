//! Waiting for a change: looks again and again, and tells a finished save from one that is under way.

use std::io::{self, Read};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

use crate::cli::failure::Failure;

/// How long between two looks.
const PAUSE: Duration = Duration::from_millis(200);

/// So many looks in a row see the same before it counts: a file may be written in two goes.
const STEADY: usize = 2;

/// So many look in vain before a file counts as gone: editors that save by renaming take it away for a moment.
const GONE: usize = 10;

/// Shows what the first look sees and then what has changed, until whoever reads or writes to us has gone away.
///
/// `has_arrived` says whether a look saw anything.
pub fn watch<T: PartialEq>(
    look: impl Fn() -> T,
    has_arrived: impl Fn(&T) -> bool,
    mut show: impl FnMut(&T) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let (closed, input) = channel();
    listen(closed.clone());
    let mut settling = Settling::default();
    loop {
        let seen = look();
        let enough = if has_arrived(&seen) { STEADY } else { GONE };
        if let Some(settled) = settling.see(seen, enough) {
            show(settled)?;
        }
        if is_closed(&input) {
            return Ok(());
        }
    }
}

/// Waits for the next look.
fn is_closed(input: &Receiver<()>) -> bool {
    !matches!(input.recv_timeout(PAUSE), Err(RecvTimeoutError::Timeout))
}

/// Says when the pipe into us is closed: the program at its other end has gone.
fn listen(closed: Sender<()>) {
    if is_pipe() {
        thread::spawn(move || {
            let mut unread = [0; 256];
            while io::stdin().read(&mut unread).is_ok_and(|length| length > 0) {}
            // If nobody listens any more, we are at our end already.
            let _ = closed.send(());
        });
    }
}

/// Is there a program at the other end of stdin? Neither a terminal, which ends us by itself, nor an empty device.
#[cfg(unix)]
fn is_pipe() -> bool {
    use std::fs::File;
    use std::os::fd::AsFd;
    use std::os::unix::fs::FileTypeExt;
    let file = io::stdin().as_fd().try_clone_to_owned().map(File::from);
    let kind = file.and_then(|file| file.metadata()).map(|data| data.file_type());
    kind.is_ok_and(|kind| kind.is_fifo() || kind.is_socket())
}

#[cfg(not(unix))]
fn is_pipe() -> bool {
    use std::io::IsTerminal;
    !io::stdin().is_terminal()
}

/// What was last shown, and what is seen now but has not been seen for long enough.
struct Settling<T> {
    shown: Option<T>,
    waiting: Option<(T, usize)>,
}

impl<T> Default for Settling<T> {
    fn default() -> Settling<T> {
        Settling { shown: None, waiting: None }
    }
}

impl<T: PartialEq> Settling<T> {
    /// Takes a look into account; gives back what is to be shown now. The first look is shown at once.
    fn see(&mut self, seen: T, enough: usize) -> Option<&T> {
        if self.shown.as_ref() == Some(&seen) {
            self.waiting = None;
            return None;
        }
        let looks = match self.waiting.take() {
            Some((before, looks)) if before == seen => looks + 1,
            _ => 1,
        };
        if looks < enough && self.shown.is_some() {
            self.waiting = Some((seen, looks));
            return None;
        }
        Some(self.shown.insert(seen))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is shown after each look; `-` is a file that is not there, and takes three looks.
    fn shown(looks: &str) -> String {
        let mut settling = Settling::default();
        let one = |look: char| settling.see(look, if look == '-' { 3 } else { 2 }).copied().unwrap_or('.');
        looks.chars().map(one).collect()
    }

    #[test]
    fn a_save_counts_once_it_is_steady() {
        assert_eq!(shown("aaaa"), "a...");
        assert_eq!(shown("aabbb"), "a..b.");
        assert_eq!(shown("abcdd"), "a...d", "a file under way");
        assert_eq!(shown("a-a-a"), "a....", "gone for a moment");
        assert_eq!(shown("a-bb"), "a..b", "saved by renaming");
        assert_eq!(shown("a---aa"), "a..-.a");
        assert_eq!(shown("-aa"), "-.a");
        assert_eq!(shown("abab"), "a...", "taken back");
    }
}
