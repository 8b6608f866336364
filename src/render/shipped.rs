//! The formats inside the binary: every file of `templates/`, listed when carom is built.

/// Path from `templates/`, and contents, sorted by path.
pub(super) const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/templates.rs"));
