//! Commands that are shown to people are run: the examples under each `--help`, and those of the guides in `docs/guides/`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use carom::bank::Contents;
use carom::expr::print;
use carom::generate::examine;
use carom::paper::{Sheet, SheetCode};
use serde_json::{Value as Json, json};

/// An empty folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("shown-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// The words of a command line, as a shell has them: quotes hold words together.
fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for c in line.chars() {
        match (quote, c) {
            (Some(open), _) if open == c => quote = None,
            (None, '\'' | '"') => quote = Some(c),
            (None, ' ') => words.push(String::new()),
            _ => words.last_mut().unwrap().push(c),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Runs a line of commands, each after `&&`, with `< FILE` and `> FILE`; the output of the last.
fn run(line: &str, within: &Path) -> Output {
    let mut last = None;
    for part in line.split(" && ") {
        let (part, to) = part.split_once(" > ").map_or((part, None), |(part, to)| (part, Some(to)));
        let part = part.split(" >> ").next().unwrap();
        let (part, from) = part.split_once(" < ").map_or((part, None), |(part, from)| (part, Some(from)));
        let words = words(part);
        assert_eq!(words[0], "carom", "{line}");
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command.args(&words[1..]).current_dir(within).stdin(Stdio::null());
        if let Some(from) = from {
            command.stdin(fs::File::open(within.join(from)).unwrap_or_else(|error| panic!("{line}: {error}")));
        }
        let output = command.output().unwrap();
        if let Some(to) = to.filter(|to| !to.starts_with('~')) {
            fs::write(within.join(to), &output.stdout).unwrap();
        }
        last = Some(output);
    }
    last.unwrap()
}

/// Fails unless the line runs well.
fn runs(line: &str, within: &Path, of: &str) {
    let output = run(line, within);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{of} shows `{line}`:\n{said}");
}

fn help_of(name: &str) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_carom")).args([name, "--help"]).output().unwrap();
    assert!(output.status.success(), "{name}");
    String::from_utf8(output.stdout).unwrap()
}

/// The commands that `carom --help` names.
fn commands() -> Vec<String> {
    let output = Command::new(env!("CARGO_BIN_EXE_carom")).arg("--help").output().unwrap();
    let help = String::from_utf8(output.stdout).unwrap();
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| line.starts_with("  "));
    let names = listed.filter_map(|line| line.strip_prefix("  ").filter(|line| !line.starts_with(' ')));
    names.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

/// The examples under a help, without what is said of them.
fn examples(help: &str) -> Vec<String> {
    let lines = help.lines().filter_map(|line| line.strip_prefix("  carom "));
    lines.map(|line| format!("carom {}", line.split("  ").next().unwrap().trim_end())).collect()
}

/// What is in an example that is not run here, and why.
const NOT_RUN: [(&str, &str); 9] = [
    ("--watch", "goes on until it is stopped; tests/preview.rs runs it"),
    ("pdf", "needs TeX or a browser; tests/pdf.rs makes them"),
    ("carom study", "takes minutes; tests/study.rs runs it"),
    ("million.csv", "stands for a file too long to keep; tests/mark_stream makes one"),
    ("--overrides", "needs marks that were given; the guide for markers has some, and is run"),
    ("answers.jsonl", "needs answers; tests/mark.rs has some"),
    ("carom check  ", "the shipped bank; .ci/run examines it"),
    ("carom preview rest/speeds", "the beginning of a name, which may come to fit several questions"),
    ("5C-2 --count 30", "the same with fewer is run by the guide for teachers"),
];

#[test]
fn every_command_shows_examples_in_its_help_and_they_run() {
    let commands = commands();
    assert!(commands.len() > 12 && commands.contains(&"new-bank".to_owned()), "{commands:?}");
    let here = folder("help");
    fs::write(here.join("scene.json"), fs::read("examples/scene.json").unwrap()).unwrap();
    fs::write(here.join("class.csv"), fs::read("examples/class.csv").unwrap()).unwrap();
    for line in ["carom new-bank my-bank", "carom sheet 5C-2 --reference"] {
        runs(line, &here, "this test");
    }
    fs::write(here.join("submissions.csv"), "student,question,answer\nAda,1,speed of A = 2.78\n").unwrap();
    let mut left: BTreeSet<&str> = NOT_RUN.iter().map(|(part, _)| *part).collect();
    for name in &commands {
        let help = help_of(name);
        let broken = help.lines().find(|line| line.starts_with("  carom ") && line.chars().count() > 98);
        assert_eq!(broken, None, "`carom {name} --help` breaks a long line");
        let examples = examples(&help);
        assert!(!examples.is_empty(), "`carom {name} --help` shows no example");
        for example in examples {
            assert!(example.split_whitespace().nth(1) == Some(name), "`carom {name} --help` shows `{example}`");
            let line = format!("{example}  ");
            match NOT_RUN.iter().find(|(part, _)| line.contains(part)) {
                Some((part, _)) => drop(left.remove(part)),
                // Each begins where nothing of its own is there yet.
                None if example.contains("new-bank") => runs(&example, &folder("help-new"), name),
                None if example.contains("--count") => {}
                None => runs(&example, &here, name),
            }
        }
    }
    assert!(left.is_empty(), "no help shows {left:?} any more");
}

/// The sheet whose code is shown in a help; the fresh one is told when that leads nowhere any more.
const OF_CODES: &str = "carom sheet 5C-2 --seed 1";

#[test]
fn every_code_that_is_shown_leads_to_a_sheet_of_the_shipped_bank() {
    let contents = Contents::shipped();
    let mut pages: Vec<(String, String)> = commands().iter().map(|name| (name.clone(), help_of(name))).collect();
    for page in ["README.md", "docs/exchange-formats.md", "docs/marking.md", "docs/marking-in-bulk.md"] {
        pages.push((page.to_owned(), fs::read_to_string(page).unwrap()));
    }
    for guide in fs::read_dir("docs/guides").unwrap().map(|entry| entry.unwrap().path()) {
        pages.push((guide.display().to_string(), fs::read_to_string(&guide).unwrap()));
    }
    let is_sign = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '-';
    let mut seen = 0;
    for (page, text) in &pages {
        for word in text.split(|c: char| !is_sign(c)).filter(|word| word.find('-') == Some(4)) {
            let Ok(code) = SheetCode::read(word) else { continue };
            seen += 1;
            if Sheet::from_code(&contents, &code).is_err() {
                let here = folder("codes");
                runs(&format!("{OF_CODES} --format text"), &here, "this test");
                let key = fs::read_to_string(here.join("sheet/key.json")).unwrap();
                let fresh = key.split("\"code\": \"").nth(1).unwrap().split('"').next().unwrap();
                panic!("{page} shows the code {word}, which leads nowhere; that of `{OF_CODES}` is {fresh}");
            }
        }
    }
    assert!(seen > 4, "{seen} codes are shown");
}

#[test]
fn the_code_and_the_index_in_the_examples_of_a_lock_and_a_key_are_those_of_their_numbers() {
    let page = fs::read_to_string("docs/exchange-formats.md").unwrap();
    let examples = page.split("```json\n").skip(1).map(|block| block.split("```").next().unwrap());
    let examples: Vec<Json> = examples.filter_map(|example| serde_json::from_str(example).ok()).collect();
    let key = examples.iter().find(|example| example["questions"][0]["parameters"].is_object()).unwrap();
    let lock = examples.iter().find(|example| example["sheets"].is_array()).unwrap();
    let (contents, shown) = (Contents::shipped(), &key["questions"][0]);
    let heading = contents.headings.iter().find(|heading| shown["id"] == heading.id.as_str()).unwrap();
    let question = heading.question().unwrap_or_else(|faults| panic!("{faults:?}"));
    let style = question.styles.iter().find(|style| shown["style"] == style.name.name()).unwrap();
    let has_its_numbers = |index: &u64| {
        let numbers = style.parameters_at(*index);
        numbers.iter().all(|(name, value)| shown["parameters"][name] == print::plain(value).as_str())
    };
    let index = (0..style.size()).find(has_its_numbers).expect("the style has these numbers");
    let variant = examine(&question, style, index).expect("they are fit for print");
    let code = Sheet::new(&contents, [(&question, &variant)]).code.to_string();
    let sheet = &lock["sheets"][0];
    let said = [&key["code"], &sheet["code"], &sheet["questions"][0]["id"], &sheet["questions"][0]["style"]];
    let fresh = json!([code, code, shown["id"], shown["style"]]);
    assert_eq!((json!(said), &sheet["questions"][0]["index"]), (fresh, &json!(index)), "left is shown, right is fresh");
}

#[test]
fn every_help_says_what_the_command_is_for_in_a_line_that_a_list_can_hold() {
    for name in commands() {
        let help = help_of(&name);
        let first = help.lines().next().unwrap();
        assert!((15..=100).contains(&first.len()) && !first.ends_with('.'), "carom {name}: {first}");
        assert!(help.contains("Usage: carom"), "{help}");
    }
}

/// The lines of a guide in order: commands, and files that it has the reader write.
enum Step {
    Run(String),
    Write(String, String),
}

fn steps(page: &str) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some(fence) = line.strip_prefix("```").filter(|fence| !fence.is_empty()) else { continue };
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        match fence.split_once(' ') {
            Some((_, file)) => steps.push(Step::Write(file.to_owned(), format!("{}\n", block.join("\n")))),
            None if fence == "console" => {
                let commands = block.iter().map(|line| line.strip_prefix("$ ").expect("each line is a command"));
                steps.extend(commands.map(|line| Step::Run(line.to_owned())));
            }
            None => {}
        }
    }
    steps
}

#[test]
fn every_command_of_the_guides_runs_as_it_is_shown() {
    for guide in ["teacher", "marker", "author", "programmer"] {
        let here = folder(guide);
        let page = fs::read_to_string(format!("docs/guides/{guide}.md")).unwrap();
        assert!(page.lines().count() <= 90, "{guide}: a guide is a page");
        let mut count = 0;
        for step in steps(&page) {
            match step {
                Step::Write(file, text) => fs::write(here.join(file), text).unwrap(),
                Step::Run(line) => {
                    runs(&line, &here, guide);
                    count += 1;
                }
            }
        }
        assert!(count > 3, "{guide}: {count} commands were found");
    }
}

#[test]
fn what_the_guide_for_markers_promises_is_there() {
    let here = folder("promises");
    for step in steps(&fs::read_to_string("docs/guides/marker.md").unwrap()) {
        match step {
            Step::Write(file, text) => fs::write(here.join(file), text).unwrap(),
            Step::Run(line) => runs(&line, &here, "marker"),
        }
    }
    for file in ["marks.csv", "feedback"] {
        assert!(here.join("marks").join(file).exists(), "{file}");
    }
    let marks = fs::read_to_string(here.join("marks/marks.csv")).unwrap();
    let row = |start: &str| {
        marks.lines().find(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{start} in {marks}"))
    };
    assert!(row("Ada,1,,speed of A").contains("correct"), "{marks}");
    assert!(row("Cem,1,,speed of A").contains("unreadable"), "{marks}");
}

#[test]
fn colours_are_there_when_they_are_asked_for_and_only_then() {
    let ask = |arguments: &[&str], no_color: bool| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command.args(arguments).env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE").stdout(Stdio::null());
        if no_color {
            command.env("NO_COLOR", "1");
        }
        String::from_utf8(command.output().unwrap().stderr).unwrap()
    };
    let folder = folder("colours");
    fs::write(folder.join("q.toml"), "title = 1\n").unwrap();
    let bank = folder.to_str().unwrap();
    for (arguments, no_color, coloured) in [
        (&["check", bank][..], false, false),
        (&["check", bank, "--color", "always"], false, true),
        (&["check", bank, "--colour", "always"], false, true),
        (&["check", bank, "--color=never"], false, false),
        (&["check", bank], true, false),
        // What is said on the command line counts for more than what is said once for all.
        (&["--color", "always", "check", bank], true, true),
    ] {
        let said = ask(arguments, no_color);
        assert!(said.contains("title"), "{said}");
        assert_eq!(said.contains('\u{1b}'), coloured, "{arguments:?}: {said:?}");
    }
}

#[test]
fn completions_and_the_manual_know_every_command() {
    let here = folder("manual");
    let commands = commands();
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let script = String::from_utf8(run(&format!("carom completions {shell}"), &here).stdout).unwrap();
        for name in commands.iter().map(String::as_str).chain(["--large-print", "--class"]) {
            assert!(script.contains(name.trim_start_matches("--")), "{shell}: {name}");
        }
    }
    let pages = String::from_utf8(run("carom man", &here).stdout).unwrap();
    for name in commands.iter().map(|name| format!("man/carom-{name}.1")).chain(["man/carom.1".to_owned()]) {
        assert!(pages.lines().any(|page| page == name), "{name} in {pages}");
        let page = fs::read_to_string(here.join(&name)).unwrap();
        assert!(page.contains(".SH SYNOPSIS") && page.len() > 500, "{name}");
    }
    assert_eq!(pages.lines().count(), commands.len() + 1);
    assert!(fs::read_to_string(here.join("man/carom-sheet.1")).unwrap().contains(".SH EXAMPLES"));
}

#[test]
fn a_line_is_cut_into_words_as_a_shell_does_it() {
    assert_eq!(
        words("carom sheet --topic 'i and j'  --n \"a b\""),
        ["carom", "sheet", "--topic", "i and j", "--n", "a b"]
    );
    assert_eq!(examples("Examples:\n  carom x y   why not\n  A,1\n  carom z"), ["carom x y", "carom z"]);
}
