//! A folder for the work of one moment, which is gone afterwards whatever happens.

use std::collections::hash_map::RandomState;
use std::fs::{self, DirBuilder};
use std::hash::BuildHasher;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

/// A new empty folder that nobody else has or can guess. Removed with all that is in it when it goes out of use.
#[derive(Debug)]
pub struct Scratch {
    folder: PathBuf,
}

/// A name that is taken by accident is taken once; a name that is taken ten times is no accident.
const TRIES: usize = 10;

impl Scratch {
    /// Makes the folder where the machine keeps such things: `TMPDIR`, `TEMP`, or `/tmp`.
    pub fn new() -> io::Result<Scratch> {
        let parent = std::path::absolute(std::env::temp_dir())?;
        for _ in 1..TRIES {
            match make(&parent) {
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                made => return made,
            }
        }
        make(&parent)
    }

    /// Where it is.
    pub fn folder(&self) -> &Path {
        &self.folder
    }
}

fn make(parent: &Path) -> io::Result<Scratch> {
    // The standard library keys its hash maps with entropy of the machine: here that is wanted.
    let name = format!("carom-{:016x}", RandomState::new().hash_one(std::process::id()));
    let folder = parent.join(name);
    // Fails where there is something already, also if that is a link.
    for_us_alone().create(&folder)?;
    Ok(Scratch { folder })
}

#[cfg(unix)]
fn for_us_alone() -> DirBuilder {
    use std::os::unix::fs::DirBuilderExt;
    let mut builder = DirBuilder::new();
    builder.mode(0o700);
    builder
}

#[cfg(not(unix))]
fn for_us_alone() -> DirBuilder {
    DirBuilder::new()
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // A browser that is gone may have left a helper, out of our reach, that is still writing its profile; on a
        // machine with much to do that takes its time. Ten waits, each twice the one before, are four seconds.
        let mut wait = Duration::from_millis(4);
        for _ in 0..TRIES {
            match fs::remove_dir_all(&self.folder) {
                Err(error) if error.kind() != ErrorKind::NotFound => thread::sleep(wait),
                _ => return,
            }
            wait *= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scratch_folder_is_new_private_and_gone_afterwards() {
        let [one, other] = [Scratch::new().unwrap(), Scratch::new().unwrap()];
        assert_ne!(one.folder(), other.folder());
        assert!(one.folder().is_absolute());
        fs::create_dir_all(one.folder().join("a/b")).unwrap();
        fs::write(one.folder().join("a/b/c"), "words").unwrap();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            assert_eq!(fs::metadata(one.folder()).unwrap().permissions().mode() & 0o777, 0o700);
        }
        let path = one.folder().to_path_buf();
        drop(one);
        assert!(!path.exists() && other.folder().exists());
    }
}
