//! A bank of one's own, from nothing: what `new-bank` and `new-question` write works as it stands, is never written over
//! anything, and every refusal names one thing to try.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use carom::bank::{question_schema, read_question};
use carom::diagnostic::{Source, render_all};
use serde_json::Value as Json;

/// An empty folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("authoring-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn carom(within: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).current_dir(within).args(arguments).output().unwrap()
}

/// What a command that succeeds prints and says.
fn done(within: &Path, arguments: &[&str]) -> (String, String) {
    let output = carom(within, arguments);
    let (data, talk) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{arguments:?}: {talk}");
    (data, talk)
}

/// What a command that refuses says.
fn refused(within: &Path, arguments: &[&str]) -> String {
    let output = carom(within, arguments);
    let talk = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {talk}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    talk
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Every file below a folder with its contents.
fn tree(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            found.extend(tree(&entry));
        } else {
            found.push((entry.clone(), fs::read(&entry).unwrap()));
        }
    }
    found.sort();
    found
}

#[test]
fn a_new_bank_is_sound_and_prints_a_sheet_at_once() {
    let here = folder("new-bank");
    let (written, said) = done(&here, &["new-bank", "my-bank"]);
    assert_eq!(written, "my-bank/b-at-rest/speeds.toml\nmy-bank/question.schema.json\n");
    assert!(said.contains("next: `carom check my-bank`, then `carom sheet --bank my-bank`"), "{said}");
    let (checked, remarks) = done(&here, &["check", "my-bank"]);
    assert!(checked.contains("1 question"), "{checked}");
    assert_eq!(remarks, "", "nothing is to be said against the question with which everybody begins");
    done(&here, &["sheet", "--bank", "my-bank", "--count", "4", "--seed", "1"]);
    done(&here, &["sheet", "--bank", "my-bank", "--reference", "--out", "reference"]);
    let key: Json = serde_json::from_slice(&fs::read(here.join("reference/key.json")).unwrap()).unwrap();
    // By hand: A keeps 4 sin 30° = 2 across and (4 - 2/3) 4 cos 30°/6 = 10√3/9 along; B gets (8/9) 2√3 = 16√3/9.
    let blanks = &key["questions"][0]["parts"][0]["blanks"];
    assert_eq!((&blanks[0]["rounded"], &blanks[1]["rounded"]), (&"2.78".into(), &"3.08".into()));
    assert_eq!(blanks[1]["exact"], "16*sqrt(3)/9");
}

#[test]
fn every_style_of_the_starting_question_has_numbers_enough_for_a_class() {
    let here = folder("styles");
    done(&here, &["new-bank", "b"]);
    let story: Json = serde_json::from_str(&done(&here, &["explain", "speeds", "--bank", "b", "--json"]).0).unwrap();
    for style in story["styles"].as_array().unwrap() {
        assert!(style["variants"].as_u64().unwrap() >= 60, "{style}");
    }
}

#[test]
fn a_question_is_explained_by_the_path_of_its_file_too_and_a_slip_of_the_pen_is_seen() {
    let here = folder("explain");
    let shipped = fs::read_to_string("question_bank/deflection/greatest-deflection.toml").unwrap();
    fs::create_dir(here.join("deflection")).unwrap();
    fs::write(here.join("deflection/greatest-deflection.toml"), shipped).unwrap();
    let (by_path, _) = done(&here, &["explain", "deflection/greatest-deflection.toml"]);
    assert_eq!(by_path, done(&here, &["explain", "greatest-deflection"]).0);
    let table = [
        ("speds", "did you mean `rest/speeds-and-directions` or "),
        ("5C", "did you mean `5C-"),
        ("colours", "help: `carom list` names every question"),
    ];
    for (name, help) in table {
        let said = refused(&here, &["explain", name]);
        assert!(said.contains(&format!("unknown question `{name}`")) && said.contains(help), "{said}");
    }
}

#[test]
fn carom_explains_what_each_mistake_leads_to() {
    let story: Json = serde_json::from_str(&done(Path::new("."), &["explain", "5C-2", "--json"]).0).unwrap();
    let slip = |tag: &str| story["slips"].as_array().unwrap().iter().find(|slip| slip["tag"] == tag).unwrap();
    let wrong = |tag: &str, answer: &str| {
        let led_to = slip(tag)["leads_to"].as_array().unwrap().iter().find(|wrong| wrong["answer"] == answer);
        led_to.map(|wrong| (wrong["values"][0][0].as_f64().unwrap() * 1000.0).round() / 1000.0)
    };
    // By hand, with u cos 30° = 2√3 along and 2 across: e = 1 gives A 2√3/3 and B 8√3/3 along; coalescing both 4√3/3.
    assert_eq!(wrong("e-taken-as-1", "speed of A"), Some(2.309));
    assert_eq!(wrong("e-taken-as-1", "speed of B"), Some(4.619));
    assert_eq!(wrong("coalesce", "speed of B"), Some(2.309));
    assert_eq!(wrong("speed-sum", "speed of B"), None);
    assert_eq!(slip("momentum-ignores-b")["leads_to"], serde_json::json!([]), "B is at rest");
    let (words, _) = done(Path::new("."), &["explain", "5C-2"]);
    for line in [
        "Reference numbers: mA = 4, mB = 2, u = 4, alpha = 30, e = 1/3",
        "    direction of A  arctan(3√3/5) ≈ 46.1° to the line of centres",
        "    direction of B  along the line of centres",
        "      → speed of A 2.31 m/s; direction of A 60°; speed of B 4.62 m/s",
        "  alpha  atan(3/4)/deg, atan(4/3)/deg, atan(5/12)/deg, atan(12/5)/deg",
    ] {
        assert!(words.lines().any(|shown| shown == line), "{line} in {words}");
    }
    assert!(!words.contains("relative       approach"), "what is required is no step of the solution");
    let (of_degrees, _) = done(Path::new("."), &["explain", "deflection/elastic"]);
    assert!(of_degrees.contains("greatest deflection  30°\n"), "{of_degrees}");
}

#[test]
fn an_example_numbers_its_equations_as_its_sheet_does_and_each_mark_has_the_id_that_others_name() {
    let (words, _) = done(Path::new("."), &["explain", "successive/three-in-a-line"]);
    let example = words.split("An example").last().unwrap();
    for number in ["(1)", "(2)", "(3)", "(4)"] {
        let numbered = example.lines().filter(|line| line.starts_with("    ") && line.ends_with(number)).count();
        assert_eq!(numbered, 1, "{number} in {example}");
    }
    assert!(words.lines().any(|line| line.starts_with("  (a)  M1b  M1")), "{words}");
}

#[test]
fn the_starting_question_explains_every_key_that_it_has() {
    let here = folder("comments");
    done(&here, &["new-bank", "b"]);
    let text = fs::read_to_string(here.join("b/b-at-rest/speeds.toml")).unwrap();
    let (mut after_note, mut unexplained) = (false, Vec::new());
    let mut in_stem = false;
    for line in text.lines() {
        in_stem ^= line.matches("'''").count() == 1;
        let is_key =
            !in_stem && line.starts_with(|c: char| c == '[' || c.is_ascii_lowercase()) && !line.starts_with(']');
        if is_key && !after_note {
            unexplained.push(line);
        }
        // A note holds for the lines that follow it without a gap.
        after_note = line.starts_with('#') || (after_note && !line.is_empty());
    }
    assert!(unexplained.is_empty(), "no note above {unexplained:?}");
}

#[test]
fn a_new_question_is_sound_wherever_it_stands_and_names_the_schema_of_its_bank() {
    let here = folder("new-question");
    done(&here, &["new-bank", "my-bank"]);
    fs::create_dir_all(here.join("my-bank/walls/hard")).unwrap();
    let table = [
        ("my-bank/impulse.toml", Some("#:schema question.schema.json")),
        ("my-bank/walls/hard/two.toml", Some("#:schema ../../question.schema.json")),
        // A topic that the bank did not have.
        ("my-bank/in-a-line/three-spheres/one.toml", Some("#:schema ../../question.schema.json")),
        ("alone.toml", None),
    ];
    for (path, schema) in table {
        let (written, said) = done(&here, &["new-question", path]);
        assert_eq!(written, format!("{path}\n"));
        assert!(said.contains(&format!("`carom preview {path} --watch`")) && said.contains("`--like walls/"), "{said}");
        let text = fs::read_to_string(here.join(path)).unwrap();
        let first = text.lines().next().unwrap();
        assert_eq!(first.starts_with("#:schema").then_some(first), schema, "{path}");
        if let Some(schema) = schema {
            let named = here.join(path).parent().unwrap().join(schema.trim_start_matches("#:schema "));
            assert!(named.is_file(), "{}", named.display());
        }
        read_question("q", &Source::new(path, text)).unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
        done(&here, &["preview", path, "--reference"]);
    }
    assert!(done(&here, &["new-question", "my-bank/walls/three.toml"]).1.contains("`carom check my-bank`"));
}

#[test]
fn a_new_question_can_begin_as_a_copy_of_a_shipped_one() {
    let here = folder("like");
    done(&here, &["new-question", "mine.toml", "--like", "5C-2"]);
    let shipped = fs::read_to_string("question_bank/rest/speeds-and-directions.toml").unwrap();
    assert_eq!(fs::read_to_string(here.join("mine.toml")).unwrap(), shipped);
    assert!(refused(&here, &["new-question", "other.toml", "--like", "5C-222"]).contains("unknown question `5C-222`"));
    assert!(!here.join("other.toml").exists(), "nothing half-done is left");
}

#[test]
fn nothing_is_written_over_and_every_refusal_names_one_thing_to_try() {
    let here = folder("refusals");
    done(&here, &["new-bank", "my-bank"]);
    fs::write(here.join("file"), "mine").unwrap();
    fs::create_dir(here.join("a folder")).unwrap();
    let before = tree(&here);
    let table: [(&[&str], &str, &str); 13] = [
        (&["new-bank", "my-bank"], "there are things in the folder `my-bank` already", "carom new-question my-bank/"),
        (&["new-bank", "file"], "`file` is a file", "`carom new-bank file.bank`"),
        (&["new-bank", "no/such/bank"], "there is no folder `no/such`", "`mkdir no/such`"),
        (&["new-bank", "file/bank"], "`file` is a file, and `file/bank` cannot be made", "choose another folder"),
        (
            &["new-question", "my-bank/b-at-rest/speeds.toml"],
            "is there already",
            "`carom preview my-bank/b-at-rest/speeds.toml`",
        ),
        (&["new-question", "my-bank"], "`my-bank` is a folder", "`carom new-question my-bank/my-question.toml`"),
        (&["new-question", "file/one.toml"], "`file` is a file", "`carom new-question my-question.toml`"),
        (&["new-question", "bank/one.toml"], "there is no folder `bank`", "`carom new-bank bank`"),
        (&["new-question", "bank/walls/one.toml"], "there is no folder `bank/walls`", "`carom new-bank bank`"),
        (&["new-question", "my-bank/one"], "ends in `.toml`", "`carom new-question my-bank/one.toml`"),
        (&["new-question", "my-bank/one two.toml"], "letters, digits", "`carom new-question my-bank/one-two.toml`"),
        (&["new-question", "a folder/.toml"], "letters, digits", "`carom new-question \"a folder/my-question.toml\"`"),
        (&["new-question", "my-bank/$(rm).toml"], "letters, digits", "my-bank/rm.toml`"),
    ];
    for (arguments, message, help) in table {
        let said = refused(&here, arguments);
        assert!(said.contains(message) && said.contains("help:") && said.contains(help), "{arguments:?}: {said}");
        assert!(said.lines().all(|line| !line.contains("panicked")), "{said}");
    }
    assert_eq!(tree(&here), before, "no refusal changes anything");
    // An empty folder is as good as none.
    fs::create_dir(here.join("empty")).unwrap();
    done(&here, &["new-bank", "empty"]);
}

#[test]
fn a_bank_that_is_none_is_told_from_one_that_is_empty() {
    let here = folder("no-bank");
    fs::create_dir(here.join("notes")).unwrap();
    fs::write(here.join("notes/read me.txt"), "no question").unwrap();
    fs::write(here.join("one.toml"), "").unwrap();
    let table = [
        ("nowhere", "there is no folder `nowhere`", "`carom new-bank nowhere`"),
        ("notes", "no questions in `notes`", "`carom new-question notes/my-question.toml`"),
        ("one.toml", "`one.toml` is a file, and a bank is a folder", "`carom preview one.toml`"),
    ];
    for (bank, message, help) in table {
        for arguments in [&["check", bank][..], &["list", "--bank", bank], &["sheet", "--bank", bank]] {
            let said = refused(&here, arguments);
            assert!(said.contains(message) && said.contains(help), "{arguments:?}: {said}");
        }
    }
}

#[test]
fn a_file_that_cannot_be_read_hides_none_of_the_others() {
    let here = folder("unreadable");
    done(&here, &["new-bank", "my-bank"]);
    fs::write(here.join("my-bank/latin.toml"), b"title = 'r\xe9st'\n").unwrap();
    fs::write(here.join("my-bank/long.toml"), "#".repeat(100_001)).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("nowhere.toml", here.join("my-bank/link.toml")).unwrap();
    let output = carom(&here, &["check", "my-bank", "--fresh"]);
    assert_eq!(output.status.code(), Some(1));
    let (summary, faults) = (text(&output.stdout), text(&output.stderr));
    assert!(summary.contains("b-at-rest/speeds") && summary.contains("1 question, "), "{summary}");
    let unread = if cfg!(unix) { 3 } else { 2 };
    assert!(summary.ends_with(&format!("{unread} findings, {unread} files not read\n")), "{summary}");
    for message in ["my-bank/latin.toml:1:11", "`my-bank/long.toml` is longer"] {
        assert!(faults.contains(message), "{faults}");
    }
    assert!(cfg!(not(unix)) || faults.contains("`my-bank/link.toml` cannot be read"), "{faults}");
    assert_eq!((faults.matches("error:").count(), faults.matches("help:").count()), (unread, unread), "{faults}");
    // Others deal from the whole of a bank or not at all.
    assert!(refused(&here, &["list", "--bank", "my-bank"]).contains("latin.toml"));
}

/// `CAROM_ACCEPT=1 cargo test --test authoring` writes the page anew.
#[test]
fn the_schema_that_is_kept_is_the_one_that_the_types_give() {
    let path = Path::new("docs/schema/question.schema.json");
    let fresh = format!("{:#}\n", question_schema());
    if std::env::var_os("CAROM_ACCEPT").is_some() {
        fs::write(path, &fresh).unwrap();
    }
    assert!(fs::read_to_string(path).unwrap_or_default() == fresh, "{} is not fresh; see above", path.display());
    assert_eq!(done(Path::new("."), &["schema", "question"]).0, fresh);
    let here = folder("schema");
    done(&here, &["new-bank", "b"]);
    assert_eq!(fs::read_to_string(here.join("b/question.schema.json")).unwrap(), fresh);
}

#[test]
fn every_schema_that_is_kept_is_printed() {
    for entry in fs::read_dir("docs/schema").unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_name().unwrap().to_string_lossy().replace(".schema.json", "");
        if name == "question" {
            // It is made, and compared with what is kept above.
            continue;
        }
        assert_eq!(done(Path::new("."), &["schema", &name]).0, fs::read_to_string(&entry).unwrap(), "{name}");
    }
}

/// The files of `tests/errors/` whose fault lies between names, numbers and laws, where no schema can see it. Those that
/// are no TOML at all are seen by any editor.
const UNSEEN: &str = "
absent-mark accuracy-without-method angle-where-number asked-for-twice asked-for-what-is-given brace-never-closed
brace-of-the-line-before chain-of-inequalities-in-words components-exchanged components-of-two-spheres
condition-as-a-sentence condition-misspelt condition-on-what-is-given condition-without-equation
condition-without-unknown crlf depends-on-nothing derived-beside-parameter derived-from-each-other
derived-in-wrong-order division-by-nought empty-title empty-words exact-of-no-answer formulas-that-cannot-be-read
fraction-of-latex function-that-is-none hidden-slips-misspelt impact-that-is-not-there impossible-restitution
impossible key-below-parameters later-line-of-centres-missing later-mass-given-again later-newcomer-without-mass
later-newcomer-without-velocity later-not-neighbours later-struck-by-nobody later-velocity-in-a-plane
later-wall-along-the-line later-without-e law-with-a-number left-side-shown-alone letter-called-as-a-unit
letter-nowhere-declared letter-that-is-no-unknown letter-that-is-not-declared letters-beyond-ascii long-line
mass-of-b-beside-a-wall mass-of-nought measure-never-closed method-on-accuracy no-relation not-equal-misspelt
numbers-squared-without-end open-without-a-mass open-without-b-before parameter-and-letter parameter-in-another-case
radius-of-nought range-in-words range-with-a-dash reference-lacks-parameter requirement-as-a-sentence
requirement-in-words-misspelt requirement-of-another-kind requirement-that-says-two-things requirement-twice
requirement-without-truth requirements-of-both restitution-above-one restitution-nowhere-declared result-in-stem
result-without-show reversed-range second-component-tested several-values-in-one-text shown-is-an-equation
shown-is-not-found shown-letter-given shown-letter-undeclared shown-without-a-result shown-without-a-star
sine-shown-for-a-tangent star-where-nothing-is-shown style-lacks-parameter tabs three-dots two-answers-of-one-name
underdetermined unit-in-a-value unit-misspelt unit-of-a-force unit-of-grams unit-per-hour unit-with-a-power
unit-without-a-space unknown-letter-misspelt unknown-name unknown-quantity-required unknown-that-is-given
unreadable-formula unused-parameter value-from-parameter value-left-empty value-twice-in-other-words
value-without-value velocity-along-a-line-in-a-plane velocity-in-words wrong-kind
";

/// Files, each with its contents as JSON, judged by Python's jsonschema: the names of those that are not valid.
fn invalid(files: &[(String, Json)]) -> Vec<String> {
    use std::io::Write;
    const JUDGE: &str = "import json, sys, jsonschema\n\
        whole = json.load(sys.stdin)\n\
        judge = jsonschema.Draft7Validator(whole['schema'])\n\
        jsonschema.Draft7Validator.check_schema(whole['schema'])\n\
        for name, text in whole['files']:\n    \
            faults = list(judge.iter_errors(text))\n    \
            if faults: print(name)\n";
    let mut python = Command::new("python3")
        .args(["-c", JUDGE])
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("python3 with jsonschema");
    let whole = serde_json::json!({"schema": question_schema(), "files": files});
    python.stdin.take().unwrap().write_all(whole.to_string().as_bytes()).unwrap();
    let output = python.wait_with_output().unwrap();
    assert!(output.status.success(), "python3 with jsonschema is needed");
    text(&output.stdout).lines().map(str::to_owned).collect()
}

fn as_json(path: &Path) -> Option<(String, Json)> {
    let text = String::from_utf8(fs::read(path).ok()?).ok()?;
    let toml: toml::Table = toml::from_str(text.trim_start_matches('\u{feff}')).ok()?;
    let name = path.file_stem()?.to_string_lossy().into_owned();
    Some((name, serde_json::to_value(toml).ok()?))
}

#[test]
#[ignore = "needs Python's jsonschema, which `.ci/run` installs"]
fn every_shipped_question_fits_the_schema_and_it_sees_what_a_schema_can_see() {
    let mut shipped: Vec<PathBuf> = tree(Path::new("question_bank")).into_iter().map(|(path, _)| path).collect();
    shipped.push("src/cli/starting_question.toml".into());
    shipped.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let files: Vec<(String, Json)> = shipped.iter().map(|path| as_json(path).unwrap()).collect();
    assert!(files.len() > 17);
    assert_eq!(invalid(&files), Vec::<String>::new());

    let mut errors: Vec<PathBuf> = fs::read_dir("tests/errors").unwrap().map(|entry| entry.unwrap().path()).collect();
    errors.retain(|path| path.extension().is_some_and(|ending| ending == "toml") && !path.ends_with("sound.toml"));
    errors.sort();
    let files: Vec<(String, Json)> = errors.iter().filter_map(|path| as_json(path)).collect();
    let seen = invalid(&files);
    let unseen: Vec<&str> =
        files.iter().map(|(name, _)| name.as_str()).filter(|name| !seen.contains(&(*name).to_owned())).collect();
    let expected: Vec<&str> = UNSEEN.split_whitespace().collect();
    assert_eq!(unseen, expected, "left: what the schema lets pass; right: what it may");
}
