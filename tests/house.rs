//! The house rules, kept by a test: rooms import only rooms above them, files stay readable, nothing is left unfinished.
//!
//! Each rule is a plain function from a file to complaints, so that it can be shown that it complains.

use std::fs;
use std::path::Path;

/// The rooms from the top down. A room may import the rooms above it, and `docs/architecture.md` says what each is for.
const ROOMS: [&str; 18] = [
    "diagnostic",
    "table",
    "number",
    "unit",
    "expr",
    "mechanics",
    "method",
    "solve",
    "answer",
    "bank",
    "generate",
    "diagram",
    "paper",
    "mark",
    "examine",
    "render",
    "study",
    "cli",
];

/// The most lines that a file may have before its tests.
const CEILING: usize = 400;

/// Files that are over it and wait to be divided. This list may only grow shorter.
const TALL: [&str; 0] = [];

/// The most lines that even those may have.
const LIMIT: usize = 550;

/// What marks unfinished work. Written in two halves, so that this file does not complain of itself.
const UNFINISHED: [&str; 4] =
    [concat!("todo", "!("), concat!("unimplemented", "!("), concat!("TO", "DO"), concat!("FIX", "ME")];

/// A test that waits for `.ci/run` says what it needs or how long it takes.
const IGNORED: (&str, [&str; 2]) = (concat!("#[ign", "ore"), [r#" = "needs "#, r#" = "takes "#]);

/// Names that say nothing about what a file holds.
const NAMELESS: [&str; 6] = ["util", "utils", "helper", "helpers", "common", "misc"];

/// Folders to which people add files, and so have a page that says how.
const OPEN_FOLDERS: [&str; 2] = ["question_bank", "templates"];

#[test]
fn carom_keeps_its_house() {
    let mut complaints = Vec::new();
    let files = tree(&["src", "tests", "examples", "benches", "question_bank", "templates", "docs"]);
    assert!(files.len() > 30, "the tree was not found: {files:?}");
    for path in &files {
        if !path.ends_with(".rs") {
            continue;
        }
        let text = fs::read_to_string(root().join(path)).expect(path);
        complaints.extend(first_line(path, &text));
        complaints.extend(unfinished(path, &text));
        if path.starts_with("src/") {
            complaints.extend(imports(path, &text));
            complaints.extend(height(path, &text, &TALL));
            complaints.extend(nameless(path));
            complaints.extend(laws_by_name(path, &text));
        }
    }
    complaints.extend(open_folders(&files));
    let gone = TALL.iter().filter(|path| !files.iter().any(|file| file == *path));
    complaints.extend(gone.map(|path| format!("{path}: no such file; take it off the list of tall files")));
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

#[test]
fn carom_documents_every_room_in_the_order_of_import() {
    let page = fs::read_to_string(root().join("docs/architecture.md")).unwrap();
    let rows: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next()).collect();
    let rooms: Vec<&str> = rows.iter().map(|row| row.trim_end_matches(".rs").trim_end_matches('/')).collect();
    assert_eq!(rooms, ROOMS, "docs/architecture.md has a table with a row for each room, in this order");
}

#[test]
fn carom_says_which_files_name_a_setting() {
    let page = fs::read_to_string(root().join("docs/extending.md")).unwrap();
    let section = page.split("\n## ").find(|section| section.starts_with("A setting")).unwrap();
    // A law stands there by its name, a folder of pictures by its path, any other file by its own.
    let is_said = |path: &str| {
        let law = path.strip_prefix("src/mechanics/law/").map(|file| file.trim_end_matches(".rs"));
        let file = path.trim_start_matches("src/mechanics/").rsplit('/').next().unwrap_or(path);
        let file = if file == "mod.rs" { path.trim_start_matches("src/mechanics/") } else { file };
        law.is_some_and(|law| section.contains(law))
            || (path.starts_with("src/diagram/") && section.contains("src/diagram/"))
            || section.contains(&format!("{file}`"))
    };
    let names = |text: &str| {
        let code = without_comments(text);
        let used = ["Oblique", "Direct", "Wall", "Impulse"].map(|setting| format!("Setting::{setting}"));
        used.iter().any(|setting| code.contains(setting.as_str())) || code.contains("Setting::{")
    };
    let mut found = 0;
    for path in tree(&["src"]) {
        if path.ends_with(".rs") && names(&fs::read_to_string(root().join(&path)).unwrap()) {
            assert!(is_said(&path), "{path} names a setting, and docs/extending.md does not say so");
            found += 1;
        }
    }
    assert!(found > 10, "{found}");
}

#[test]
fn carom_says_what_is_in_each_folder_of_its_bank() {
    let page = fs::read_to_string(root().join("question_bank/README.md")).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("/` | ")).map(|(folder, _)| folder);
    let mut rows: Vec<String> = rows.map(str::to_owned).collect();
    let folders = fs::read_dir(root().join("question_bank")).unwrap().map(|entry| entry.unwrap());
    let folders = folders.filter(|entry| entry.path().is_dir()).map(|entry| entry.file_name().into_string().unwrap());
    let mut folders: Vec<String> = folders.collect();
    rows.sort();
    folders.sort();
    assert_eq!(rows, folders, "question_bank/README.md has a row for each folder");
    for key in ["unknowns", "conditions", "maximise", "kind", "phrase", "positions", "radii", "impact_parameter"] {
        assert!(page.contains(&format!("`{key}")), "question_bank/README.md does not say what `{key}` is");
    }
    assert!(page.contains("`carom schema question`"));
}

#[test]
fn carom_says_what_each_dependency_earns_its_place_with() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let under = |heading: &'static str| {
        let listed = manifest.lines().skip_while(move |line| *line != heading).skip(1);
        listed.take_while(|line| !line.is_empty()).filter_map(|line| line.split(" = ").next())
    };
    let crates: Vec<&str> = under("[dependencies]").chain(under("[dev-dependencies]")).collect();
    assert!(crates.len() > 5 && crates.contains(&"divan"), "{crates:?}");
    let page = fs::read_to_string(root().join("docs/design.md")).unwrap();
    for name in crates {
        assert!(page.contains(&format!("\n| `{name}` | ")), "docs/design.md does not say why `{name}` is there");
    }
}

/// A room names only rooms above it, and no room that is not on the list.
fn imports(path: &str, text: &str) -> Vec<String> {
    let Some(room) = room_of(path) else { return Vec::new() };
    let Some(place) = ROOMS.iter().position(|name| *name == room) else {
        return vec![format!("{path}: `{room}` is not on the list of rooms in tests/house.rs")];
    };
    let mut complaints = Vec::new();
    for (line, name) in named_from_the_root(path, &without_comments(text)) {
        match ROOMS.iter().position(|other| *other == name) {
            Some(other) if other > place => {
                complaints.push(format!("{path}:{line}: `{room}` imports `{name}`, which comes after it"));
            }
            None if name.starts_with(char::is_lowercase) => {
                complaints.push(format!("{path}:{line}: `{name}` is not on the list of rooms in tests/house.rs"));
            }
            _ => {}
        }
    }
    complaints
}

/// The first line of a file says what it is.
fn first_line(path: &str, text: &str) -> Vec<String> {
    let said = text.lines().next().is_some_and(|line| line.starts_with("//! ") && line.len() > 12);
    if said {
        Vec::new()
    } else {
        vec![format!("{path}:1: the first line begins with `//!` and says what the file is")]
    }
}

/// A file stays below the ceiling; one on the list of tall files below the limit, until it need not be on the list.
fn height(path: &str, text: &str, tall: &[&str]) -> Vec<String> {
    if path.ends_with("tests.rs") {
        return Vec::new();
    }
    let lines = lines_before_tests(text);
    let advice = match tall.contains(&path) {
        true if lines <= CEILING => "take it off the list of tall files",
        true if lines > LIMIT => "it was to shrink, not to grow",
        false if lines > CEILING => "look for the second idea in it",
        _ => return Vec::new(),
    };
    vec![format!("{path}: {lines} lines before its tests; {advice}")]
}

/// The lines of a file before the tests that it holds. Tests in a file of their own are named at the head of another.
fn lines_before_tests(text: &str) -> usize {
    let lines: Vec<&str> = text.lines().collect();
    let begins =
        |pair: &[&str]| pair[0].trim() == "#[cfg(test)]" && pair[1].starts_with("mod ") && pair[1].ends_with('{');
    lines.windows(2).position(begins).unwrap_or(lines.len())
}

/// Nothing is left unfinished or passed over.
fn unfinished(path: &str, text: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    for (line, words) in (1..).zip(text.lines()) {
        for mark in UNFINISHED.iter().filter(|mark| words.contains(**mark)) {
            complaints.push(format!("{path}:{line}: `{mark}`"));
        }
        let (ignored, reasons) = IGNORED;
        if words.split_once(ignored).is_some_and(|(_, why)| !reasons.iter().any(|reason| why.starts_with(reason))) {
            complaints.push(format!("{path}:{line}: passed over, and not said why"));
        }
    }
    complaints
}

/// A file's name says what it holds.
fn nameless(path: &str) -> Vec<String> {
    let mut names = path.split('/').map(|name| name.trim_end_matches(".rs"));
    match names.find(|name| NAMELESS.contains(name)) {
        Some(name) => vec![format!("{path}: `{name}` says nothing about what is in it")],
        None => Vec::new(),
    }
}

/// Only the list of laws and a law's own file name a law, so that to add one takes a file and a line.
fn laws_by_name(path: &str, text: &str) -> Vec<String> {
    if path.starts_with("src/mechanics/law/") || path.ends_with("tests.rs") {
        return Vec::new();
    }
    let code = without_comments(text);
    let code = code.split("#[cfg(test)]").next().unwrap_or_default();
    let named = |line: &str| line.split("Law::").skip(1).any(is_variant);
    let lines = (1..).zip(code.lines()).filter(|(_, line)| named(line));
    lines
        .map(|(line, _)| format!("{path}:{line}: names a law; what it needs of the law belongs in the law's file"))
        .collect()
}

/// Does it begin with a name in capitals and small letters, as variants have?
fn is_variant(code: &str) -> bool {
    let mut letters = code.chars();
    letters.next().is_some_and(char::is_uppercase) && letters.next().is_some_and(char::is_lowercase)
}

/// A folder to which people add has a page that says how.
fn open_folders(files: &[String]) -> Vec<String> {
    let within = |folder: &str| files.iter().any(|file| file.starts_with(&format!("{folder}/")));
    let page = |folder: &str| files.contains(&format!("{folder}/README.md"));
    let bare = OPEN_FOLDERS.iter().filter(|folder| within(folder) && !page(folder));
    bare.map(|folder| format!("{folder}/: has no README.md")).collect()
}

/// The room a file of `src/` belongs to; none for the two roots.
fn room_of(path: &str) -> Option<&str> {
    let first = path.strip_prefix("src/")?.split('/').next()?.trim_end_matches(".rs");
    (first != "lib" && first != "main").then_some(first)
}

/// The names that a file takes from the root of the crate, each with its line: by `crate::name`, by
/// `crate::{name, …}`, by the crate's own name, or by enough `super::`.
fn named_from_the_root(path: &str, code: &str) -> Vec<(usize, String)> {
    let mut names = Vec::new();
    let mut at = 0;
    while let Some(start) = next_path(&code[at..]).map(|start| at + start) {
        let depth = depth(path) + open_modules(&code[..start]);
        let mut rest = &code[start..];
        let mut climbed = 0;
        if let Some(after) = rest.strip_prefix("crate::").or_else(|| rest.strip_prefix("carom::")) {
            rest = after;
            climbed = depth;
        }
        while let Some(after) = rest.strip_prefix("super::") {
            rest = after;
            climbed += 1;
        }
        at = code.len() - rest.len();
        if climbed == depth {
            let line = code[..start].matches('\n').count() + 1;
            names.extend(heads(rest).into_iter().map(|name| (line, name)));
        }
    }
    names
}

/// How many `super::` lead from a file to the root of the crate.
fn depth(path: &str) -> usize {
    let inner = path.trim_start_matches("src/").trim_end_matches(".rs");
    inner.split('/').filter(|name| *name != "mod").count()
}

/// How many modules in braces are still open at the end of the code.
fn open_modules(code: &str) -> usize {
    let mut open = Vec::new();
    for (at, letter) in code.char_indices() {
        match letter {
            '{' => {
                let line = code[..at].rsplit('\n').next().unwrap_or_default();
                open.push(line.split_whitespace().rev().nth(1) == Some("mod"));
            }
            '}' => drop(open.pop()),
            _ => {}
        }
    }
    open.into_iter().filter(|is_module| *is_module).count()
}

/// Where the next path from above begins.
fn next_path(code: &str) -> Option<usize> {
    let starts = |word: &str| {
        let mut found = code.match_indices(word).map(|(at, _)| at);
        found.find(|at| {
            !code[..*at].ends_with(|before: char| before.is_alphanumeric() || before == '_' || before == ':')
        })
    };
    ["crate::", "carom::", "super::"].iter().filter_map(|word| starts(word)).min()
}

/// The first names of a path or of each path in braces: `a` of `a::b`, `a` and `c` of `{a::{b, d}, c}`.
fn heads(code: &str) -> Vec<String> {
    let word = |text: &str| -> String {
        text.trim_start().chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect()
    };
    let Some(group) = code.strip_prefix('{') else { return vec![word(code)] };
    let mut heads = vec![word(group)];
    let mut open = 1;
    for (at, letter) in group.char_indices() {
        match letter {
            '{' => open += 1,
            '}' if open == 1 => break,
            '}' => open -= 1,
            ',' if open == 1 => heads.push(word(&group[at + 1..])),
            _ => {}
        }
    }
    heads.retain(|name| !name.is_empty());
    heads
}

/// The code with comments and the contents of strings left out, line by line.
fn without_comments(text: &str) -> String {
    let mut code = String::new();
    let (mut in_string, mut in_comment) = (false, false);
    for line in text.lines() {
        let mut letters = line.chars().peekable();
        while let Some(letter) = letters.next() {
            let next = letters.peek().copied();
            match letter {
                '*' if in_comment && next == Some('/') => in_comment = letters.next().is_none(),
                _ if in_comment => {}
                '\\' if in_string => drop(letters.next()),
                '"' => in_string = !in_string,
                _ if in_string => {}
                '\'' if next == Some('"') => drop(letters.next()),
                '/' if next == Some('/') => break,
                '/' if next == Some('*') => in_comment = true,
                _ => code.push(letter),
            }
        }
        code.push('\n');
    }
    code
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every file under the folders, by its path from the root, in order.
fn tree(folders: &[&str]) -> Vec<String> {
    let mut files = Vec::new();
    let mut open: Vec<String> = folders.iter().map(|folder| folder.to_string()).collect();
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(root().join(&folder)).into_iter().flatten().flatten() {
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() { open.push(path) } else { files.push(path) }
        }
    }
    files.sort();
    files
}

/// No complaint.
const NONE: [&str; 0] = [];

#[test]
fn the_checker_sees_an_import_from_below() {
    let below = [
        ("src/number/value.rs", "use crate::expr::Expr;"),
        ("src/number/value.rs", "use crate::{number::Fraction, expr::{Expr, Text}};"),
        ("src/number/value.rs", "fn f() -> crate::solve::Solution {}"),
        ("src/number/value.rs", "use super::super::expr::Expr;"),
        ("src/number/value.rs", "/* \" */ use carom::cli;"),
        ("src/number/mod.rs", "pub use super::{unit::Unit};"),
        ("src/unit.rs", "mod tests {\n    use crate::mechanics::Scene;\n}"),
        ("src/render/latex/print.rs", "let page = super::super::super::cli::page();"),
        ("src/bank/read.rs", "use crate::{\n    answer::Kind,\n    generate::Shuffle,\n};"),
        ("src/bank/read.rs", "use crate::toolbox::Hammer;"),
        ("src/unit.rs", "mod tests {\n    use super::super::expr::Expr;\n}"),
        ("src/toolbox/hammer.rs", "fn nothing() {}"),
    ];
    for (path, code) in below {
        assert_eq!(imports(path, code).len(), 1, "{path}: {code} gives {:?}", imports(path, code));
    }
    assert_eq!(
        imports("src/unit.rs", "\nuse crate::mechanics::Scene;"),
        ["src/unit.rs:2: `unit` imports `mechanics`, which comes after it"]
    );
}

#[test]
fn the_checker_lets_pass_what_is_above() {
    let above = [
        ("src/expr/tree.rs", "use crate::number::Fraction;\nuse crate::unit::Unit;\nuse crate::expr::Text;"),
        ("src/expr/tree.rs", "/// see [`crate::solve`]\n// use crate::cli;\nlet words = \"crate::cli\";"),
        ("src/expr/tree.rs", "let quote = '\"'; use crate::number::Value; let other = '\"';"),
        ("src/expr/print/mod.rs", "use super::solve::here;"),
        ("src/unit.rs", "mod tests {\n    use super::*;\n    fn f() { super::expr::kilogram() }\n}"),
        ("src/number/value.rs", "use super::decide; use crate::number::{self, Value};"),
        ("src/cli/solve.rs", "use crate::{bank, solve::solve, diagnostic::Diagnostic};"),
        ("src/lib.rs", "pub use crate::cli::run;"),
        ("src/main.rs", "use carom::cli;"),
    ];
    for (path, code) in above {
        assert_eq!(imports(path, code), NONE, "{path}: {code}");
    }
}

#[test]
fn the_checker_sees_a_file_that_has_grown_too_tall() {
    let long = "// a line\n".repeat(CEILING + 1);
    let tested =
        format!("{}#[cfg(test)]\nmod tests {{\n{}}}\n", "// a line\n".repeat(CEILING), "// a test\n".repeat(300));
    let apart = format!("#[cfg(test)]\nmod tests;\n{long}");
    assert_eq!(height("src/a.rs", &long, &[]).len(), 1);
    assert_eq!(height("src/a.rs", &apart, &[]).len(), 1);
    assert_eq!(height("src/a.rs", &tested, &[]), NONE);
    assert_eq!(height("src/a_tests.rs", &long, &[]), NONE);
    assert_eq!(height("src/a.rs", &long, &["src/a.rs"]), NONE);
    assert!(height("src/a.rs", &"// a line\n".repeat(LIMIT + 1), &["src/a.rs"])[0].contains("shrink"));
    assert!(height("src/a.rs", &tested, &["src/a.rs"])[0].contains("off the list"));
}

#[test]
fn the_checker_sees_what_is_unfinished_or_unnamed() {
    for mark in UNFINISHED {
        assert_eq!(unfinished("src/a.rs", &format!("fn f() {{\n    // {mark}\n}}")).len(), 1, "{mark}");
    }
    for (why, complaints) in
        [("]", 1), (r#" = "fails"]"#, 1), (r#" = "needs Java"]"#, 0), (r#" = "takes a minute"]"#, 0)]
    {
        assert_eq!(unfinished("tests/a.rs", &format!("{}{why}", IGNORED.0)).len(), complaints, "{why}");
    }
    assert_eq!(unfinished("src/a.rs", "// done\n#[test]\nfn f() {}"), NONE);
    assert_eq!(first_line("src/a.rs", "use std::fs;\n").len(), 1);
    assert_eq!(first_line("src/a.rs", "//!\n//! Late.\n").len(), 1);
    assert_eq!(first_line("src/a.rs", "//! Fractions in lowest terms.\n"), NONE);
    assert_eq!(nameless("src/number/utils.rs").len(), 1);
    assert_eq!(nameless("src/common/fraction.rs").len(), 1);
    assert_eq!(nameless("src/number/fraction.rs"), NONE);
}

#[test]
fn the_checker_sees_a_law_named_away_from_home() {
    let named = "fn f(law: Law) -> bool {\n    law == Law::Momentum\n}\n";
    assert_eq!(laws_by_name("src/paper/scheme.rs", named).len(), 1);
    assert!(laws_by_name("src/paper/scheme.rs", named)[0].starts_with("src/paper/scheme.rs:2:"));
    assert_eq!(laws_by_name("src/mechanics/law/momentum.rs", named), NONE);
    assert_eq!(laws_by_name("src/paper/scheme.rs", "for law in Law::ALL {} // Law::Momentum"), NONE);
    assert_eq!(laws_by_name("src/paper/scheme.rs", &format!("#[cfg(test)]\n{named}")), NONE);
}

#[test]
fn the_checker_sees_a_folder_without_a_page() {
    let bare = ["question_bank/rest/speeds.toml".to_string(), "templates/README.md".to_string()];
    assert_eq!(open_folders(&bare), ["question_bank/: has no README.md"]);
}
