//! The browser without a window.

use std::path::Path;
use std::process::Command;

/// The browser that `.ci/run` has made sure of, with a profile of its own in a folder.
pub fn chromium(folder: &Path) -> Command {
    let known = ["google-chrome", "chromium", "chromium-browser"];
    let answers =
        |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success());
    let mut browser = Command::new(known.into_iter().find(answers).expect("there is no Chromium here"));
    browser.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"]);
    browser.arg(format!("--user-data-dir={}", folder.join("profile").display()));
    browser
}
