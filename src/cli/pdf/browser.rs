//! HTML to PDF with a browser that shows no window.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use super::super::failure::Failure;
use super::super::write::OutputFile;
use super::repeatable::make_repeatable;
use super::scratch::Scratch;
use super::{documents, finished, machine, no_documents, run};
use crate::render::RenderedFile;

/// One browser after another: each takes the memory of a window.
pub fn print(
    program: &Path,
    files: &[RenderedFile],
    scratch: &Scratch,
    limit: Duration,
) -> Result<Vec<OutputFile>, Failure> {
    let pages = documents(files, ".html");
    if pages.is_empty() {
        return Err(no_documents("html", ".html"));
    }
    for file in files {
        fs::write(scratch.folder().join(&file.name), &file.contents)?;
    }
    pages.into_iter().map(|(file, stem)| one(program, file, stem, scratch, limit)).collect()
}

fn one(
    program: &Path,
    file: &RenderedFile,
    stem: &str,
    scratch: &Scratch,
    limit: Duration,
) -> Result<OutputFile, Failure> {
    let pdf = scratch.folder().join(format!("{stem}.pdf"));
    let mut said = String::new();
    // A browser may fall over in starting, on a machine that has much to do; it is asked once more.
    for attempt in 1..=2 {
        let profile = scratch.folder().join(format!("profile-{stem}-{attempt}"));
        let browser = command(program, file, &profile, &pdf, scratch);
        let outcome = run(program, browser, &file.name, limit);
        take_away_the_socket(&profile);
        (_, said) = outcome?;
        // Browsers exit with 0 and without a page, and the other way round: what counts is the page.
        if let Some(mut contents) = finished(&pdf) {
            make_repeatable(&mut contents);
            return Ok(OutputFile { name: format!("{stem}.pdf"), contents });
        }
    }
    Err(nothing_came(program, &file.name, &said))
}

/// The browser and what it is to do.
fn command(program: &Path, file: &RenderedFile, profile: &Path, pdf: &Path, scratch: &Scratch) -> Command {
    let mut browser = Command::new(program);
    browser.current_dir(scratch.folder());
    browser.args(["--headless", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"]);
    browser.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
    // Its reporter of crashes outlives it, with a hand on the profile.
    browser.args(["--disable-breakpad", "--disable-crash-reporter"]);
    // The second name is that of older browsers; each passes over the other's.
    browser.args(["--no-pdf-header-footer", "--print-to-pdf-no-header"]);
    // A profile of its own, or it would hand the page to a browser that is open already, and be gone; one that printed
    // the document before may not have let go of its own yet.
    browser.arg(with_path("--user-data-dir=", profile));
    browser.arg(with_path("--print-to-pdf=", pdf));
    if is_root(scratch) {
        // The sandbox refuses to work for root, who is the user in most containers.
        browser.arg("--no-sandbox");
    }
    browser.arg(address(&scratch.folder().join(&file.name)));
    browser
}

/// Takes away what a browser that fell over, or was stopped, has left where everybody's work of the moment is kept: the
/// folder of the socket by which a second window would find the first. Its profile holds a link to it.
fn take_away_the_socket(profile: &Path) {
    let Ok(socket) = fs::read_link(profile.join("SingletonSocket")) else { return };
    let Some(folder) = socket.parent() else { return };
    for name in ["SingletonSocket", "SingletonCookie"] {
        let _ = fs::remove_file(folder.join(name));
    }
    // Where there is something else in it, it was not what we took it for, and stays.
    let _ = fs::remove_dir(folder);
}

fn nothing_came(program: &Path, file: &str, said: &str) -> Failure {
    let real = fs::canonicalize(program).unwrap_or_default();
    let help = if said.contains("No usable sandbox") {
        "this system does not allow the browser its sandbox; install a TeX engine, which needs none"
    } else if said.contains("snap") || real.ends_with("snap") || program.starts_with("/snap") {
        "a browser from a snap sees only what is below your home: set `TMPDIR` to a folder there"
    } else {
        "open the HTML in a browser and print it from there, or install a TeX engine"
    };
    Failure::with_help(format!("`{}` made no PDF of `{file}`", machine::name(program)), help)
}

fn with_path(option: &str, path: &Path) -> std::ffi::OsString {
    let mut argument = std::ffi::OsString::from(option);
    argument.push(path);
    argument
}

/// The address of a file: in its path only letters, digits and a few signs mean themselves.
fn address(path: &Path) -> String {
    let path = path.to_string_lossy().replace('\\', "/");
    let mut address = String::from(if path.starts_with('/') { "file://" } else { "file:///" });
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b':' | b'-' | b'_' | b'.' => {
                address.push(char::from(byte));
            }
            _ => address.push_str(&format!("%{byte:02X}")),
        }
    }
    address
}

/// Whose folder is ours, that is who we are: the standard library does not say it otherwise.
#[cfg(unix)]
fn is_root(scratch: &Scratch) -> bool {
    use std::os::unix::fs::MetadataExt;
    fs::metadata(scratch.folder()).is_ok_and(|data| data.uid() == 0)
}

#[cfg(not(unix))]
fn is_root(_: &Scratch) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_says_what_the_path_says() {
        for (path, expected) in [
            ("/tmp/carom-1/question-sheet.html", "file:///tmp/carom-1/question-sheet.html"),
            ("/tmp/a b#c%d?é/x.html", "file:///tmp/a%20b%23c%25d%3F%C3%A9/x.html"),
            (r"C:\Temp\x.html", "file:///C:/Temp/x.html"),
        ] {
            assert_eq!(address(Path::new(path)), expected);
        }
    }
}
