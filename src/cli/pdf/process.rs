//! A program run within limits of time and of talk.

use std::io::{self, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// A program that says more than this has lost its way, and TeX would fill the disk with the same words in its log.
const MOST_SAID: usize = 8 << 20;

/// How often a program is looked at: seldom enough to cost nothing, often enough that nobody waits for it.
const GLANCE: Duration = Duration::from_millis(5);

/// How long what a program has started may outlive it.
const AFTERLIFE: Duration = Duration::from_millis(300);

/// How a program ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// By itself, and it said that all is well.
    Well,
    /// By itself, and it said that something is wrong.
    Badly,
    /// It was stopped at the limit of its time.
    TooLate,
    /// It was stopped because it would not stop talking.
    TooMuch,
}

/// Runs a program to its end, or ends it, and returns what it said on both of its outputs.
pub fn run(mut command: Command, limit: Duration) -> io::Result<(Ended, String)> {
    let (mut reader, writer) = io::pipe()?;
    command.stdin(Stdio::null()).stdout(writer.try_clone()?).stderr(writer);
    in_a_group_of_its_own(&mut command);
    let mut child = command.spawn()?;
    // The command holds our ends of the pipe, which would never run dry.
    drop(command);
    let (sender, chunks) = channel();
    thread::spawn(move || {
        let mut chunk = [0; 1 << 14];
        while let Ok(length @ 1..) = reader.read(&mut chunk) {
            if sender.send(chunk[..length].to_vec()).is_err() {
                break;
            }
        }
    });
    let mut said = Vec::new();
    let ended = watch(&mut child, &chunks, &mut said, Instant::now() + limit);
    if !matches!(ended, Ok(Ended::Well | Ended::Badly)) || !ran_dry(&chunks, &mut said) {
        stop_all(&mut child);
    }
    Ok((ended?, String::from_utf8_lossy(&said).into_owned()))
}

fn watch(child: &mut Child, chunks: &Receiver<Vec<u8>>, said: &mut Vec<u8>, end: Instant) -> io::Result<Ended> {
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(judged(status));
        }
        if Instant::now() >= end {
            return Ok(Ended::TooLate);
        }
        match chunks.recv_timeout(GLANCE) {
            Ok(chunk) => said.extend(chunk),
            Err(RecvTimeoutError::Timeout) => {}
            // It has closed its outputs, and may still be writing a file.
            Err(RecvTimeoutError::Disconnected) => thread::sleep(GLANCE),
        }
        if said.len() > MOST_SAID {
            return Ok(Ended::TooMuch);
        }
    }
}

fn judged(status: ExitStatus) -> Ended {
    if status.success() { Ended::Well } else { Ended::Badly }
}

/// Reads the rest of what was said; false if somebody still holds the outputs open.
fn ran_dry(chunks: &Receiver<Vec<u8>>, said: &mut Vec<u8>) -> bool {
    let end = Instant::now() + AFTERLIFE;
    while said.len() <= MOST_SAID {
        match chunks.recv_timeout(end.saturating_duration_since(Instant::now())) {
            Ok(chunk) => said.extend(chunk),
            Err(RecvTimeoutError::Timeout) => return false,
            Err(RecvTimeoutError::Disconnected) => return true,
        }
    }
    false
}

/// So that what a program has started can be stopped together with it.
#[cfg(unix)]
fn in_a_group_of_its_own(command: &mut Command) {
    use std::os::unix::process::CommandExt;
    command.process_group(0);
}

#[cfg(not(unix))]
fn in_a_group_of_its_own(_: &mut Command) {}

/// Stops a program and whatever it has started. That something has gone already is no failure.
fn stop_all(child: &mut Child) {
    let group = child.id().to_string();
    let mut killer = if cfg!(windows) {
        let mut killer = Command::new("taskkill");
        killer.args(["/T", "/F", "/PID", &group]);
        killer
    } else {
        // The standard library signals one process; every shell signals a group.
        let mut killer = Command::new("/bin/sh");
        killer.args(["-c", "kill -s KILL -- \"-$0\"", &group]);
        killer
    };
    let _ = killer.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status();
    let _ = child.kill();
    let _ = child.wait();
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn shell(script: &str, limit: Duration) -> (Ended, String) {
        let mut command = Command::new("/bin/sh");
        command.args(["-c", script]);
        run(command, limit).unwrap()
    }

    const LONG: Duration = Duration::from_secs(60);

    #[test]
    fn a_program_is_heard_on_both_outputs() {
        assert_eq!(shell("echo out; echo err >&2", LONG), (Ended::Well, "out\nerr\n".into()));
        assert_eq!(shell("echo why; exit 3", LONG), (Ended::Badly, "why\n".into()));
    }

    #[test]
    fn what_a_program_has_started_is_stopped_with_it() {
        let scratch = super::super::scratch::Scratch::new().unwrap();
        let sign = scratch.folder().join("alive");
        let later = format!("(sleep 2; echo alive > '{}') &", sign.display());
        assert_eq!(shell(&format!("{later} sleep 1000"), Duration::from_millis(300)).0, Ended::TooLate);
        assert_eq!(shell(&format!("{later} echo done"), LONG), (Ended::Well, "done\n".into()));
        // Long enough that either would have given its sign.
        thread::sleep(Duration::from_secs(4));
        assert!(!sign.exists());
    }

    #[test]
    fn a_program_that_will_not_stop_talking_is_stopped() {
        let (ended, said) = shell("while :; do echo aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa; done", LONG);
        assert_eq!(ended, Ended::TooMuch);
        assert!(said.len() < 2 * MOST_SAID);
    }

    #[test]
    fn a_program_that_is_not_there_is_a_fault() {
        assert!(run(Command::new("/nowhere/pdflatex"), LONG).is_err());
    }
}
