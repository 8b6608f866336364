//! What the README and the pages in `docs/` show is what holds: commands, options, scenes, links.

use std::fs;
use std::path::Path;
use std::process::Command;

use carom::bank::read_question;
use carom::diagnostic::{Source, render_all};
use carom::mechanics::SceneText;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path)
}

/// The lines of all fenced blocks in a language.
fn blocks(page: &str, language: &str) -> Vec<Vec<String>> {
    let mut blocks = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if line == format!("```{language}") {
            blocks.push(lines.by_ref().take_while(|line| *line != "```").map(str::to_string).collect());
        }
    }
    blocks
}

#[test]
fn carom_shows_a_stranger_two_commands_on_the_first_screen() {
    let page = read("README.md");
    let first = &blocks(&page, "console")[0];
    let [sheet, test] = &first[..] else { panic!("the first block has two commands, not {first:?}") };
    assert!(sheet.starts_with("$ cargo run --release -- sheet "), "{sheet}");
    assert!(sheet.ends_with(" --out sheet"), ".ci/run looks for the pages in `sheet`: {sheet}");
    assert_eq!(test, "$ cargo test --release", "needs Rust and nothing else, and what the first has built");
    let above = page.lines().position(|line| line == sheet).unwrap();
    assert!(above < 12, "line {above} is not on the first screen");
    assert!(page.lines().take(25).any(|line| line.starts_with("![")), "the first screen has a picture of a sheet");
}

#[test]
fn carom_checks_the_very_commands_that_the_readme_shows() {
    let (page, script) = (read("README.md"), read(".ci/run"));
    for start in ["cargo run --release -- sheet ", "cargo test"] {
        assert!(script.contains(&format!("promised '{start}'")), ".ci/run does not take `{start}` from the README");
        let shown = page.lines().filter(|line| line.strip_prefix("$ ").is_some_and(|line| line.starts_with(start)));
        assert_eq!(shown.count(), 1, "the README shows `{start}` once, so that it is clear which is meant");
    }
}

#[test]
fn carom_reads_the_scenes_that_it_shows() {
    let shown = blocks(&read("README.md"), "json");
    assert_eq!(shown.len(), 1);
    assert_eq!(shown[0].join("\n").trim(), read("examples/scene.json").trim(), "examples/scene.json is the README's");
    let mut scenes = vec![shown[0].join("\n"), read("examples/impossible.json")];
    scenes.extend(blocks(&read("docs/exchange-formats.md"), "json").into_iter().map(|block| block.join("\n")));
    for scene in scenes.iter().filter(|scene| scene.contains("\"before\"") && !scene.contains("\"parts\"")) {
        let read: Result<SceneText, _> = serde_json::from_str(scene);
        assert!(read.is_ok(), "{:?} in {scene}", read.err());
    }
}

#[test]
fn carom_finds_no_fault_in_the_question_that_it_shows() {
    let shown = blocks(&read("docs/extending.md"), "toml");
    assert_eq!(shown.len(), 1);
    let text = format!("{}\n", shown[0].join("\n"));
    let question = read_question("rest/speed-of-b", &Source::new("docs/extending.md", text.as_str()));
    let question = question.unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    assert_eq!(question.marks(), 6);
}

/// The pages that a person reads first.
const PAGES: [&str; 13] = [
    "README.md",
    "docs/architecture.md",
    "docs/design.md",
    "docs/exchange-formats.md",
    "docs/extending.md",
    "docs/guides/author.md",
    "docs/guides/marker.md",
    "docs/guides/programmer.md",
    "docs/guides/teacher.md",
    "docs/marking-in-bulk.md",
    "docs/marking.md",
    "question_bank/README.md",
    "templates/README.md",
];

/// A command of carom as a page shows it, with its options: `sheet` with `--count` and `--seed`.
fn command(words: &str) -> Option<(String, Vec<String>)> {
    let words = words.strip_prefix("$ ").unwrap_or(words);
    let rest = words.strip_prefix("carom ").or_else(|| words.strip_prefix("cargo run --release -- "))?;
    let mut words = rest.split_whitespace();
    let name = words.next().filter(|name| name.starts_with(|letter: char| letter.is_ascii_lowercase()))?;
    let options = words.filter(|word| word.starts_with("--"));
    Some((name.to_string(), options.map(|word| word.split('=').next().unwrap_or(word).to_string()).collect()))
}

#[test]
fn carom_has_the_commands_and_options_that_its_pages_show() {
    let mut shown = 0;
    for page in PAGES {
        let text = read(page);
        let in_blocks = blocks(&text, "console").concat();
        let in_words = text.split('`').skip(1).step_by(2).map(str::to_string);
        for (name, options) in in_blocks.into_iter().chain(in_words).filter_map(|words| command(&words)) {
            let help = Command::new(env!("CARGO_BIN_EXE_carom")).args([&name, "--help"]).output().unwrap();
            let said = String::from_utf8_lossy(&help.stdout);
            assert!(
                help.status.success() && !said.is_empty(),
                "{page} shows `carom {name}`, which carom does not know"
            );
            for option in options {
                let known = said.split_whitespace().any(|word| word.trim_matches([',', '[', ']']) == option);
                assert!(known, "{page} shows `carom {name} {option}`; its help does not:\n{said}");
            }
            shown += 1;
        }
    }
    assert!(shown > 8, "only {shown} commands were found in the pages");
}

#[test]
fn carom_has_the_files_that_its_pages_link_to() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for page in PAGES {
        let folder = root.join(page).parent().unwrap().to_path_buf();
        for link in read(page).split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let target = link.split('#').next().unwrap_or(link);
            let outside = link.starts_with("https://") || target.is_empty();
            assert!(outside || folder.join(target).exists(), "{page} links to `{link}`, which is not there");
        }
    }
}

#[test]
fn a_command_is_seen_with_its_options() {
    let sheet = ("sheet".to_string(), vec!["--count".to_string(), "--out".to_string()]);
    assert_eq!(command("$ cargo run --release -- sheet --count 6 --out sheet"), Some(sheet.clone()));
    assert_eq!(command("carom sheet --count=6 --out sheet"), Some(sheet));
    assert_eq!(command("cargo test"), None);
    assert_eq!(command("carom "), None);
}

#[test]
fn a_block_ends_where_its_fence_ends() {
    let page = "```json\n1\n2\n```\nwords\n```console\n$ a\n```\n```json\n3\n```\n";
    assert_eq!(blocks(page, "json"), [vec!["1", "2"], vec!["3"]]);
    assert_eq!(blocks(page, "console"), [vec!["$ a"]]);
}
