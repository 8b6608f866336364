//! A fault in a person's file: what is wrong, where, what was expected, and one thing to try.

use std::borrow::Cow;
use std::fmt;
use std::io;
use std::ops::Range;
use std::sync::Arc;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// A text with the name under which a person knows it: a file of a bank, or `answer`.
///
/// Cloning is cheap, so that every fault of a text can carry it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The path as the person wrote it.
    pub file: Arc<str>,
    /// The whole text.
    pub text: Arc<str>,
}

impl Source {
    /// A text under its name.
    pub fn new(file: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Source {
        Source { file: file.into(), text: text.into() }
    }
}

/// How bad it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The file cannot be used.
    #[default]
    Error,
    /// It can, but hardly as it was meant.
    Warning,
}

/// One fault, with everything that a person needs to mend it.
///
/// Messages, labels and helps are lower case, with names in backticks and no full stop.
///
/// ```
/// use carom::diagnostic::{Diagnostic, Source};
/// let source = Source::new("rest/speeds.toml", "e = '3/2'\n");
/// let fault = Diagnostic::new("impossible coefficient of restitution `3/2`", &source, 5..8, "must be from 0 to 1");
/// assert_eq!(fault.line(), 1);
/// assert!(fault.to_string().contains("rest/speeds.toml:1:6"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Whether the file can be used in spite of it.
    pub severity: Severity,
    /// What is wrong.
    pub message: String,
    /// The text in which it is.
    pub source: Source,
    /// Where in the text, in bytes. Beyond the text or empty is allowed and shown as one caret.
    pub span: Range<usize>,
    /// The words beside the caret: what was expected.
    pub label: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error without help.
    pub fn new(
        message: impl Into<String>,
        source: &Source,
        span: Range<usize>,
        label: impl Into<String>,
    ) -> Diagnostic {
        let (message, label) = (message.into(), label.into());
        Diagnostic { severity: Severity::Error, message, source: source.clone(), span, label, help: None }
    }

    /// The fault with one thing to try.
    pub fn with_help(self, help: impl Into<String>) -> Diagnostic {
        Diagnostic { help: Some(help.into()), ..self }
    }

    /// The fault with the near name offered, if there is one.
    pub fn with_near(self, near: Option<&str>) -> Diagnostic {
        match near {
            Some(name) => self.with_help(format!("did you mean `{name}`?")),
            None => self,
        }
    }

    /// The line on which it begins, from 1.
    pub fn line(&self) -> usize {
        let before = &self.source.text.as_bytes()[..self.place().start];
        1 + before.iter().filter(|byte| **byte == b'\n').count()
    }

    /// The picture: message, place, line with carets, help. Ends without a line break.
    pub fn render(&self, colour: bool) -> String {
        let (level, help) = match self.severity {
            Severity::Error => (Level::ERROR, Level::HELP),
            Severity::Warning => (Level::WARNING, Level::HELP),
        };
        let message = briefly(&self.message);
        let title = level.primary_title(&*message);
        let mut groups: Vec<Group> = Vec::new();
        if self.source.text.is_empty() {
            groups.push(title.element(annotate_snippets::Origin::path(&*self.source.file)));
        } else {
            let annotation = AnnotationKind::Primary.span(self.place()).label(self.label.as_str());
            groups.push(
                title.element(Snippet::source(&*self.source.text).path(&*self.source.file).annotation(annotation)),
            );
        }
        if let Some(words) = &self.help {
            groups.push(Group::with_title(help.secondary_title(words.as_str())));
        }
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let picture = renderer.render(&groups);
        picture.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
    }

    /// The span, moved into the text and onto whole characters; of several lines only the first.
    fn place(&self) -> Range<usize> {
        let text = &*self.source.text;
        let floor = |mut at: usize| {
            at = at.min(text.len());
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = floor(self.span.start);
        let end = floor(self.span.end).max(start);
        let first_line = text[start..end].find(['\n', '\r']).map_or(end, |length| start + length);
        start..first_line
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Diagnostic {}

/// Several pictures one after another, in the order of their files and lines, a blank line between.
pub fn render_all(diagnostics: &[Diagnostic], colour: bool) -> String {
    let mut sorted: Vec<&Diagnostic> = diagnostics.iter().collect();
    sorted.sort_by(|a, b| (&a.source.file, a.span.start).cmp(&(&b.source.file, b.span.start)));
    let mut text = String::new();
    for (index, diagnostic) in sorted.iter().enumerate() {
        text.push_str(if index == 0 { "" } else { "\n" });
        text.push_str(&diagnostic.render(colour));
        text.push('\n');
    }
    text
}

/// A message in which no word fills a page: of what was typed, or came of it, the beginning and the end tell enough.
///
/// ```
/// use carom::diagnostic::briefly;
/// assert_eq!(briefly("unknown name `speeed`"), "unknown name `speeed`");
/// assert!(briefly(&format!("unknown name `{}`", "x".repeat(9000))).chars().count() < 300);
/// ```
pub fn briefly(message: &str) -> Cow<'_, str> {
    const LONGEST: usize = 400;
    const SHOWN: [usize; 2] = [120, 40];
    let is_long = |word: &str| word.chars().count() > LONGEST;
    if message.len() <= LONGEST || !message.split(' ').any(is_long) {
        return Cow::Borrowed(message);
    }
    let brief = |word: &str| {
        let signs: Vec<char> = word.chars().collect();
        let [first, last] = SHOWN;
        let (first, last) = (&signs[..first.min(signs.len())], &signs[signs.len().saturating_sub(last)..]);
        format!("{}…{}", first.iter().collect::<String>(), last.iter().collect::<String>())
    };
    let words = message.split(' ').map(|word| if is_long(word) { brief(word) } else { word.to_owned() });
    Cow::Owned(words.collect::<Vec<_>>().join(" "))
}

/// Why a file cannot be read, in words of a person.
///
/// ```
/// let error = std::fs::read("no/such/file").unwrap_err();
/// assert_eq!(carom::diagnostic::why_unread(&error), "there is no such file");
/// ```
pub fn why_unread(error: &io::Error) -> String {
    let why = match error.kind() {
        io::ErrorKind::NotFound => "there is no such file",
        io::ErrorKind::PermissionDenied => "you may not open it",
        io::ErrorKind::IsADirectory => "it is a folder",
        io::ErrorKind::NotADirectory => "a file is where a folder should be",
        io::ErrorKind::InvalidFilename => "the name is too long",
        io::ErrorKind::InvalidData => "it is not in UTF-8",
        _ => return error.to_string(),
    };
    why.to_owned()
}

/// What is wrong with a text that should be JSON, or holds other values than it should, in words of a person and without
/// the place.
///
/// ```
/// use carom::diagnostic::why_no_json;
/// let why = |text: &str| why_no_json(&serde_json::from_str::<Vec<usize>>(text).unwrap_err());
/// assert_eq!(why("[1,"), "it ends too early");
/// assert_eq!(why("3"), "it has the number `3`, expected a list");
/// assert_eq!(why("[-3]"), "it has the number `-3`, expected a whole number");
/// ```
pub fn why_no_json(error: &serde_json::Error) -> String {
    if error.is_eof() {
        return "it ends too early".to_owned();
    }
    let said = error.to_string();
    let said = said.split(" at line ").next().unwrap_or_default();
    match of_another_kind(said) {
        Some((found, expected)) => format!("it has {found}, expected {expected}"),
        None => said.to_owned(),
    }
}

/// What was found and what was expected, in words of a person, if a reader of JSON or TOML says that it found a value of
/// another kind.
pub fn of_another_kind(said: &str) -> Option<(String, String)> {
    let of_value = ["invalid type: ", "invalid value: "].iter().find_map(|kind| said.strip_prefix(kind));
    let (found, expected) = of_value?.split_once(", expected ")?;
    let found = match found.split_once(' ') {
        Some(("integer", number)) => format!("the number {number}"),
        Some(("floating", rest)) => format!("the number {}", rest.trim_start_matches("point ")),
        Some(("string", text)) => format!("the text {text}"),
        Some(("boolean", value)) => value.to_owned(),
        _ if found == "map" => "an object".to_owned(),
        _ if found == "sequence" => "a list".to_owned(),
        _ => found.to_owned(),
    };
    let expected = match expected {
        "a sequence" => "a list",
        "a map" => "an object",
        "a string" => "a text in quotes",
        "a boolean" => "true or false",
        "usize" | "u64" | "u32" | "u16" | "u8" => "a whole number",
        _ if expected.starts_with("struct ") => "an object",
        _ => expected,
    };
    Some((found, expected.to_owned()))
}

/// The candidate that was probably meant: the nearest, if few letters differ.
///
/// ```
/// use carom::diagnostic::near;
/// assert_eq!(near("restituton", ["momentum", "restitution"]), Some("restitution"));
/// assert_eq!(near("speed", ["momentum", "restitution"]), None);
/// assert_eq!(near("deflection", ["deflection_dot", "deflection_deg"]), Some("deflection_deg"));
/// ```
pub fn near<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let wanted = name.to_lowercase();
    let length = wanted.chars().count();
    let allowed = (length / 3).clamp(1, 4);
    // As many letters must differ as one name has more than the other: what somebody pasted is not compared with each.
    let is_about_as_long = |candidate: &str| candidate.chars().count().abs_diff(length) <= allowed;
    let distance = |candidate: &str| strsim::osa_distance(&wanted, &candidate.to_lowercase());
    let about_as_long = candidates.iter().filter(|candidate| is_about_as_long(candidate));
    let nearest = about_as_long.map(|candidate| (distance(candidate), *candidate)).min_by_key(|pair| pair.0);
    // What several names begin with is none of them more than the others.
    let begun: Vec<&str> =
        candidates.iter().copied().filter(|candidate| candidate.to_lowercase().starts_with(&wanted)).collect();
    // Of what an angle has it is mostly its degrees.
    if let Some(degrees) = begun.iter().copied().find(|candidate| candidate.strip_prefix(name) == Some("_deg")) {
        return Some(degrees);
    }
    if let Some((apart, nearest)) = nearest {
        // A name of one letter is near every other such name, which helps nobody; but not if only the case differs.
        let (own, other) = without_shared_start(&wanted, nearest);
        let different = apart >= own.chars().count().max(other.chars().count()).max(1);
        if apart <= allowed && !different && begun.len() < 2 {
            return Some(nearest);
        }
    }
    // Only signs between letters differ, as in `AtoB`; or it is the beginning of one name and of no other.
    let letters = |name: &str| name.to_lowercase().replace(['_', '-', ' ', '.'], "");
    let wanted = letters(name);
    match (candidates.iter().find(|candidate| letters(candidate) == wanted), begun.as_slice()) {
        (Some(same), _) => Some(same),
        (None, [only]) if length >= 3 => Some(only),
        _ => None,
    }
}

/// Two names without the parts up to a dot that both begin with: of `B.after.m` and `B.after.x`, `m` and `x`.
fn without_shared_start<'n>(name: &'n str, other: &'n str) -> (&'n str, &'n str) {
    let shared = name.match_indices('.').map(|(at, _)| at + 1);
    let mut shared = shared.filter(|at| other.get(..*at).is_some_and(|start| start.eq_ignore_ascii_case(&name[..*at])));
    let at = shared.next_back().unwrap_or(0);
    (&name[at..], other.get(at..).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_is_shown_as_the_house_style_has_it() {
        let text = "[[part]]\nfind   = [\"velocity_after.C\"]\n";
        let start = text.find("velocity").unwrap();
        let source = Source::new("two_spheres/components.toml", text);
        let label = "model `two-spheres` has spheres `A` and `B`";
        let fault = Diagnostic::new("unknown quantity `velocity_after.C`", &source, start..start + 16, label)
            .with_near(Some("velocity_after.B"));
        let expected = "\
error: unknown quantity `velocity_after.C`
 --> two_spheres/components.toml:2:12
  |
2 | find   = [\"velocity_after.C\"]
  |            ^^^^^^^^^^^^^^^^ model `two-spheres` has spheres `A` and `B`
  |
help: did you mean `velocity_after.B`?";
        assert_eq!(fault.to_string(), expected);
        assert_eq!(fault.line(), 2);
        assert!(fault.render(true).contains("\u{1b}["));
    }

    #[test]
    fn a_span_outside_the_text_or_within_a_character_is_no_panic() {
        for text in ["", "θ", "a\r\nb", "\n\n"] {
            for start in 0..5 {
                for end in 0..5 {
                    let fault = Diagnostic::new("message", &Source::new("file", text), start..end, "label");
                    assert!(fault.to_string().contains("error: message"), "{text:?} {start} {end}");
                    assert!(fault.line() <= 3);
                }
            }
        }
    }

    #[test]
    fn faults_of_a_file_stand_in_the_order_of_its_lines() {
        let source = Source::new("file", "a\nb\n");
        let fault = |at: usize, message: &str| Diagnostic::new(message, &source, at..at + 1, "here");
        let text = render_all(&[fault(2, "second"), fault(0, "first")], false);
        assert!(text.find("first") < text.find("second"));
        assert_eq!(text.matches("error:").count(), 2);
    }

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let names = ["A.after.speed", "B.after.speed", "A.mass", "e"];
        assert_eq!(near("A.after.sped", names), Some("A.after.speed"));
        assert_eq!(near("a.mass", names), Some("A.mass"));
        assert_eq!(near("E", names), Some("e"));
        assert_eq!(near("k", names), None);
        assert_eq!(near("momentum", names), None);
        assert_eq!(near("A.after.m", ["A.after.x", "A.after.speed"]), None);
        assert_eq!(near("AtoB", ["A_to_B", "either"]), Some("A_to_B"));
        assert_eq!(near("angle", ["speed", "angle_deg"]), Some("angle_deg"));
        assert_eq!(near("A.after", names), Some("A.after.speed"));
        assert_eq!(near("A.after", ["A.after.x", "A.after.y"]), None);
        assert_eq!(near("x", []), None);
    }

    #[test]
    fn what_is_far_longer_than_a_name_is_near_none_of_them() {
        // Compared letter by letter this would take for ever.
        let (long, longer) = ("x".repeat(1 << 20), "x".repeat(1 << 21));
        assert_eq!(near(&longer, [long.as_str(), "speed"]), None);
        assert_eq!(near(&long, [longer.as_str(), "speed"]), Some(longer.as_str()), "it is the beginning of that alone");
    }
}
