//! `carom compare` as a teacher and as a program meet it, hostile lines among the rest.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use serde_json::{Value as Json, json};

fn carom(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).arg("compare").args(arguments).output().unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The verdict lines for what is fed to `--stream`.
fn stream(input: Vec<u8>) -> Vec<Json> {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["compare", "--stream"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // The verdicts are read while lines are still written: neither side waits for the other.
    let writer = std::thread::spawn(move || stdin.write_all(&input).unwrap());
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(output.status.success());
    stdout(&output).lines().map(|line| serde_json::from_str(line).expect(line)).collect()
}

#[test]
fn a_person_is_told_the_verdict_the_reading_and_a_sentence() {
    let output = carom(&["4*sqrt(39)/9", "2.77 m/s"]);
    assert_eq!(output.status.code(), Some(0));
    let expected = "partial (truncated)\nread as  2.77 m/s\nRound the last figure instead of cutting the number off.\n";
    assert_eq!(stdout(&output), expected);
    assert_eq!(stdout(&carom(&["4*i + j", "4i + j"])).lines().next(), Some("correct"));
}

#[test]
fn a_program_is_told_the_same_in_json() {
    let output = carom(&["10/43", "0.23", "--accept", "2dp", "--json"]);
    let said: Json = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(said["verdict"], "correct");
    assert_eq!(said["note"], Json::Null);
    assert!(said["reading"].is_string() && said["feedback"].is_string());
}

#[test]
fn options_change_the_verdict() {
    for (arguments, verdict) in [
        (&["48/25", "1.92 m/s"][..], "correct"),
        (&["48/25", "1.92 m/s", "--find", "ke.lost"], "partial"),
        (&["4*i + j", "4i + j", "--find", "A.after.x,A.after.y"], "correct"),
        (&["8", "v = 8", "--find", "k", "--symbols", "k=positive"], "unreadable"),
        (&["8", "k = 8", "--find", "k", "--symbols", "k=positive"], "correct"),
        (&["atan(7)", "82"], "partial"),
        (&["atan(7)", "82", "--accept", "nearest degree"], "correct"),
        (&["2/3", "2:3", "--kind", "ratio"], "correct"),
        (&["[1, -3]", "-2i + 6j", "--kind", "line"], "correct"),
        (&["sqrt(x^2)", "x"], "correct"),
        (&["sqrt(x^2)", "x", "--symbols", "x=real"], "wrong"),
        (&["2*v+3*w=4*u", "2mv+3mw=4mu", "--symbols", "m=positive"], "correct"),
        (&["2*v+3*w=4*u", "2v-3w=4u"], "wrong"),
        (
            &[
                "6*sin(10*deg) perpendicular to the line of centres",
                "1.04 perpendicular to the line of centres",
                "--kind",
                "velocity",
            ],
            "correct",
        ),
        (&["3", ""], "blank"),
        (&["3", "3..2"], "unreadable"),
        (&["3", "--", "-3"], "partial"),
        (&["-3", "-3"], "correct"),
        (&["-3", "--accept", "exact", "-3.0"], "correct"),
    ] {
        let output = carom(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        let first = stdout(&output);
        assert_eq!(first.split_whitespace().next(), Some(verdict), "{arguments:?}: {first}");
    }
}

#[test]
fn what_is_wrong_with_the_question_is_said_with_one_thing_to_try() {
    for (arguments, expected) in [
        (&["2*(3", "6"][..], "error: `(` is never closed\n --> model:1:3\n"),
        (&["sin(10)", "1"], "help: write degrees with `deg`"),
        (&["4", "4", "--kind", "vector"], "the model is of kind `number`, not `vector`"),
        (&["4", "4", "--kind", "numbr"], "help: did you mean `number`?"),
        (&["4", "4", "--accept", "roughly"], "help: write `exact`"),
        (&["u", "u", "--symbols", "u=positiv"], "help: did you mean `positive`?"),
        (&["u", "u", "--symbols", "u"], "help: write `u=positive`"),
        (&["4", "4", "--find", "A.after.sped"], "help: did you mean `A.after.speed`?"),
    ] {
        let output = carom(arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(stderr(&output).contains(expected), "{arguments:?}: {}", stderr(&output));
        assert_eq!(stdout(&output), "");
    }
    assert_eq!(carom(&["4"]).status.code(), Some(2));
    assert_eq!(carom(&["4", "4", "--stream"]).status.code(), Some(2));
}

#[test]
fn a_stream_answers_every_line_in_order_whatever_comes() {
    let mut input = Vec::new();
    let mut expected: Vec<&str> = Vec::new();
    let mut line = |text: &[u8], verdict: &'static str| {
        input.extend_from_slice(text);
        input.push(b'\n');
        expected.push(verdict);
    };
    let compare = |model: &str, answer: &str| json!({"model": model, "answer": answer}).to_string().into_bytes();
    line(&compare("4*sqrt(39)/9", "2.78"), "correct");
    line(b"", "unreadable");
    line(b"nonsense", "unreadable");
    line(b"[1, 2]", "unreadable");
    line(b"{\"model\": \"2\"}", "unreadable");
    line(b"{\"model\": 2, \"answer\": \"2\"}", "unreadable");
    line(b"{\"model\": \"2*(\", \"answer\": \"2\"}", "unreadable");
    line(b"{\"model\": \"2\", \"answer\": \"2\", \"kind\": \"sphere\"}", "unreadable");
    line(b"{\"model\": \"u\", \"answer\": \"u\", \"symbols\": [\"u\"]}", "unreadable");
    line(b"{\"model\": \"2*i\", \"answer\": \"2i\", \"find\": [\"A.after.x\", \"A.after.y\"]}", "correct");
    line(b"{\"model\": \"2*i\", \"answer\": \"2i\", \"find\": [1, 2]}", "unreadable");
    line(b"\xff\xfe{}", "unreadable");
    line("[".repeat(50_000).as_bytes(), "unreadable");
    line(&vec![b'x'; 3_000_000], "unreadable");
    line(&compare("2", &"9".repeat(5_000)), "unreadable");
    line(&compare("v/6", "v/6"), "correct");
    line(b"{\"model\": \"2\", \"answer\": \"\"}", "blank");
    // A row of dashes says nothing.
    line(&compare("4*sqrt(39)/9", &"-".repeat(1_990)), "blank");
    for hostile in [
        "(".repeat(1_990),
        ")".repeat(1_990),
        "√".repeat(600),
        "10^9999".to_owned(),
        "9^9^9^9^9".to_owned(),
        "2^-99999999999999999999".to_owned(),
        "1/0".to_owned(),
        "0/0".to_owned(),
        "√-1".to_owned(),
        "9".repeat(1_990),
        format!("0.{}1", "0".repeat(1_900)),
        "sin".repeat(600),
        "1+".repeat(900) + "1",
        "1/".repeat(900) + "1",
        "=".repeat(1_990),
        "1=".repeat(900) + "1",
        "\u{200b}\u{202e}3\u{301}\u{301}".to_owned(),
        "{\\frac".repeat(200),
        "1/(√2+√3+√5+√7+√11+√13+√17+√19+√23)".to_owned(),
        "sin 10.0000000000000000000000001°".to_owned(),
        "(√2+√3+√5+√7+√11)^16".to_owned(),
        "3, ".repeat(600),
        "2 or ".repeat(300) + "3",
    ] {
        line(&compare("4*sqrt(39)/9", &hostile), "");
    }
    line(&compare("4*i + j", "j + 4i"), "correct");
    let found = stream(input);
    assert_eq!(found.len(), expected.len());
    for (number, (found, expected)) in found.iter().zip(expected).enumerate() {
        let verdict = found["verdict"].as_str().unwrap();
        if expected.is_empty() {
            assert!(["wrong", "unreadable"].contains(&verdict), "line {}: {found}", number + 1);
        } else {
            assert_eq!(verdict, expected, "line {}: {found}", number + 1);
        }
        assert_eq!(found.as_object().unwrap().len(), 4);
    }
    assert_eq!(found[1]["note"], "broken-line");
    assert!(found[2]["feedback"].as_str().unwrap().starts_with("line 3: not JSON"));
}

#[test]
fn a_model_that_comes_again_is_judged_by_what_its_own_line_says() {
    let line = |fields: Json| format!("{fields}\n");
    let rounded = json!({"model": "10/43", "answer": "0.233"});
    let exact = json!({"model": "10/43", "answer": "0.233", "accept": "exact"});
    let letter = |range: &str| json!({"model": "abs(u)", "answer": "u", "symbols": {"u": range}});
    let others = (1..40).map(|number| json!({"model": format!("{number}"), "answer": format!("{number}")}));
    let faulty = json!({"model": "10/", "answer": "0.233"});
    let first = [rounded.clone(), exact.clone(), letter("positive"), letter("real"), faulty.clone(), rounded.clone()];
    let lines: Vec<Json> = first.into_iter().chain(others).chain([exact, rounded, faulty]).collect();
    let found = stream(lines.into_iter().map(line).collect::<String>().into_bytes());
    let verdicts: Vec<&str> = found.iter().map(|found| found["verdict"].as_str().unwrap()).collect();
    assert_eq!(verdicts[..6], ["correct", "partial", "correct", "wrong", "unreadable", "correct"]);
    assert!(verdicts[6..45].iter().all(|verdict| *verdict == "correct"), "{verdicts:?}");
    assert_eq!(verdicts[45..], ["partial", "correct", "unreadable"]);
}

#[test]
fn a_last_line_without_an_end_is_a_line_and_an_empty_stream_has_none() {
    assert_eq!(stream(b"{\"model\": \"2\", \"answer\": \"2\"}".to_vec()).len(), 1);
    assert_eq!(stream(Vec::new()).len(), 0);
}

fn page(path: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(path).unwrap()
}

/// The cells of each row of the tables in a page, without backticks.
fn rows(page: &str) -> Vec<Vec<String>> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix('|'));
    rows.map(|row| row.split(" | ").map(|cell| cell.trim().replace('`', "")).collect()).collect()
}

#[test]
fn answers_earn_what_the_page_on_marking_says() {
    let page = page("docs/marking.md");
    let verdicts = ["correct", "partial", "wrong"];
    let is_verdict = |cell: &String| verdicts.contains(&cell.split(',').next().unwrap());
    let mut seen = 0;
    for row in rows(&page).iter().filter(|row| row.len() >= 4 && is_verdict(&row[3])) {
        let [model, rule, answer, earns, ..] = row.as_slice() else { continue };
        let said = carom(&[model, answer, "--accept", rule, "--json"]);
        let said: Json = serde_json::from_str(&stdout(&said)).unwrap_or_else(|_| panic!("{row:?}: {}", stderr(&said)));
        let note = said["note"].as_str().map(|note| format!(", {note}")).unwrap_or_default();
        assert_eq!(format!("{}{note}", said["verdict"].as_str().unwrap()), *earns, "{row:?}");
        seen += 1;
    }
    assert!(seen >= 20, "{seen} rows");
}

#[test]
fn the_page_on_marking_lists_every_note_with_its_sentence() {
    let rows = rows(&page("docs/marking.md"));
    for note in carom::mark::judging::Note::ALL {
        let row = [note.tag().to_owned(), note.sentence().to_owned()];
        assert!(rows.iter().any(|other| other[..] == row), "docs/marking.md: `{}` | {}", row[0], row[1]);
    }
}

#[test]
fn a_verdict_has_the_fields_of_its_schema() {
    let schema: Json = serde_json::from_str(&page("docs/schema/verdict.schema.json")).unwrap();
    let fields = |json: &Json| json.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    let said: Json = serde_json::from_str(&stdout(&carom(&["2", "2", "--json"]))).unwrap();
    assert_eq!(fields(&said), fields(&schema["properties"]));
    assert_eq!(json!(fields(&said)), schema["required"]);
}
