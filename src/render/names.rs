//! The names that templates may use, and the refusal of any other.
//!
//! Rendering refuses a name that it comes to; but in `if question.mirors` an unknown name is only false, and
//! a branch that this paper does not take may be taken by the next. So templates are also read for names.

use super::RenderFault;
use super::manifest::Marks;

/// What a page has, and what each thing in its lists has, by the name that shipped templates give to the thing.
pub(super) const NAMES: [(&str, &[&str]); 8] = [
    ("", &["title", "school", "date", "code", "seed", "marks", "large_print", "answer_space", "questions"]),
    ("question", &["number", "id", "mirrors", "stem", "figure", "diagrams", "solution_diagrams", "parts", "marks"]),
    ("diagram", &["title", "picture", "words"]),
    ("part", &["label", "ask", "answers", "working", "scheme", "marks"]),
    ("answer", &["name", "exact", "rounded", "phrase"]),
    ("line", &["words", "equations", "label"]),
    ("equation", &["whole", "left", "relation", "right"]),
    ("mark", &["id", "code", "earned", "equation", "note", "depends"]),
];

/// Is it a name that stands by itself, as `title` does?
pub(super) fn is_of_page(name: &str) -> bool {
    NAMES[0].1.contains(&name)
}

/// The fault of a template that uses a name which `thing` has not; nothing by name is the page itself.
pub(super) fn unknown(file: &str, thing: &str, name: &str) -> RenderFault {
    let available = NAMES.iter().find(|(known, _)| *known == thing).map_or(&[][..], |(_, names)| names);
    RenderFault::UnknownName {
        file: file.to_owned(),
        of: if thing.is_empty() { "page".to_owned() } else { thing.to_owned() },
        name: name.to_owned(),
        available: available.iter().map(|name| (*name).to_owned()).collect(),
    }
}

/// The first `question.nummer` of a template: a thing that we know, with a name that it has not.
pub(super) fn check(file: &str, template: &str, marks: &Marks) -> Result<(), RenderFault> {
    for code in codes(template, marks) {
        for path in paths(code) {
            let mut names = path.split('.');
            let (Some(thing), Some(name)) = (names.next(), names.next()) else { continue };
            match NAMES.iter().find(|(known, _)| !known.is_empty() && *known == thing) {
                Some((_, known)) if !known.contains(&name) => return Err(unknown(file, thing, name)),
                _ => {}
            }
        }
    }
    Ok(())
}

/// What stands between the marks of variables and of blocks.
fn codes<'a>(template: &'a str, marks: &'a Marks) -> impl Iterator<Item = &'a str> {
    let mut rest = template;
    std::iter::from_fn(move || {
        loop {
            let [open, close] = [&marks.variable, &marks.block, &marks.comment]
                .into_iter()
                .filter(|[open, _]| rest.contains(open.as_str()))
                .min_by_key(|[open, _]| rest.find(open.as_str()))?;
            let (_, after) = rest.split_once(open.as_str())?;
            let (code, after) = after.split_once(close.as_str())?;
            rest = after;
            if *open != marks.comment[0] {
                return Some(code);
            }
        }
    })
}

/// Dotted names of a piece of code, leaving out what stands in quotes.
fn paths(code: &str) -> impl Iterator<Item = &str> {
    let outside_quotes = code.split(['"', '\'', '`']).step_by(2);
    outside_quotes.flat_map(|part| part.split(|letter: char| !(letter.is_alphanumeric() || "._".contains(letter))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_a_misspelt_name_wherever_it_stands() {
        let cases = [
            ("{{ question.number }} part.nonsense", None),
            ("{% if question.mirors %}x{% endif %}", Some("mirors")),
            ("{%- for mark in part.scheme -%}{{mark.kode}}{% endfor %}", Some("kode")),
            ("{# question.mirors #}{% include 'part.tex' %}", None),
            ("{{ loop.first }}{{ q.anything }}{{ part.ask | trim }}", None),
            ("{% if not(part.askk) %}", Some("askk")),
            ("{{ unfinished part.askk", None),
        ];
        for (template, expected) in cases {
            let found = match check("t", template, &Marks::default()) {
                Err(RenderFault::UnknownName { name, .. }) => Some(name),
                _ => None,
            };
            assert_eq!(found.as_deref(), expected, "{template}");
        }
    }

    #[test]
    fn carom_knows_that_the_readme_of_templates_lists_every_name() {
        let readme = include_str!("../../templates/README.md");
        let mut listed: Vec<&str> = readme
            .lines()
            .filter_map(|line| line.strip_prefix("| `")?.split(" | ").next())
            .flat_map(|cell| cell.split(", ").map(|name| name.trim_matches('`')))
            .collect();
        let mut names: Vec<String> = NAMES
            .iter()
            .flat_map(|(thing, names)| names.iter().map(move |name| format!("{thing}.{name}")))
            .map(|path| path.trim_start_matches('.').to_owned())
            .collect();
        listed.sort_unstable();
        names.sort_unstable();
        assert_eq!(listed, names);
    }
}
