//! The code of a template: what stands between its marks, taken apart into words with their places.
//!
//! Tera keeps its own reading of a template to itself, so that names are found by this one. It follows Tera's:
//! what is raw is text, a closing mark within quotes closes nothing, and a hyphen inside a mark belongs to the mark.
//! It is asked only about templates that Tera has read, and of any other it makes what it can.

use std::ops::Range;

use super::manifest::Marks;

/// A word of code: a name, a number, quoted text, or a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word<'t> {
    /// As it is written, quotes and all.
    pub text: &'t str,
    /// Where it begins in the template, in bytes.
    pub start: usize,
}

impl<'t> Word<'t> {
    /// Where it stands in the template.
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// Is it a name, or a word such as `for`?
    pub fn is_name(&self) -> bool {
        self.text.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_')
    }

    /// What stands between its quotes, if it has any.
    pub fn quoted(&self) -> Option<&'t str> {
        let text = self.text.strip_prefix(QUOTES)?;
        text.get(..text.len().checked_sub(1)?)
    }
}

/// A piece of code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Code<'t> {
    /// What is printed.
    Printed(Vec<Word<'t>>),
    /// `if`, `for` and the like.
    Block(Vec<Word<'t>>),
}

const QUOTES: [char; 3] = ['"', '\'', '`'];

/// Signs of more than one letter, the longest first.
const SIGNS: [&str; 10] = ["...", "//", "**", "==", "!=", ">=", "<=", "</", "?.", "?["];

/// All code of a template, in order.
pub(super) fn read<'t>(template: &'t str, marks: &Marks) -> Vec<Code<'t>> {
    let mut codes = Vec::new();
    let mut at = 0;
    while let Some((start, kind)) = next_mark(template, at, marks) {
        let inside = start + kind[0].len();
        if *kind == marks.comment {
            at = template[inside..].find(&kind[1]).map_or(template.len(), |length| inside + length + kind[1].len());
        } else if *kind == marks.block && tag_end(template, inside, "raw", marks).is_some() {
            at = after_raw(template, inside, marks);
        } else {
            let (words, end) = words(template, inside, &kind[1]);
            codes.push(if *kind == marks.block { Code::Block(words) } else { Code::Printed(words) });
            at = end;
        }
    }
    codes
}

/// The first opening mark from a place on, and the pair to which it belongs.
fn next_mark<'m>(template: &str, from: usize, marks: &'m Marks) -> Option<(usize, &'m [String; 2])> {
    let rest = template.get(from..)?;
    let pairs = [&marks.variable, &marks.block, &marks.comment];
    pairs.into_iter().filter_map(|pair| Some((from + rest.find(&pair[0])?, pair))).min_by_key(|(start, _)| *start)
}

/// Without the hyphen that takes white space away.
fn unhyphened(text: &str) -> &str {
    text.strip_prefix('-').unwrap_or(text)
}

/// Where a block ends that holds one word and nothing else.
fn tag_end(template: &str, inside: usize, word: &str, marks: &Marks) -> Option<usize> {
    let rest = unhyphened(&template[inside..]).trim_ascii_start();
    let rest = unhyphened(rest.strip_prefix(word)?.trim_ascii_start()).strip_prefix(marks.block[1].as_str())?;
    Some(template.len() - rest.len())
}

/// Where the text after a raw block begins.
fn after_raw(template: &str, inside: usize, marks: &Marks) -> usize {
    let open = &marks.block[0];
    let opened = template[inside..].match_indices(open.as_str());
    opened
        .filter_map(|(offset, _)| tag_end(template, inside + offset + open.len(), "endraw", marks))
        .next()
        .unwrap_or(template.len())
}

/// The words up to the closing mark, and where the text after it begins.
fn words<'t>(template: &'t str, inside: usize, close: &str) -> (Vec<Word<'t>>, usize) {
    let mut words = Vec::new();
    let mut at = template.len() - unhyphened(&template[inside..]).len();
    loop {
        let rest = template[at..].trim_ascii_start();
        at = template.len() - rest.len();
        let after = rest.strip_prefix(close).or_else(|| unhyphened(rest).strip_prefix(close));
        if rest.is_empty() || after.is_some() {
            return (words, template.len() - after.map_or(0, str::len));
        }
        let text = &rest[..word_length(rest)];
        words.push(Word { text, start: at });
        at += text.len();
    }
}

/// How long the word is with which the text begins, in bytes; one character at least.
fn word_length(text: &str) -> usize {
    let first = text.chars().next().map_or(0, char::len_utf8);
    let while_all = |fits: fn(&u8) -> bool| text.bytes().take_while(fits).count();
    match text.as_bytes()[0] {
        quote @ (b'"' | b'\'' | b'`') => quoted_length(text, quote),
        b'0'..=b'9' => while_all(|byte| byte.is_ascii_digit() || *byte == b'.'),
        b'_' | b'a'..=b'z' | b'A'..=b'Z' => while_all(|byte| byte.is_ascii_alphanumeric() || *byte == b'_'),
        _ => SIGNS.iter().find(|sign| text.starts_with(**sign)).map_or(first, |sign| sign.len()),
    }
}

/// How long quoted text is with its quotes; all that is left if they are never closed.
fn quoted_length(text: &str, quote: u8) -> usize {
    let mut escaped = false;
    for (place, byte) in text.bytes().enumerate().skip(1) {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            byte if byte == quote => return place + 1,
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(template: &str) -> Vec<String> {
        read(template, &Marks::default())
            .into_iter()
            .map(|code| match code {
                Code::Printed(words) | Code::Block(words) => {
                    assert!(words.iter().all(|word| template[word.span()] == *word.text));
                    words.iter().map(|word| word.text).collect::<Vec<_>>().join(" ")
                }
            })
            .collect()
    }

    #[test]
    fn carom_reads_the_code_of_a_template_and_nothing_else() {
        let cases: [(&str, &[&str]); 11] = [
            ("{{ question.number }} part.nonsense", &["question . number"]),
            ("{%- if a-b -%}x{%endif%}{{-a-}}", &["if a - b", "endif", "a"]),
            ("{# a }} {{ b #}{{ c }}", &["c"]),
            ("{{ '}}' ~ \"\\\"}}\" }}{{ d }}", &["'}}' ~ \"\\\"}}\"", "d"]),
            ("{% raw %}{{ a }}{% endif %}{% endraw %}{{ b }}", &["b"]),
            ("{%- raw -%}{{ a }}{%- endraw -%}{{ b }}", &["b"]),
            ("{{ a?.b[1.5]|f(x=2) }}", &["a ?. b [ 1.5 ] | f ( x = 2 )"]),
            ("{% if rawness >= 2 %}", &["if rawness >= 2"]),
            ("{{ unfinished part.ask", &["unfinished part . ask"]),
            ("{{ é.θ }}", &["é . θ"]),
            ("{{ 'open", &["'open"]),
        ];
        for (template, expected) in cases {
            assert_eq!(written(template), expected, "{template}");
        }
    }
}
