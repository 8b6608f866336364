//! Where each value of a JSON text stands, by its path: `before.A.speed`, `questions[0].scene.e`.

use std::ops::Range;

/// Deeper than any file of ours; what is below stays without a place.
const DEEPEST: usize = 100;

/// The place of every value in a JSON text that has been read already, in the order in which they end; of a string its
/// quotes included.
pub fn places(text: &str) -> Vec<(String, Range<usize>)> {
    let mut walk = Walk { text, at: 0, depth: 0, found: Vec::new() };
    walk.value("");
    walk.found
}

/// The place of a value; of the nearest one around it that there is, if the text does not have it.
///
/// Nothing if the text has nothing of the path at all.
pub fn place_of(text: &str, path: &str) -> Option<Range<usize>> {
    let places = places(text);
    let mut path = path.trim_end_matches('.');
    loop {
        if path.is_empty() {
            return None;
        }
        if let Some((_, place)) = places.iter().find(|(known, _)| known == path) {
            return Some(place.clone());
        }
        path = &path[..path.rfind(['.', '[']).unwrap_or(0)];
    }
}

/// The byte before a line and column, which serde_json counts from 1 and gives of the last byte it read.
pub fn offset(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    (before + column.saturating_sub(1)).min(text.len().saturating_sub(1))
}

struct Walk<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
    found: Vec<(String, Range<usize>)>,
}

impl Walk<'_> {
    fn peek(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().take_while(|byte| byte.is_ascii_whitespace() || matches!(byte, b',' | b':')).count();
        self.text.as_bytes().get(self.at).copied()
    }

    /// A string; its place, quotes included.
    fn string(&mut self) -> Range<usize> {
        let start = self.at;
        let mut escaped = false;
        for (index, byte) in self.text.as_bytes()[start + 1..].iter().enumerate() {
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = true,
                b'"' => {
                    self.at = start + index + 2;
                    return start..self.at;
                }
                _ => {}
            }
        }
        self.at = self.text.len();
        start..self.at
    }

    fn value(&mut self, path: &str) {
        self.depth += 1;
        if self.depth > DEEPEST {
            self.at = self.text.len();
        }
        let first = self.peek();
        let start = self.at;
        match first {
            Some(b'{') => {
                self.at += 1;
                while self.peek() == Some(b'"') {
                    let key = self.string();
                    let key = self.text[key].trim_matches('"').to_owned();
                    let below = if path.is_empty() { key } else { format!("{path}.{key}") };
                    self.value(&below);
                }
                self.at = (self.at + 1).min(self.text.len());
            }
            Some(b'[') => {
                self.at += 1;
                let mut index = 0;
                while self.peek().is_some_and(|byte| byte != b']') {
                    self.value(&format!("{path}[{index}]"));
                    index += 1;
                }
                self.at = (self.at + 1).min(self.text.len());
            }
            Some(b'"') => drop(self.string()),
            _ => {
                let rest = &self.text.as_bytes()[self.at..];
                self.at +=
                    rest.iter().take_while(|byte| byte.is_ascii_alphanumeric() || b"+-.".contains(byte)).count().max(1);
                self.at = self.at.min(self.text.len());
            }
        }
        self.depth -= 1;
        if start < self.at {
            self.found.push((path.to_owned(), start..self.at));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_where_each_value_stands() {
        let text = r#"{ "masses": {"A": "2", "B": null}, "before": {"A": ["x\"", "1"], "B": {"speed": "u"}} }"#;
        let found: Vec<(String, &str)> = places(text).into_iter().map(|(path, place)| (path, &text[place])).collect();
        let expected = [
            ("masses.A", r#""2""#),
            ("masses.B", "null"),
            ("masses", r#"{"A": "2", "B": null}"#),
            ("before.A[0]", r#""x\"""#),
            ("before.A[1]", r#""1""#),
            ("before.A", r#"["x\"", "1"]"#),
            ("before.B.speed", r#""u""#),
            ("before.B", r#"{"speed": "u"}"#),
            ("before", r#"{"A": ["x\"", "1"], "B": {"speed": "u"}}"#),
            ("", text),
        ];
        assert_eq!(found, expected.map(|(path, text)| (path.to_owned(), text)));
    }

    #[test]
    fn carom_knows_the_nearest_place_of_what_is_missing() {
        let text = r#"{"questions": [{"scene": {"e": "1"}}]}"#;
        let at = |path: &str| place_of(text, path).map(|place| &text[place]);
        assert_eq!(at("questions[0].scene.e"), Some("\"1\""));
        assert_eq!(at("questions[0].scene.masses.A"), Some(r#"{"e": "1"}"#));
        assert_eq!(at("questions[0].scene."), Some(r#"{"e": "1"}"#));
        assert_eq!(at("papers[3]"), None);
        let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
        assert!(places(&deep).len() <= DEEPEST);
    }
}
