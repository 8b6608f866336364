//! The names that templates may use: one table, to which the page, the check and `templates/README.md` are held.

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// Words, a formula, a number: printed, with no names of its own.
    Plain,
    /// A list of such.
    Plains,
    /// A thing with names of its own.
    Thing(&'static str),
    /// A list of things.
    Things(&'static str),
    /// What only printing will tell.
    Anything,
}

impl Kind {
    /// What a list is a list of.
    pub fn element(self) -> Kind {
        match self {
            Kind::Things(thing) => Kind::Thing(thing),
            Kind::Plain | Kind::Plains => Kind::Plain,
            Kind::Thing(_) | Kind::Anything => Kind::Anything,
        }
    }

    /// The list of what this is.
    pub fn listed(self) -> Kind {
        match self {
            Kind::Thing(thing) => Kind::Things(thing),
            Kind::Plain => Kind::Plains,
            Kind::Plains | Kind::Things(_) | Kind::Anything => Kind::Anything,
        }
    }
}

/// What a page has, under no name, and what each thing has.
pub(super) const NAMES: [(&str, &[(&str, Kind)]); 26] = [
    (
        "",
        &[
            ("title", Kind::Plain),
            ("school", Kind::Plain),
            ("date", Kind::Plain),
            ("student", Kind::Plain),
            ("code", Kind::Plain),
            ("seed", Kind::Plain),
            ("marks", Kind::Plain),
            ("large_print", Kind::Plain),
            ("answer_space", Kind::Plain),
            ("questions", Kind::Things("question")),
        ],
    ),
    (
        "class",
        &[
            ("title", Kind::Plain),
            ("school", Kind::Plain),
            ("date", Kind::Plain),
            ("large_print", Kind::Plain),
            ("answer_space", Kind::Plain),
            ("papers", Kind::Things("paper")),
        ],
    ),
    (
        "paper",
        &[
            ("place", Kind::Plain),
            ("student", Kind::Plain),
            ("code", Kind::Plain),
            ("seed", Kind::Plain),
            ("marks", Kind::Plain),
            ("questions", Kind::Things("question")),
        ],
    ),
    (
        "question",
        &[
            ("number", Kind::Plain),
            ("id", Kind::Plain),
            ("mirrors", Kind::Plain),
            ("stem", Kind::Plains),
            ("figure", Kind::Plain),
            ("diagrams", Kind::Things("diagram")),
            ("solution_diagrams", Kind::Things("diagram")),
            ("parts", Kind::Things("part")),
            ("marks", Kind::Plain),
        ],
    ),
    ("diagram", &[("title", Kind::Plain), ("picture", Kind::Plain), ("words", Kind::Plain)]),
    (
        "part",
        &[
            ("label", Kind::Plain),
            ("ask", Kind::Plain),
            ("answers", Kind::Things("answer")),
            ("solution_diagrams", Kind::Things("diagram")),
            ("working", Kind::Things("line")),
            ("scheme", Kind::Things("mark")),
            ("marks", Kind::Plain),
        ],
    ),
    (
        "answer",
        &[
            ("name", Kind::Plain),
            ("exact", Kind::Plain),
            ("rounded", Kind::Plain),
            ("asked", Kind::Plain),
            ("phrase", Kind::Plain),
        ],
    ),
    ("line", &[("words", Kind::Plain), ("equations", Kind::Things("equation")), ("label", Kind::Plain)]),
    ("equation", &[("whole", Kind::Plain), ("left", Kind::Plain), ("relation", Kind::Plain), ("right", Kind::Plain)]),
    (
        "mark",
        &[
            ("id", Kind::Plain),
            ("code", Kind::Plain),
            ("earned", Kind::Plain),
            ("equations", Kind::Plains),
            ("note", Kind::Plain),
            ("depends", Kind::Plains),
        ],
    ),
    (
        "feedback",
        &[
            ("student", Kind::Plain),
            ("code", Kind::Plain),
            ("marks", Kind::Plain),
            ("available", Kind::Plain),
            ("scripts", Kind::Things("script")),
        ],
    ),
    (
        "script",
        &[
            ("number", Kind::Plain),
            ("id", Kind::Plain),
            ("marks", Kind::Plain),
            ("available", Kind::Plain),
            ("replies", Kind::Things("reply")),
        ],
    ),
    (
        "reply",
        &[
            ("label", Kind::Plain),
            ("verdict", Kind::Plain),
            ("marks", Kind::Plain),
            ("available", Kind::Plain),
            ("responses", Kind::Things("response")),
            ("lines", Kind::Things("written")),
            ("awards", Kind::Things("award")),
            ("followed", Kind::Things("line")),
        ],
    ),
    (
        "response",
        &[
            ("name", Kind::Plain),
            ("typed", Kind::Plain),
            ("reading", Kind::Plain),
            ("verdict", Kind::Plain),
            ("comment", Kind::Plain),
            ("causes", Kind::Things("cause")),
        ],
    ),
    ("cause", &[("sentence", Kind::Plain), ("probable", Kind::Plains)]),
    ("written", &[("number", Kind::Plain), ("typed", Kind::Plain), ("reading", Kind::Plain), ("role", Kind::Plain)]),
    (
        "award",
        &[
            ("code", Kind::Plain),
            ("given", Kind::Plain),
            ("person", Kind::Plain),
            ("reason", Kind::Plain),
            ("place", Kind::Plain),
            ("reading", Kind::Plain),
            ("earned", Kind::Plain),
            ("equation", Kind::Plain),
        ],
    ),
    (
        "report",
        &[
            ("students", Kind::Plain),
            ("has_names", Kind::Plain),
            ("mean", Kind::Plain),
            ("available", Kind::Plain),
            ("per_cent", Kind::Plain),
            ("least", Kind::Plain),
            ("most", Kind::Plain),
            ("wide", Kind::Plain),
            ("totals", Kind::Plain),
            ("bands", Kind::Things("band")),
            ("facilities", Kind::Plain),
            ("questions", Kind::Things("item")),
            ("rows", Kind::Things("row")),
            ("more_rows", Kind::Plain),
            ("slips", Kind::Things("mistake")),
            ("accuracy", Kind::Things("mistake")),
            ("findings", Kind::Things("finding")),
            ("looks", Kind::Things("look")),
            ("more_looks", Kind::Plain),
            ("not_marked", Kind::Plain),
        ],
    ),
    ("band", &[("range", Kind::Plain), ("students", Kind::Plain)]),
    (
        "item",
        &[
            ("label", Kind::Plain),
            ("id", Kind::Plain),
            ("mirrors", Kind::Plain),
            ("scripts", Kind::Plain),
            ("mean", Kind::Plain),
            ("available", Kind::Plain),
            ("facility", Kind::Plain),
            ("scheme", Kind::Things("tally")),
        ],
    ),
    (
        "tally",
        &[
            ("part", Kind::Plain),
            ("id", Kind::Plain),
            ("code", Kind::Plain),
            ("won", Kind::Plain),
            ("facility", Kind::Plain),
            ("bar", Kind::Plain),
            ("discrimination", Kind::Plain),
            ("why_not", Kind::Plain),
        ],
    ),
    (
        "row",
        &[
            ("student", Kind::Plain),
            ("marks", Kind::Plain),
            ("available", Kind::Plain),
            ("per_cent", Kind::Plain),
            ("cells", Kind::Things("cell")),
        ],
    ),
    ("cell", &[("label", Kind::Plain), ("marks", Kind::Plain), ("available", Kind::Plain), ("handed_in", Kind::Plain)]),
    (
        "mistake",
        &[
            ("tag", Kind::Plain),
            ("did", Kind::Plain),
            ("count", Kind::Plain),
            ("times", Kind::Plain),
            ("questions", Kind::Plain),
            ("students", Kind::Plains),
            ("more", Kind::Plain),
        ],
    ),
    ("finding", &[("question", Kind::Plain), ("sentence", Kind::Plain)]),
    (
        "look",
        &[
            ("student", Kind::Plain),
            ("question", Kind::Plain),
            ("part", Kind::Plain),
            ("place", Kind::Plain),
            ("typed", Kind::Plain),
            ("reason", Kind::Plain),
        ],
    ),
];

/// The names of a thing; of the page, if it is called nothing.
pub(super) fn names_of(thing: &str) -> &'static [(&'static str, Kind)] {
    NAMES.iter().find(|(known, _)| *known == thing).map_or(&[], |(_, names)| names)
}

#[cfg(test)]
pub(super) mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use super::*;

    /// All names below a thing, by the things that have them.
    pub fn below(thing: &str) -> BTreeMap<String, BTreeSet<String>> {
        let mut all = BTreeMap::new();
        let mut open = vec![thing];
        while let Some(thing) = open.pop() {
            let names = names_of(thing);
            all.insert(thing.to_owned(), names.iter().map(|(name, _)| (*name).to_owned()).collect());
            open.extend(names.iter().filter_map(|(_, kind)| match kind {
                Kind::Things(of) if !all.contains_key(*of) => Some(of),
                _ => None,
            }));
        }
        all
    }

    /// The names of a thing on a page and, through its lists, of the first of each thing below it.
    pub fn gather(thing: &str, value: &serde_json::Value, found: &mut BTreeMap<String, BTreeSet<String>>) {
        let Some(names) = value.as_object() else { return };
        found.insert(thing.to_owned(), names.keys().cloned().collect());
        for (name, kind) in names_of(thing) {
            if let (Kind::Things(of), Some(first)) = (kind, value[name].get(0)) {
                gather(of, first, found);
            }
        }
    }

    #[test]
    fn carom_knows_that_every_list_is_of_things_in_the_table() {
        for (thing, names) in NAMES {
            for (name, kind) in names {
                if let Kind::Things(of) = kind {
                    assert!(!names_of(of).is_empty(), "{thing}.{name} is a list of {of}");
                }
            }
        }
    }

    /// What the second column of the table in the page says of a name.
    fn kind_in_words(kind: Kind) -> String {
        match kind {
            Kind::Things(thing) => format!("list of `{thing}`"),
            Kind::Plains => "list of".to_owned(),
            _ => String::new(),
        }
    }

    #[test]
    fn carom_knows_that_the_readme_of_templates_lists_every_name() {
        let readme = include_str!("../../templates/README.md");
        let rows = readme.lines().filter(|line| line.starts_with("| `"));
        let mut listed: Vec<(String, &str)> = Vec::new();
        for row in rows {
            let cells: Vec<&str> = row.trim_start_matches("| ").split(" | ").collect();
            listed.extend(cells[0].split(", ").map(|name| (name.trim_matches('`').to_owned(), cells[1])));
        }
        let path = |thing: &str, name: &str| format!("{thing}.{name}").trim_start_matches('.').to_owned();
        let mut names: Vec<(String, Kind)> = NAMES
            .iter()
            .flat_map(|(thing, names)| names.iter().map(move |(name, kind)| (path(thing, name), *kind)))
            .collect();
        listed.sort();
        names.sort();
        let paths = |pairs: &[(String, &str)]| pairs.iter().map(|(path, _)| path.clone()).collect::<Vec<_>>();
        assert_eq!(paths(&listed), names.iter().map(|(path, _)| path.clone()).collect::<Vec<_>>());
        for ((path, said), (_, kind)) in listed.iter().zip(names) {
            let lists = said.starts_with("list of");
            assert_eq!(lists, kind_in_words(kind).starts_with("list of"), "{path}: {said}");
            assert!(said.starts_with(&kind_in_words(kind)), "{path}: {said}");
        }
    }
}
