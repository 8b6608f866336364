//! The formats inside the binary: every file of `templates/`, in the order of their paths.

macro_rules! files {
    ($($path:literal,)*) => {
        &[$(($path, include_str!(concat!("../../templates/", $path))),)*]
    };
}

/// Path from `templates/`, and contents.
pub(super) const FILES: &[(&str, &str)] = files![
    "html/format.toml",
    "html/head.html",
    "html/mark-scheme.html",
    "html/question-sheet.html",
    "html/style.css",
    "latex/format.toml",
    "latex/mark-scheme.tex",
    "latex/preamble.tex",
    "latex/question-sheet.tex",
];
