//! What this machine can print with: a TeX engine, else a browser, else the words that say what to install.

use std::env;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use super::super::failure::Failure;

/// What makes the pages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Engine {
    /// A TeX engine, from the LaTeX.
    Tex(PathBuf),
    /// A browser related to Chromium, from the HTML.
    Browser(PathBuf),
}

impl Engine {
    /// Where the program is.
    pub fn program(&self) -> &Path {
        match self {
            Engine::Tex(program) | Engine::Browser(program) => program,
        }
    }

    /// As a person calls it: `pdflatex`.
    pub fn name(&self) -> String {
        name(self.program())
    }
}

/// The name of a program without its folder and ending.
pub fn name(program: &Path) -> String {
    program.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// TeX engines, the quickest first. Where more than one is installed all of them will do.
const TEX: [&str; 3] = ["pdflatex", "lualatex", "xelatex"];

/// Browsers that print without a window. Those of the systems' shops come last: they may be shut in, and not see our files.
const BROWSERS: [&str; 7] = [
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "microsoft-edge-stable",
    "msedge",
    "chromium",
    "chromium-browser",
];

/// Where MacTeX is, also for programs that were not started from a terminal.
const TEX_ON_MACOS: &str = "/Library/TeX/texbin";

/// Where browsers are on macOS, which puts none on the path.
const BROWSERS_ON_MACOS: [&str; 3] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
];

/// Where browsers are on Windows, below the folder that a variable names.
const BROWSERS_ON_WINDOWS: [(&str, &str); 5] = [
    ("ProgramFiles", r"Google\Chrome\Application\chrome.exe"),
    ("ProgramFiles(x86)", r"Google\Chrome\Application\chrome.exe"),
    ("LOCALAPPDATA", r"Google\Chrome\Application\chrome.exe"),
    ("ProgramFiles(x86)", r"Microsoft\Edge\Application\msedge.exe"),
    ("ProgramFiles", r"Microsoft\Edge\Application\msedge.exe"),
];

/// What to print with, the best first; nothing if this machine has nothing.
///
/// `CAROM_TEX` and `CAROM_BROWSER` name a program, by its name or its path, or say `none`. TeX comes first; but where
/// its own fonts lack letters, a browser that knows those of the machine does, unless a person has named the TeX engine.
pub fn engines(letters: Letters) -> Result<Vec<Engine>, Failure> {
    let tex = chosen("CAROM_TEX", tex)?.map(Engine::Tex);
    let is_named = env::var_os("CAROM_TEX").is_some_and(|value| !value.is_empty());
    if let Some(tex) = tex {
        if is_named || letters == Letters::OfTex {
            return Ok(vec![tex]);
        }
        // A browser that cannot be had is no fault here: there is TeX.
        let browser = chosen("CAROM_BROWSER", browser).ok().flatten().map(Engine::Browser);
        return Ok(browser.into_iter().chain([tex]).collect());
    }
    Ok(chosen("CAROM_BROWSER", browser)?.map(Engine::Browser).into_iter().collect())
}

/// The letters of a work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// TeX's own fonts have them all.
    OfTex,
    /// Those fonts lack some: of a name in another script, say.
    Others,
}

/// The program that a variable names, else the one that is found.
fn chosen(variable: &str, found: fn() -> Option<PathBuf>) -> Result<Option<PathBuf>, Failure> {
    match env::var_os(variable).filter(|value| !value.is_empty()) {
        None => Ok(found()),
        Some(value) if value == "none" => Ok(None),
        Some(value) => match program(&value) {
            Some(program) => Ok(Some(program)),
            None => Err(Failure::with_help(
                format!("`{variable}` names `{}`, which is no program here", value.to_string_lossy()),
                format!("give the whole path of the program, or unset `{variable}` to take what there is"),
            )),
        },
    }
}

fn tex() -> Option<PathBuf> {
    let on_macos = || TEX.iter().find_map(|name| runnable(Path::new(TEX_ON_MACOS).join(name)));
    TEX.iter().find_map(|name| on_path(OsStr::new(name))).or_else(|| on("macos").then(on_macos)?)
}

fn browser() -> Option<PathBuf> {
    let on_macos = || BROWSERS_ON_MACOS.iter().find_map(|path| runnable(PathBuf::from(path)));
    let on_windows = || {
        let below = |(variable, rest): &(&str, &str)| runnable(PathBuf::from(env::var_os(variable)?).join(rest));
        BROWSERS_ON_WINDOWS.iter().find_map(below)
    };
    BROWSERS
        .iter()
        .find_map(|name| on_path(OsStr::new(name)))
        .or_else(|| on("macos").then(on_macos)?)
        .or_else(|| on("windows").then(on_windows)?)
}

fn on(system: &str) -> bool {
    env::consts::OS == system
}

/// A program by its name or by its path.
fn program(value: &OsStr) -> Option<PathBuf> {
    let path = Path::new(value);
    if path.components().count() > 1 { runnable(std::path::absolute(path).ok()?) } else { on_path(value) }
}

/// A program on the path. Only whole folders count: a program must not come out of the folder where one stands.
fn on_path(name: &OsStr) -> Option<PathBuf> {
    let folders = env::var_os("PATH")?;
    let whole = env::split_paths(&folders).filter(|folder| folder.is_absolute());
    whole.map(|folder| folder.join(name)).find_map(runnable)
}

/// The path, if there is a program: on Windows with its ending.
fn runnable(path: PathBuf) -> Option<PathBuf> {
    if is_runnable(&path) {
        return Some(path);
    }
    let mut ended = OsString::from(&path);
    ended.push(env::consts::EXE_SUFFIX);
    let ended = PathBuf::from(ended);
    is_runnable(&ended).then_some(ended)
}

#[cfg(unix)]
fn is_runnable(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    path.metadata().is_ok_and(|data| data.is_file() && data.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_runnable(path: &Path) -> bool {
    path.is_file() && path.extension().is_some()
}

/// That there is nothing, and what to install.
pub fn nothing() -> Failure {
    Failure::with_help("nothing on this machine can make a PDF", install(env::consts::OS))
}

/// What to install on a system.
fn install(system: &str) -> &'static str {
    match system {
        "macos" => {
            "install MacTeX (`brew install --cask basictex`) or Google Chrome (`brew install --cask google-chrome`)"
        }
        "windows" => {
            "install MiKTeX (`winget install MiKTeX.MiKTeX`) or Google Chrome (`winget install Google.Chrome`)"
        }
        _ => {
            "install TeX, on Debian or Ubuntu with `sudo apt install texlive-latex-base texlive-pictures`, \
             or Chromium (`sudo apt install chromium`)"
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_system_is_told_what_to_install() {
        for (system, said) in [("linux", "apt install"), ("macos", "brew install"), ("windows", "winget install")] {
            assert!(install(system).contains(said), "{system}");
        }
    }

    #[test]
    fn a_program_is_called_by_its_name() {
        let engine = Engine::Browser("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome".into());
        assert_eq!(engine.name(), "Google Chrome");
        assert_eq!(Engine::Tex("/opt/tex/pdflatex".into()).name(), "pdflatex");
    }
}
