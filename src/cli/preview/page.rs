//! The page of a preview: a file of its own, and the browser that shows it.

use std::env;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::cli::failure::Failure;
use crate::cli::write::{OutputFile, no_scratch, write_all};
use crate::expr::print::words_html;

/// A file that a browser shows.
pub struct Page {
    path: PathBuf,
}

impl Page {
    /// The page in a file that a person names, or in a new folder that only this person can read.
    pub fn new(out: Option<&Path>) -> Result<Page, Failure> {
        let path = match out {
            Some(path) => path.to_owned(),
            None => private_folder()?.join("preview.html"),
        };
        match std::path::absolute(&path) {
            Ok(whole) if whole.file_name().is_some() => Ok(Page { path: whole }),
            _ => Err(Failure::with_help(
                format!("`{}` is not the name of a file", path.display()),
                "name the file of the page, such as `--out preview.html`",
            )),
        }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes it, so that a browser never sees a half of it.
    pub fn write(&self, html: &str) -> Result<(), Failure> {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let folder = self.path.parent().unwrap_or(Path::new("."));
        write_all(folder, &[OutputFile { name, contents: html.as_bytes().to_vec() }]).map(drop)
    }

    /// Has it shown, without waiting for the browser to end.
    pub fn open(&self) -> Result<(), Failure> {
        let path = self.path.display().to_string();
        if openers(env::var("BROWSER").ok().as_deref(), &path).iter().any(|words| start(words)) {
            return Ok(());
        }
        let help = format!("open `{path}` in a browser yourself, or name one in the variable BROWSER");
        Err(Failure::with_help("no browser could be started", help))
    }
}

fn private_folder() -> Result<PathBuf, Failure> {
    let mut builder = fs::DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    for attempt in 0..100 {
        let folder = env::temp_dir().join(format!("carom-preview-{}-{attempt}", std::process::id()));
        match builder.create(&folder) {
            Ok(()) => return Ok(folder),
            // Somebody else's: not ours to write into.
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(no_scratch("no folder can be made for the page", &error)),
        }
    }
    Err(Failure::with_help("no temporary folder can be made", "name a file of your own with `--out FILE`"))
}

/// The commands that may show a file, each as its words: the person's own browsers, then the platform's opener.
fn openers(browsers: Option<&str>, path: &str) -> Vec<Vec<String>> {
    let with_path = |command: &str| {
        let mut words: Vec<String> = command.split_whitespace().map(|word| word.replace("%s", path)).collect();
        if !command.contains("%s") {
            words.push(path.to_owned());
        }
        words
    };
    let platform = if cfg!(windows) {
        vec!["cmd", "/c", "start", ""]
    } else if cfg!(target_os = "macos") {
        vec!["open"]
    } else {
        vec!["xdg-open"]
    };
    let named = browsers.unwrap_or_default();
    let named = if cfg!(windows) { vec![named] } else { named.split(':').collect() };
    let mut commands: Vec<Vec<String>> =
        named.into_iter().filter(|command| !command.trim().is_empty()).map(with_path).collect();
    commands.push(platform.into_iter().chain([path]).map(str::to_owned).collect());
    commands
}

/// Starts a command. One that fails at once, as an opener does that finds no browser, has not started.
fn start(words: &[String]) -> bool {
    let Some((program, arguments)) = words.split_first() else { return false };
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    // Ctrl-C ends the watching and not the browser.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    command.spawn().is_ok_and(has_started)
}

fn has_started(mut child: Child) -> bool {
    for _ in 0..10 {
        match child.try_wait() {
            Ok(Some(status)) => return status.success(),
            Ok(None) => thread::sleep(Duration::from_millis(50)),
            Err(_) => return false,
        }
    }
    true
}

/// The page, which its browser loads again every second.
pub fn reloading(html: &str) -> String {
    html.replacen("<head>", "<head>\n<meta http-equiv=\"refresh\" content=\"1\">", 1)
}

/// A page that shows what is wrong, line for line.
pub fn of_faults(words: &str) -> String {
    let lines: Vec<String> = words.lines().map(words_html).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>Faults</title>\n</head>\n\
         <body>\n<main>\n<pre style=\"overflow-x: auto\">\n{}\n</pre>\n</main>\n</body>\n</html>\n",
        lines.join("\n")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn carom_knows_a_persons_own_browsers() {
        let first = |browsers| openers(Some(browsers), "/tmp/a b.html").remove(0);
        assert_eq!(first("firefox"), ["firefox", "/tmp/a b.html"]);
        assert_eq!(first("firefox --new-window %s:w3m"), ["firefox", "--new-window", "/tmp/a b.html"]);
        assert_eq!(openers(Some("firefox:w3m"), "x").len(), 3);
        assert_eq!(openers(Some(""), "x"), openers(None, "x"));
    }

    #[test]
    fn a_page_of_faults_keeps_lines_and_shows_no_tags() {
        let page = of_faults("error: a < b\n  |  <script>");
        assert!(page.contains("error: a &lt; b\n  |  &lt;script&gt;\n</pre>"), "{page}");
        assert!(reloading(&page).contains("<head>\n<meta http-equiv=\"refresh\" content=\"1\">"));
    }
}
