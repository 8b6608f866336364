//! A scene from a file or from stdin, as TOML or JSON.

use std::path::Path;

use super::failure::Failure;
use super::json_scene;
use super::text_file::{bytes, name_of};
use crate::bank::read_scene;
use crate::diagnostic::Source;
use crate::mechanics::Scene;

/// No scene is longer than this.
const LONGEST: u64 = 1 << 20;

/// The scene in a file, or on stdin if the file is `-`.
pub fn scene(path: &Path) -> Result<Scene, Failure> {
    let name = name_of(path);
    let bytes = bytes(path, LONGEST)?;
    if bytes.len() as u64 > LONGEST {
        let message = format!("`{name}` is too long for a scene: more than {LONGEST} bytes");
        return Err(Failure::with_help(message, "is it another file? `carom solve --help` shows a scene"));
    }
    let text = String::from_utf8(bytes)
        .map_err(|_| Failure::with_help(format!("`{name}` is no text"), "a scene is a file in TOML or JSON"))?;
    // A byte order mark is no part of either language.
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    if text.trim().is_empty() {
        return Err(Failure::with_help(format!("`{name}` is empty"), "`carom solve --help` shows a scene"));
    }
    let source = Source::new(name, text);
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let is_json = match ending.as_deref() {
        Some("json") => true,
        Some("toml") => false,
        // A list or a word is no scene in either language; `[masses]` is a heading of TOML, and no list.
        _ => text.trim_start().starts_with('{') || serde_json::from_str::<serde_json::Value>(text).is_ok(),
    };
    let scene = if is_json { json_scene::read(&source) } else { read_scene(&source) };
    Ok(scene?)
}
