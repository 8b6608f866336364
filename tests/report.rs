//! The report of `carom mark` as a head of department reads it: figures that can be worked out by hand, the same for a class
//! in which each has other numbers, without names if it is to be passed on.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::{Value as Json, json};

fn carom(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).current_dir(folder).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// An empty folder of this test's own, with the sheet of the reference exercises in `sheet`.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("report-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let made = carom(&folder, &["sheet", "--reference", "--format", "text", "--out", "sheet"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    folder
}

/// Marks rows, with no pages for students; the rest are options.
fn mark(folder: &Path, rows: &str, options: &[&str]) -> Output {
    fs::write(folder.join("submissions.csv"), rows).unwrap();
    let mut arguments = vec!["mark", "sheet/key.json", "submissions.csv", "--feedback", "none"];
    arguments.extend(options);
    let output = carom(folder, &arguments);
    assert!(output.status.success(), "{}", text(&output.stderr));
    output
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join("marks").join(name)).unwrap()
}

const REPORT: [&str; 4] = ["report.html", "report.csv", "report-marks.csv", "report-mistakes.csv"];

const HEAD: &str = "student,question,part,blank,answer,working\n";

/// What earns all 11 marks of exercises 2 and 3 of the reference sheet.
const SECOND: &str = "\"4√39/9, 46.1°, 3.08, along the line of centres\"";
const THIRD: &str = "\"25/7, 81.9°, 2.27, along the line of centres\"";

/// Twelve students: six have both exercises right; of the others all have one wrong value in exercise 2, and three of them
/// have exercise 3 right.
fn twelve() -> String {
    let row = |student: usize| match student {
        1..=6 => format!("S{student:02},2,,,{SECOND},\nS{student:02},3,,,{THIRD},\n"),
        7..=9 => format!("S{student:02},2,,speed of A,2.31,\nS{student:02},3,,,{THIRD},\n"),
        // 4/√3 again, written in other ways.
        10 => format!("S{student:02},2,,speed of A,2.309,\nS{student:02},3,,speed of A,100,\n"),
        11 => format!("S{student:02},2,,speed of A,2.31 m/s,\nS{student:02},3,,speed of A,100,\n"),
        _ => format!("S{student:02},2,,speed of A,4/√3,\nS{student:02},3,,speed of A,100,\n"),
    };
    HEAD.to_owned() + &(1..=12).map(row).collect::<String>()
}

#[test]
fn the_figures_are_those_that_one_works_out_by_hand() {
    let folder = folder("by-hand");
    let said: Json = serde_json::from_slice(&mark(&folder, &twelve(), &["--json"]).stdout).unwrap();
    // 6 · 22 + 3 · 11 marks of twelve students.
    assert_eq!((&said["students"], &said["marks"], &said["mean"]), (&json!(12), &json!(165), &json!(13.8)));
    let facilities: Vec<&Json> = said["questions"].as_array().unwrap().iter().map(|one| &one["facility"]).collect();
    assert_eq!(facilities, [50, 75]);
    // Of exercise 2: 12 · 66 - 6 · 99 = 198 over 6 · √3267; of exercise 3: 198 over √27 · 66. Both are 1/√3.
    for question in said["questions"].as_array().unwrap() {
        for mark in question["scheme"].as_array().unwrap() {
            assert_eq!(mark["discrimination"], 0.58, "{mark}");
        }
    }
    let table = read(&folder, "report.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows[0], "student,marks,available,per_cent,question 2,question 3");
    assert_eq!((rows[1], rows[7], rows[10]), ("S01,22,165,13,11,11", "S07,11,165,7,0,11", "S10,0,165,0,0,0"));
    let marks = read(&folder, "report-marks.csv");
    assert_eq!(marks.lines().nth(1), Some("2,rest/speeds-and-directions,5C-2,,B1a,B1,12,6,50,0.58,"));
    assert_eq!(marks.lines().count(), 1 + 2 * 11);
    // However it is written, it is one value; and the mistake that leads to it was made by all six.
    let finding = &said["findings"][0];
    assert_eq!((&finding["tag"], &finding["question"]), (&json!("same-value"), &json!("2")));
    let sentence = finding["sentence"].as_str().unwrap();
    assert!(sentence.starts_with("6 students gave 2.31 for speed of A, where 4√39/9 is right: they "), "{sentence}");
    let slip = &said["slips"][0];
    assert_eq!(slip["students"], json!(["S07", "S08", "S09", "S10", "S11", "S12"]), "{slip}");
    let made = read(&folder, "report-mistakes.csv");
    let tag = slip["tag"].as_str().unwrap();
    assert_eq!(made.lines().filter(|row| row.starts_with(tag) && row.ends_with(",2,")).count(), 6, "{made}");
}

#[test]
fn a_question_is_the_same_whichever_number_and_numbers_it_has() {
    let folder = folder("variants");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let paper = |student: &str, order: [usize; 2]| {
        let questions: Vec<Json> = (1..)
            .zip(order)
            .map(|(number, place)| {
                let mut question = key["questions"][place].clone();
                question["number"] = number.into();
                question
            })
            .collect();
        json!({"student": student, "name": format!("The {student}"), "code": "X", "questions": questions})
    };
    let class = json!({"papers": [paper("Ada", [1, 2]), paper("Ben", [2, 1])]});
    fs::write(folder.join("sheet/key.json"), class.to_string()).unwrap();
    let rows = format!("{HEAD}Ada,1,,,{SECOND},\nAda,2,,,{THIRD},\nBen,1,,,{THIRD},\n");
    mark(&folder, &rows, &[]);
    let marks = read(&folder, "report-marks.csv");
    let of = |id: &str| marks.lines().filter(|row| row.starts_with(&format!("{id},{id},"))).collect::<Vec<_>>();
    assert!(of("rest/speeds-and-directions").iter().all(|row| row.contains(",1,1,100,")), "{marks}");
    assert!(of("rest/heavier-sphere-struck").iter().all(|row| row.contains(",2,2,100,")), "{marks}");
    assert_eq!(marks.lines().count(), 1 + 2 * 11);
    // Tables have the name beside what the marks go by, the page too; what was not handed in is no nought.
    assert!(read(&folder, "report.csv").contains("\nBen,The Ben,11,22,50,,11\n"), "{}", read(&folder, "report.csv"));
    assert!(read(&folder, "report.html").contains("The Ben (Ben)"));
}

#[test]
fn the_same_question_twice_on_a_sheet_is_two_questions() {
    let folder = folder("twice");
    let mut key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let mut again = key["questions"][1].clone();
    again["number"] = 18.into();
    key["questions"].as_array_mut().unwrap().push(again);
    fs::write(folder.join("sheet/key.json"), key.to_string()).unwrap();
    mark(&folder, &format!("{HEAD}Ada,2,,,{SECOND},\nAda,18,,speed of A,1,\n"), &[]);
    let table = read(&folder, "report.csv");
    assert!(table.contains("question 2,question 18\n") && table.contains(",11,0\n"), "{table}");
}

#[test]
fn a_report_without_names_cannot_be_traced_by_its_order() {
    let folder = folder("nameless");
    // Zoe is last in the alphabet and in the file, and best.
    let rows =
        format!("{HEAD}Ada,2,,speed of A,Ada Lovelace,\nBen,2,,speed of A,2.8,\nZoe,2,,,{SECOND},\nEve,99,,,1,\n");
    let output = mark(&folder, &rows, &["--without-names"]);
    let printed = format!("{}{}", text(&output.stdout), text(&output.stderr));
    let json = text(&mark(&folder, &rows, &["--without-names", "--json"]).stdout);
    let all = REPORT.map(|name| read(&folder, name)).concat() + &printed + &json;
    for name in ["Ada", "Lovelace", "Ben", "Zoe", "Eve"] {
        assert!(!all.contains(name), "{name}");
    }
    let table = read(&folder, "report.csv");
    let marks: Vec<&str> = table.lines().skip(1).map(|row| &row[..row.match_indices(',').nth(1).unwrap().0]).collect();
    assert_eq!(marks, ["Student 1,11", "Student 2,8", "Student 3,0"]);
    let backwards: Vec<&str> = rows.lines().skip(1).collect();
    let backwards: Vec<&str> = backwards.into_iter().rev().collect();
    let before = REPORT.map(|name| read(&folder, name));
    mark(&folder, &format!("{HEAD}{}\n", backwards.join("\n")), &["--without-names"]);
    assert_eq!(before, REPORT.map(|name| read(&folder, name)), "who handed in first is nobody's business");
    // What goes to the students has their names as ever.
    assert!(read(&folder, "marks.csv").contains("Zoe"));
}

#[test]
fn students_who_differ_in_their_working_alone_cannot_be_told_apart_by_the_file() {
    let folder = folder("nameless-working");
    let kim = "Kim,2,,speed of A,1,\"4v + ) = 3 ]\nv = 3\"\n";
    let lee = "Lee,2,,speed of A,1,\"v = 3\n4v + ) = 3 ]\"\n";
    let reports = [[kim, lee], [lee, kim]].map(|rows| {
        mark(&folder, &format!("{HEAD}{}", rows.concat()), &["--without-names"]);
        REPORT.map(|name| read(&folder, name))
    });
    assert!(reports[0].concat().contains("line 2: "), "a line of each is for a person to read");
    assert_eq!(reports[0], reports[1]);
}

#[test]
fn what_is_printed_fits_on_a_screen_however_much_there_is_to_tell() {
    let folder = folder("screen");
    let empty = fs::read_to_string(folder.join("sheet/submissions.csv")).unwrap();
    let answers = ["4.62", "dunno ???", "1/3", "2.8"];
    let student = |number: usize| {
        let filled = empty.lines().skip(1).enumerate().map(move |(place, row)| {
            let answer = answers[(place + number / 4) % answers.len()];
            format!("A student with a rather long name {number}{},{answer},\n", row.trim_end_matches(",,"))
        });
        filled.collect::<String>()
    };
    let rows = HEAD.to_owned() + &(0..12).map(student).collect::<String>();
    let output = mark(&folder, &rows, &[]);
    let said = text(&output.stdout);
    assert!(said.lines().count() <= 24, "{} lines\n{said}", said.lines().count());
    assert!(said.lines().all(|line| line.chars().count() <= 80), "{said}");
    for heading in
        ["12 students, ", "the 8 hardest of 17", "What looks wrong: ", "Mistakes, and how many", "For you to look at"]
    {
        assert!(said.contains(heading), "{heading}\n{said}");
    }
}

#[test]
fn a_nasty_name_is_harmless_in_every_table_and_page_of_the_report() {
    let folder = folder("nasty");
    let names = ["<script>alert(1)</script>", "=1+1", "\t=1+1", "@x", "-2+3", "\u{202e}evil", "a\0b", "new\nline"];
    let long = "y".repeat(10_000);
    let lines = names.iter().copied().chain([long.as_str()]).map(|name| {
        let row = json!({"student": name, "question": 2, "blank": "speed of A", "answer": "2.31", "working": name});
        format!("{row}\n")
    });
    mark(&folder, &lines.collect::<String>(), &[]);
    let page = read(&folder, "report.html");
    assert!(!page.contains("<script") && !page.contains(['\0', '\u{202e}']) && page.len() < 100_000, "{}", page.len());
    for name in REPORT.iter().filter(|name| name.ends_with(".csv")) {
        let table = read(&folder, name);
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(table.as_bytes());
        let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert!(records.len() > names.len());
        for cell in records.iter().flatten() {
            assert!(
                !cell.trim_start().starts_with(['=', '+', '-', '@']) && !cell.contains(['\0', '\u{202e}', '\n']),
                "{cell}"
            );
        }
    }
}

#[test]
fn a_line_of_another_way_to_what_is_to_be_shown_is_for_a_person() {
    let folder = folder("another-way");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let questions = key["questions"].as_array().unwrap();
    let turned =
        questions.iter().find(|question| question["id"] == "rest-letters/turned-through-a-right-angle").unwrap();
    let working = |step: &str| {
        format!("v cosθ = x + 2y\ny - x = ev cosθ\nx = v cosθ(1-2e)/3\nv sinθ across\n{step}tan²θ = (2e-1)/3")
    };
    let row = |student: &str, step: &str| {
        format!("{student},{},,,tan²θ = (2e-1)/3,\"{}\"\n", turned["number"], working(step))
    };
    let rows = [HEAD, &row("S1", "m1m2 = -1\n"), &row("S2", "")].concat();
    mark(&folder, &rows, &[]);
    let report = read(&folder, "report.html");
    let (_, said) = report.split_once("m1m2 = -1").unwrap();
    assert!(said.contains("this line plays no part in what was found of it"), "{said}");
    assert_eq!(report.matches("plays no part").count(), 1);
}

#[test]
fn a_chain_to_what_is_to_be_shown_with_no_law_written_out_is_for_a_person() {
    let folder = folder("chain");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let questions = key["questions"].as_array().unwrap();
    let turned =
        questions.iter().find(|question| question["id"] == "rest-letters/turned-through-a-right-angle").unwrap();
    let row = |student: &str, working: &str| format!("{student},{},,,tan²θ = (2e-1)/3,{working}\n", turned["number"]);
    let whole = "cotθ = 3v sinθ/(v cosθ(2e-1)) = 3tanθ/(2e-1) so tan²θ = (2e-1)/3";
    let rows = [HEAD, &row("S1", whole), &row("S2", "tan²θ = (2e-1)/3")].concat();
    mark(&folder, &rows, &[]);
    let report = read(&folder, "report.html");
    assert_eq!(report.matches("not all of its steps were found in this line").count(), 1, "{report}");
}

#[test]
fn a_right_answer_beside_working_that_ends_with_another_number_is_for_a_person() {
    let folder = folder("ends-elsewhere");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let questions = key["questions"].as_array().unwrap();
    let rest = questions.iter().find(|question| question["id"] == "rest/speeds-and-directions").unwrap();
    let row = |student: &str, working: &str| format!("{student},{},,speed of A,2.78,{working}\n", rest["number"]);
    let rows = [HEAD, &row("S1", "√(1.92² + 2²) = 2.4"), &row("S2", "√(1.92² + 2²) = 2.77")].concat();
    mark(&folder, &rows, &[]);
    let report = read(&folder, "report.html");
    assert_eq!(report.matches("your working comes to something else").count(), 1, "{report}");
}
