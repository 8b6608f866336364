//! What the README shows is what holds: its two commands are those that `.ci/run` runs, and its scene is a scene.

use std::fs;
use std::path::Path;

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
    assert_eq!(test, "$ cargo test", "plain, so that it needs Rust and nothing else");
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
fn a_block_ends_where_its_fence_ends() {
    let page = "```json\n1\n2\n```\nwords\n```console\n$ a\n```\n```json\n3\n```\n";
    assert_eq!(blocks(page, "json"), [vec!["1", "2"], vec!["3"]]);
    assert_eq!(blocks(page, "console"), [vec!["$ a"]]);
}
