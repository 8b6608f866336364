//! `carom mark` as a teacher and as a program meet it: what is handed in, however broken or nasty, and what comes of it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::{Value as Json, json};

fn carom(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).current_dir(folder).args(arguments).output().unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// An empty folder of this test's own, with the sheet of the reference exercises in `sheet`.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("mark-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let made = carom(&folder, &["sheet", "--reference", "--format", "text", "--out", "sheet"]);
    assert!(made.status.success(), "{}", stderr(&made));
    folder
}

/// Marks submissions that are written to a file; the rest are options.
fn mark(folder: &Path, submissions: impl AsRef<[u8]>, options: &[&str]) -> Output {
    fs::write(folder.join("submissions.csv"), submissions).unwrap();
    let mut arguments = vec!["mark", "sheet/key.json", "submissions.csv"];
    arguments.extend(options);
    carom(folder, &arguments)
}

/// The records of a table, the header first.
fn table(path: PathBuf) -> Vec<Vec<String>> {
    let bytes = fs::read(&path).unwrap_or_else(|fault| panic!("{}: {fault}", path.display()));
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(&bytes[..]);
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

/// Rows of `marks.csv` without its header: the columns from `from` to `to`, joined by `|`.
fn marks(folder: &Path, from: usize, to: usize) -> Vec<String> {
    table(folder.join("marks/marks.csv")).iter().skip(1).map(|row| row[from..to].join("|")).collect()
}

/// Exercise 2 of the seed: 4√39/9 and 46.1°, 16√3/9 along the line of centres.
const ADA: &str = "student,question,part,blank,answer,working
Ada,2,,speed of A,4√39/9,
Ada,2,,direction of A,46.1°,
Ada,2,,speed of B,3.08 m/s,
Ada,2,,direction of B,along the line of centres,
";

#[test]
fn a_right_answer_earns_all_that_leads_to_it_and_each_mark_stands_in_one_row() {
    let folder = folder("right");
    let output = mark(&folder, ADA, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let expected = [
        "Ada|2||speed of A|correct|9|9|B1 M1 A1 M1 A1 dM1 A1 M1 A1|",
        "Ada|2||direction of A|correct|1|1|A1|",
        "Ada|2||speed of B|correct|1|1|A1|",
        "Ada|2||direction of B|correct|0|0||",
    ];
    assert_eq!(marks(&folder, 0, 9), expected);
    assert!(stdout(&output).starts_with("1 student, 11.0 of "), "{}", stdout(&output));
    assert!(folder.join("marks/feedback/ada.html").is_file());
    assert!(!folder.join("marks/not-marked.csv").exists());
}

#[test]
fn one_answer_for_all_blanks_earns_one_row() {
    let folder = folder("together");
    let rows =
        "student,question,answer\nAda,2,\"4√39/9, 46.1°, 3.08, along the line of centres\"\nBen,2,\nCy,2,what?\n";
    mark(&folder, rows, &[]);
    let expected = ["Ada|2|||correct|11|11", "Ben|2|||blank|0|11", "Cy|2|||unreadable|0|11"];
    assert_eq!(marks(&folder, 0, 7), expected);
}

#[test]
fn every_part_that_the_sheet_asks_can_be_filled_in_and_its_marks_add_up() {
    let folder = folder("every-part");
    let empty = fs::read_to_string(folder.join("sheet/submissions.csv")).unwrap();
    let (header, rows) = empty.split_once('\n').unwrap();
    assert_eq!(header, "student,question,part,blank,answer,working");
    let filled: String = rows.lines().map(|row| format!("Ada{row}\n")).collect();
    let output = mark(&folder, format!("{header}\n{filled}"), &["--feedback", "none"]);
    assert!(output.status.success() && !folder.join("marks/feedback").exists(), "{}", stderr(&output));
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let parts = key["questions"].as_array().unwrap().iter().flat_map(|question| question["parts"].as_array().unwrap());
    let (blanks, available): (usize, u64) = parts
        .map(|part| (part["blanks"].as_array().unwrap().len(), part["marks"].as_u64().unwrap()))
        .fold((0, 0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
    let found = marks(&folder, 6, 7);
    assert_eq!(found.len(), blanks);
    assert_eq!(found.iter().map(|marks| marks.parse::<u64>().unwrap()).sum::<u64>(), available);
    assert!(marks(&folder, 4, 5).iter().all(|verdict| verdict == "blank"));
}

#[test]
fn what_has_no_place_in_the_key_is_told_with_its_line_and_set_aside() {
    let folder = folder("set-aside");
    let rows = "\
Ada,99,,,1,
Ada,rest/speeds-and-direction,,,1,
Ada,,,,1,
Ada,7,c,,1,
Ada,7,,,1,
Ada,2,a,,1,
Ada,2,,sped of A,1,
,2,,speed of A,1,
Ada,2,,speed of A,(1, 2),x,y
Ada,2
Ada,2,,speed of A,1,
Ada,2,,speed of A,2.78,
";
    let output = mark(&folder, format!("student,question,part,blank,answer,working\n{rows}"), &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let reasons = [
        ("2", "no question `99` on the sheet; there are 1 to 17"),
        ("3", "no question `rest/speeds-and-direction` on the sheet; did you mean `rest/speeds-and-directions`?"),
        ("4", "no question is named; there are 1 to 17"),
        ("5", "question 7 has no part `c`; there are a and b"),
        ("6", "which part of question 7? there are a and b"),
        ("7", "question 2 has no part `a`; it has none: leave `part` empty"),
        ("8", "no blank `sped of A`; did you mean `speed of A`?"),
        ("9", "whose is this? the student is not named"),
        ("10", "8 cells under 6 columns: a cell with a comma in it stands in quotes"),
        ("11", "the row ends after 2 of 6 cells"),
        ("12", "line 13 answers the same, and the last answer counts"),
    ];
    let found = table(folder.join("marks/not-marked.csv"));
    let found: Vec<(&str, &str)> = found.iter().skip(1).map(|row| (row[0].as_str(), row[1].as_str())).collect();
    assert_eq!(found, reasons);
    let said = stderr(&output);
    assert!(said.contains("warning: submissions.csv, line 2: no question `99`"), "{said}");
    assert!(said.contains("warning: 1 more, all in `not-marked.csv`"), "{said}");
    assert!(said.contains("11 rows not marked in `not-marked.csv`"), "{said}");
    assert_eq!(marks(&folder, 3, 6)[0], "speed of A|correct|9");
}

#[test]
fn tables_are_read_as_spreadsheets_save_them() {
    let folder = folder("tables");
    let cases = [
        "\u{feff}Student,Question,Answer\r\nAda,Q2,\"4√39/9, 46.1°, 3.08, along the line of centres\"\r\n",
        "answer;student;question\n4√39/9, 46.1°, 3.08, along the line of centres;Ada;2\n",
        "student\tquestion\tpart\tanswer\nAda\t2.0\t\t4√39/9, 46.1°, 3.08, along the line of centres\n",
        "\n\nTimestamp,student,question,answer\n1/2/27, Ada ,question 2,\"4√39/9, 46.1°, 3.08, along the line of centres\"\n,,,\n",
        "student,question,blank,answer\nAda,rest/speeds-and-directions,,\"4√39/9, 46.1°, 3.08, along the line of centres\"\n",
    ];
    for rows in cases {
        let output = mark(&folder, rows, &[]);
        assert!(output.status.success(), "{rows}: {}", stderr(&output));
        assert_eq!(marks(&folder, 0, 7), ["Ada|2|||correct|11|11"], "{rows}");
    }
}

#[test]
fn json_lines_are_marked_as_the_same_table_is() {
    let folder = folder("json-lines");
    let working = "4*4cos30 = 4v + 2w\nw - v = 1/3*4cos30";
    let rows = format!("{ADA}Ben,2,,speed of A,2.8,\"{working}\"\n");
    mark(&folder, rows, &[]);
    let expected = fs::read(folder.join("marks/marks.jsonl")).unwrap();
    let line = |student: &str, blank: &str, answer: &str, working: Json| {
        json!({"student": student, "question": 2, "blank": blank, "answer": answer, "working": working}).to_string()
    };
    let lines = [
        line("Ada", "speed of A", "4√39/9", json!(null)),
        line("Ada", "direction of A", "46.1°", json!("")),
        line("Ada", "speed of B", "3.08 m/s", json!([])),
        line("Ada", "direction of B", "along the line of centres", json!(null)),
        line("Ben", "speed of A", "2.8", json!(["4*4cos30 = 4v + 2w", "w - v = 1/3*4cos30"])),
    ];
    // One array of them is the same, however it is laid out.
    let array = format!("[{}]", lines.join(","));
    let spread = serde_json::to_string_pretty(&serde_json::from_str::<Json>(&array).unwrap()).unwrap();
    for rows in [lines.join("\n"), array, format!("\n{spread}\n"), format!("[\n{}\n]", lines.join(",\n"))] {
        let output = mark(&folder, &rows, &[]);
        assert!(output.status.success(), "{rows}: {}", stderr(&output));
        assert!(fs::read(folder.join("marks/marks.jsonl")).unwrap() == expected, "{rows}");
    }

    let layout = "each object stands on one line, without commas between them, or all in one list `[{…}, {…}]`";
    let broken = [
        ("{\"student\": \"Ada\"", &*format!("this is no JSON: it ends too early; {layout}")),
        ("{\"student\": \"Ada\"},", &*format!("something follows the object on its line; {layout}")),
        ("[1]", "this is no JSON object: write one for each answer, a line each"),
        (
            r#"{"student": "Ada", "question": 2, "answer": 2.80}"#,
            "`answer` is a number: write it as a string, so that it keeps its figures",
        ),
        (r#"{"student": "Ada", "question": 2, "anwser": "1"}"#, "`answer` is missing: is `anwser` meant for it?"),
        (r#"{"question": 2, "answer": "1"}"#, "`student` is missing"),
        (r#"{"student": 7, "question": 2, "answer": "1"}"#, "`student` is not a string"),
        (
            r#"{"student": "Ada", "question": 2, "answer": "1", "working": [1]}"#,
            "`working` is a list of something but strings",
        ),
        (
            r#"{"student": "Ada", "question": 2, "answer": "1", "working": [{"a": 1, "a": 1}], "answer": "2"}"#,
            "`answer` is given twice",
        ),
    ];
    let text: String = broken.iter().map(|(line, _)| format!("{line}\n")).collect();
    let output = mark(&folder, format!("{}\n{text}", lines[0]), &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let found = table(folder.join("marks/not-marked.csv"));
    let found: Vec<&str> = found.iter().skip(1).map(|row| row[1].as_str()).collect();
    assert_eq!(found, broken.map(|(_, reason)| reason));
    let twice = broken.last().unwrap();
    mark(&folder, format!("[{},{}]", lines[0], twice.0), &[]);
    let found = table(folder.join("marks/not-marked.csv"));
    assert_eq!(found[1][1], twice.1, "in an array too");
}

#[test]
fn a_file_that_is_wrong_as_a_whole_is_refused_and_nothing_is_written() {
    let folder = folder("whole");
    let utf_16: Vec<u8> = ADA.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let cases: [(&[u8], &[&str]); 9] = [
        (b"student,question,part,blank,answer\nZo\xeb,1,,,2\n", &["not in UTF-8: line 2", "CSV UTF-8"]),
        (&utf_16, &["UTF-16", "CSV UTF-8"]),
        (b"", &["no columns `student`, `question`, `answer`", "the file is empty"]),
        (b"student,question,part,blank,answer,working\n", &["has no answers", "carom mark --help"]),
        (b"student,question,part,blank,answer,working\n,1,,,,\n", &["name a question and no student", "fill in"]),
        (b"student,question,anwser\nAda,1,2\n", &["no column `answer`", "submissions.csv:1:18", "^^^^^^"]),
        (b"student,question,answer,answer\nAda,1,2,3\n", &["two columns `answer`"]),
        (b"student,question,answer\nAda,77,2\n", &["nothing in `submissions.csv` could be marked", "is this the key"]),
        (b"\xff\xfe\x00", &["UTF-16"]),
    ];
    for (submissions, said) in cases {
        let output = mark(&folder, submissions, &[]);
        assert_eq!(output.status.code(), Some(1), "{said:?}");
        for words in said {
            assert!(stderr(&output).contains(words), "{words}: {}", stderr(&output));
        }
        assert!(!folder.join("marks").exists(), "{said:?}");
    }
    let output = carom(&folder, &["mark", "sheet/key.json", "nowhere.csv"]);
    assert!(output.status.code() == Some(1) && stderr(&output).contains("`nowhere.csv` cannot be read"));
    assert_eq!(carom(&folder, &["mark", "sheet/key.json"]).status.code(), Some(2));
}

#[test]
fn a_column_that_is_nearly_right_is_told_of() {
    let folder = folder("nearly");
    let output = mark(&folder, "student,question,workings,answer\nAda,1,v = 2,2\n", &[]);
    let said = stderr(&output);
    assert!(output.status.success() && said.contains("nobody looks at the column `workings`"), "{said}");
    assert!(said.contains("did you mean `working`?"), "{said}");
}

#[test]
fn a_quote_that_is_never_closed_is_told_of_where_it_opens() {
    let folder = folder("quote");
    for row in ["Ben,1,2,\"v = 2\nCy,1,2,\nDee,1,2,\n", "\"Ben,1,2,\nCy,1,2,\n", "\"Ben,1,2,\n", "Ben,1,\"2\n"] {
        let rows = format!("student,question,answer,working\nAda,1,2,\n{row}");
        let output = mark(&folder, rows, &[]);
        assert!(stderr(&output).contains("line 3: a quote is opened here and never closed"), "{}", stderr(&output));
        assert_eq!(marks(&folder, 0, 1), ["Ada"], "{row}");
    }
}

#[test]
fn a_fault_of_the_key_is_shown_where_it_stands() {
    let folder = folder("key");
    let key = fs::read_to_string(folder.join("sheet/key.json")).unwrap();
    let cases: [(&str, &str, &[&str]); 7] = [
        ("\"carom\": \"", "\"carom\": \"x", &["is no version of carom", "such as", "leave `carom` out"]),
        ("\"marks\": ", "\"marks\": 9", &["marks`: 9", "and the scheme has", "one for each mark", "change `marks`"]),
        ("\"code\": \"M1\"", "\"code\": \"M9\"", &["unknown mark code `M9`", "scheme[1].code", "\"M9\"", "^^^^"]),
        ("\"kind\": \"number\"", "\"kind\": \"numbre\"", &["unknown kind of answer `numbre`", "^^^^^^^^"]),
        (
            "\"angle_deg\": \"10\"",
            "\"angle_deg\": \"10*\"",
            &["scene.before.A.angle_deg", "the expression ends too early"],
        ),
        ("\"questions\": [", "\"questions\": [[", &["this is no key", "bad.json:"]),
        ("{", "student,question", &["this is no key", "bad.json:1:1", "takes the key first"]),
    ];
    fs::write(folder.join("submissions.csv"), ADA).unwrap();
    for (from, to, said) in cases {
        fs::write(folder.join("bad.json"), key.replacen(from, to, 1)).unwrap();
        let output = carom(&folder, &["mark", "bad.json", "submissions.csv"]);
        assert_eq!(output.status.code(), Some(1), "{to}");
        for words in said {
            assert!(stderr(&output).contains(words), "{words}: {}", stderr(&output));
        }
    }
    assert!(!folder.join("marks").exists());
}

#[test]
fn each_student_of_a_class_is_marked_against_a_paper_of_their_own() {
    let folder = folder("class");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let paper = |student: &str, question: usize| {
        let mut question = key["questions"][question].clone();
        question["number"] = 1.into();
        json!({"student": student, "code": "X", "questions": [question]})
    };
    let class = json!({"papers": [paper("Ada Lovelace", 1), paper("Ben", 9)]});
    fs::write(folder.join("sheet/key.json"), class.to_string()).unwrap();
    let rows = "student,question,answer\nAda Lovelace,1,\"4√39/9, 46.1°, 3.08, along the line of centres\"\nBen,1,1\nAda Lovelac,1,2\nEve,1,2\n";
    let output = mark(&folder, rows, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(marks(&folder, 0, 6), ["Ada Lovelace|1|||correct|11", "Ben|1|||wrong|0"]);
    let said = stderr(&output);
    assert!(said.contains("the key has no paper for `Ada Lovelac`; did you mean `Ada Lovelace`?"), "{said}");
    assert!(said.contains("no paper for `Eve`; its 2 students are `Ada Lovelace` to `Ben`"), "{said}");
}

#[test]
fn a_student_is_known_by_number_and_by_a_name_that_nobody_else_has() {
    let folder = folder("by-name");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let paper = |student: &str, name: &str| {
        let mut question = key["questions"][1].clone();
        question["number"] = 1.into();
        json!({"student": student, "name": name, "code": "X", "questions": [question]})
    };
    let class = [("1", "Ada Byron"), ("2", "Ben Ali"), ("3", "Ben Ali"), ("4", "2")].map(|(id, name)| paper(id, name));
    fs::write(folder.join("sheet/key.json"), json!({ "papers": class }).to_string()).unwrap();
    let rows = "student,question,blank,answer\nAda Byron,1,speed of A,4√39/9\n1,1,speed of B,3.08\n\
                ben ali,1,speed of A,1\n2,1,speed of A,4√39/9\nAda  BYRON,1,direction of A,46.1\nEve,1,speed of A,1\n";
    fs::write(folder.join("words.csv"), "student,question,part,mark,given,comment\nAda Byron,1,,A1a,0,no\n").unwrap();
    let output = mark(&folder, rows, &["--overrides", "words.csv"]);
    let said = stderr(&output);
    assert!(output.status.success(), "{said}");
    // However she was called she is one student, and the report has her name.
    let students: Vec<String> = marks(&folder, 0, 1);
    assert!(students.iter().all(|student| ["1", "2"].contains(&student.as_str())), "{students:?}");
    let table = table(folder.join("marks/report.csv"));
    assert_eq!((table.len(), &table[1][..2]), (3, &["1".to_owned(), "Ada Byron".to_owned()][..]));
    assert!(said.contains("several students are called `ben ali`; they are `2` and `3`"), "{said}");
    assert!(said.contains("no paper for `Eve`; its 4 students are `1` to `4`"), "{said}");
    assert!(!said.contains("which was not handed in"), "{said}");
    let page = fs::read_to_string(folder.join("marks/feedback/1.html")).unwrap();
    assert!(page.contains("<h1>Ada Byron (1)</h1>"), "{page}");
}

#[test]
fn a_table_that_nobody_filled_in_is_told_of_and_is_not_called_too_hard() {
    let folder = folder("unfilled");
    let rows: String = (1..=6).map(|student| format!("{student},2,speed of A,,\n{student},3,speed of A,,\n")).collect();
    let rows = format!("student,question,blank,answer,working\n{rows}");
    let said = |output: &Output| {
        assert!(output.status.success(), "{}", stderr(output));
        let report = fs::read_to_string(folder.join("marks/report.html")).unwrap();
        (stderr(output).contains("has no answers: 6 students and not one filled in"), stdout(output) + &report)
    };
    let (is_told, report) = said(&mark(&folder, &rows, &[]));
    assert!(is_told && report.contains("Nobody wrote anything for it") && !report.contains("too hard"), "{report}");
    // A question that was left out is told of by itself; one answer is enough for a class that did something.
    let (is_told, report) = said(&mark(&folder, rows.replacen("1,2,speed of A,,", "1,2,speed of A,,5 = 2", 1), &[]));
    assert!(!is_told && report.contains("question 3: Nobody wrote anything"), "{report}");
    assert!(report.contains("question 2: None of its marks were won: is it too hard"), "{report}");
}

#[test]
fn a_code_for_more_than_one_student_says_that_all_have_its_numbers() {
    let folder = folder("one-code");
    let made = carom(&folder, &["sheet", "5C-2", "--seed", "3", "--format", "text", "--out", "one"]);
    assert!(made.status.success(), "{}", stderr(&made));
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("one/key.json")).unwrap()).unwrap();
    let code = key["code"].as_str().unwrap();
    for (rows, is_said) in [("Ada,1,3\nBen,1,4\n", true), ("Ada,1,3\n", false)] {
        fs::write(folder.join("rows.csv"), format!("student,question,answer\n{rows}")).unwrap();
        for (key, is_code) in [(code, true), ("one/key.json", false)] {
            let output = carom(&folder, &["mark", key, "rows.csv"]);
            assert!(output.status.success(), "{}", stderr(&output));
            let told = format!("all 2 students are marked on the numbers of the one sheet {code}");
            assert_eq!(stderr(&output).contains(&told), is_said && is_code, "{key}: {}", stderr(&output));
        }
    }
}

/// Names that want out of the folder, into the page, into the spreadsheet, or nowhere at all.
const NASTY: [&str; 14] = [
    "../../../etc/passwd",
    "..",
    ".",
    "/etc/passwd",
    "C:\\Windows\\system32",
    "CON",
    "\\input{/etc/passwd}\\end{document}",
    "<script>alert(1)</script>",
    "=HYPERLINK(\"http://example.org\")",
    "@SUM(A1)",
    "\u{202e}evil\u{2066}",
    "a\0b",
    "\u{feff}\u{200b}",
    "+1+cmd|' /C calc'!A0",
];

#[test]
fn no_name_leaves_the_folder_breaks_a_page_or_runs_in_a_spreadsheet() {
    let folder = folder("nasty");
    let long = "x".repeat(10_000);
    let names = NASTY.iter().copied().chain([long.as_str()]);
    let lines = names.map(|name| json!({"student": name, "question": 2, "blank": "speed of A", "answer": name}));
    let lines: String = lines.map(|line| format!("{line}\n")).collect();
    let output = mark(&folder, lines, &["--feedback", "html,latex,text", "--out", "deep/marks"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(!stderr(&output).contains(['\0', '\u{202e}']) && !stdout(&output).contains(['\0', '\u{202e}']));
    let pages: Vec<_> = fs::read_dir(folder.join("deep/marks/feedback")).unwrap().map(|entry| entry.unwrap()).collect();
    assert_eq!(pages.len(), 3 * (NASTY.len() + 1));
    for page in &pages {
        let name = page.file_name().into_string().unwrap();
        assert!(!name.starts_with('.') && name.matches('.').count() == 1 && name.len() < 100, "{name}");
        let text = fs::read_to_string(page.path()).unwrap();
        assert!(!text.contains(['\0', '\u{202e}']), "{name}");
        let forbidden: &[&str] = match name.rsplit_once('.').unwrap().1 {
            "html" => &["<script"],
            "tex" => &["\\input{/", "passwd}\\end{document}"],
            _ => &[],
        };
        assert!(!forbidden.iter().any(|words| text.contains(words)), "{name}");
        assert!(text.len() < 60_000, "{name} has {} bytes", text.len());
    }
    let mut entries: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    entries.sort();
    assert_eq!(entries, ["deep", "sheet", "submissions.csv"]);
    for row in table(folder.join("deep/marks/marks.csv")) {
        for cell in row {
            let is_formula = cell.starts_with(['=', '+', '-', '@', '\t', '\r']);
            assert!(!is_formula && !cell.contains(['\0', '\u{202e}', '\n']), "{cell}");
        }
    }
}

#[test]
fn a_cell_of_three_million_letters_stops_nothing() {
    let folder = folder("long");
    let long = "9+".repeat(1_500_000);
    let rows =
        format!("student,question,blank,answer,working\nAda,2,speed of A,{long},\"{long}\"\nBen,2,speed of A,2.78,\n");
    let output = mark(&folder, rows, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let found = marks(&folder, 0, 6);
    assert!(found[0].starts_with("Ada|2||speed of A|unreadable|0"), "{}", found[0]);
    assert!(found[4].starts_with("Ben|2||speed of A|correct|9"), "{}", found[4]);
    assert!(stdout(&output).len() < 5000 && stderr(&output).len() < 5000);
}

#[test]
fn a_numeral_keeps_its_sign_and_a_formula_does_not_run_in_what_was_not_marked() {
    let folder = folder("cells");
    let rows = "student,question,answer\nAda,2,1\nBen,99,-1.92\nCy,99,=1+1\nDee,99,-u/2\nEve,99,+3\n";
    mark(&folder, rows, &[]);
    let found = table(folder.join("marks/not-marked.csv"));
    let found: Vec<&str> = found.iter().skip(1).map(|row| row[6].as_str()).collect();
    assert_eq!(found, ["-1.92", "'=1+1", "'-u/2", "+3"]);
}

#[test]
fn a_json_array_is_read_whole_or_refused_at_its_place() {
    let folder = folder("json-array");
    let ada = r#"{"student": "Ada", "question": 2, "blank": "speed of A", "answer": "4√39/9"}"#;
    for (rows, place, message) in [
        (format!("[{ada}"), "submissions.csv:1:", "the list is not closed"),
        (format!("[{ada},\n"), "submissions.csv:1:", "the list is not closed"),
        (format!("[{ada}\n{ada}]"), "submissions.csv:2:1", "two answers without a comma between them"),
        (format!("[{ada},\n]"), "submissions.csv:1:", "a comma without an answer after it"),
        (format!("[{ada}]\n{ada}"), "submissions.csv:2:1", "something follows the list"),
        ("[{\"student\":\n  Ada}]".to_owned(), "submissions.csv:2:3", "this is no JSON: expected value"),
        (format!("[{ada},\n{{\"student"), "submissions.csv:2:", "the list is not closed"),
        ("[".repeat(100_000), "submissions.csv:1:", "this is no JSON: recursion limit exceeded"),
    ] {
        let output = mark(&folder, &rows, &[]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains(place) && said.contains(message) && said.contains("help: "), "{message}: {said}");
        assert!(!folder.join("marks").exists());
    }
    // Of what is JSON each answer that cannot be read is set aside by itself, with its line.
    let output = mark(&folder, format!("[\n{ada},\n7,\n{{\"question\": 2,\n\"answer\": \"1\"}}]"), &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let rows = table(folder.join("marks/not-marked.csv"));
    assert_eq!((&rows[1][0], &rows[2][0]), (&"3".to_owned(), &"4".to_owned()), "{rows:?}");
    let output = mark(&folder, "[]", &[]);
    assert!(stderr(&output).contains("`submissions.csv` has no answers"), "{}", stderr(&output));
}

#[test]
fn the_word_of_a_person_is_the_last_and_the_marks_that_depend_on_it_follow() {
    let folder = folder("overrides");
    // A right equation of momentum; nothing of restitution.
    let rows = "student,question,blank,answer,working\nAda,2,speed of A,1,\"4*4cos30 = 4v + 2w\"\n";
    let codes = |overrides: &str| {
        fs::write(folder.join("overrides.csv"), format!("student,question,part,mark,given,comment\n{overrides}"))
            .unwrap();
        let output = mark(&folder, rows, &["--overrides", "overrides.csv"]);
        assert!(output.status.success(), "{}", stderr(&output));
        let line = fs::read_to_string(folder.join("marks/marks.jsonl")).unwrap();
        let line: Json = serde_json::from_str(line.lines().next().unwrap()).unwrap();
        let awards = line["awards"].as_array().unwrap().clone();
        let given = awards.iter().filter(|award| award["given"] == true);
        (given.map(|award| award["id"].as_str().unwrap().to_owned()).collect::<Vec<_>>().join(" "), awards)
    };
    assert_eq!(codes("").0, "M1a A1a");
    assert_eq!(codes("Ada,2,,M1a,0,not all terms\n").0, "", "A1a falls with M1a");
    assert_eq!(codes("Ada,2,,M1a,0,\nAda,2,,A1a,1,\n").0, "A1a", "a person's word on A1a stands");
    assert_eq!(codes("Ada,2,,M1a,0,\nAda,2,,M1a,1,\n").0, "M1a A1a", "the last word counts");
    let (given, awards) = codes("Ada,2,,m1b,1,seen in the margin\nAda,2,,M1c,1,\n");
    assert_eq!(given, "M1a A1a M1b M1c");
    let award = awards.iter().find(|award| award["id"] == "M1b").unwrap();
    assert_eq!((&award["by"], &award["feedback"]), (&json!("person"), &json!("seen in the margin")));

    fs::write(folder.join("overrides.csv"), "student,question,part,mark,given\nBen,2,,M1a,1\n").unwrap();
    let output = mark(&folder, rows, &["--overrides", "overrides.csv"]);
    assert!(
        stderr(&output).contains("line 2 of `overrides.csv` is about question 2 of Ben, which was"),
        "{}",
        stderr(&output)
    );
    let wrong = "student,question,part,mark,given\nAda,2,,M9,1\nAda,2,,M1a,yes\nAda,2,x,M1a,1\n";
    fs::write(folder.join("overrides.csv"), wrong).unwrap();
    let output = mark(&folder, rows, &["--overrides", "overrides.csv", "--out", "refused"]);
    assert_eq!(output.status.code(), Some(1));
    for words in ["no mark `M9`", "overrides.csv:2:1", "`yes` is neither 1 nor 0", "has no part `x`"] {
        assert!(stderr(&output).contains(words), "{words}: {}", stderr(&output));
    }
    assert!(!folder.join("refused").exists());
}

#[test]
fn two_words_of_a_person_that_contradict_each_other_are_told_of() {
    let folder = folder("contradictions");
    let header = "student,question,part,mark,given,comment\n";
    for (words, said) in [
        ("Ada,2,,M1a,1,\nAda,Q2,,m1a,0,\n", Some("`words.csv` contradicts itself on lines 2 and 3, about a mark")),
        ("Ada,2,,M1a,0,\nBen,2,,M1a,1,\nAda,2,,M1a,0,\nAda,2,,M1a,1,\n", Some("on lines 2, 4 and 5, about")),
        ("Ada,2,,M1a,1,\nAda,2,,M1a,1,seen\nAda,2,,M1b,0,\nBen,2,,M1a,0,\n", None),
    ] {
        fs::write(folder.join("words.csv"), format!("{header}{words}")).unwrap();
        for (option, who) in [("--json", "question 2 of Ada"), ("--without-names", "question 2 of a student")] {
            let output = mark(&folder, format!("{ADA}Ben,2,,speed of A,1,\n"), &["--overrides", "words.csv", option]);
            let told = stderr(&output);
            assert!(output.status.success(), "{told}");
            assert_eq!(told.contains("contradicts itself"), said.is_some(), "{told}");
            assert!(
                said.is_none_or(|said| told.contains(said) && told.contains(who) && told.contains("help: ")),
                "{told}"
            );
        }
    }
}

#[test]
fn a_profile_is_a_name_or_a_file() {
    let folder = folder("profiles");
    let rows = ADA.replace("4√39/9", "2.8");
    let marks_with = |profile: &str| {
        let output = mark(&folder, &rows, &["--profile", profile]);
        assert!(output.status.success(), "{}", stderr(&output));
        marks(&folder, 4, 6)[0].clone()
    };
    assert_eq!(marks_with("carom"), "partial|8");
    assert_eq!(marks_with("edexcel"), "correct|9");
    fs::write(folder.join("mine.toml"), "figures = 2\n").unwrap();
    assert_eq!(marks_with("mine.toml"), "correct|9");
    fs::write(folder.join("mine.toml"), "figures = 3\ninaccuracy = \"allways\"\n").unwrap();
    for (profile, words) in [
        ("mine.toml", &["mine.toml:2:14", "did you mean `always`?"][..]),
        ("edexel", &["unknown profile `edexel`", "did you mean `edexcel`?"]),
        ("ib", &["there are `carom`"]),
    ] {
        let output = mark(&folder, &rows, &["--profile", profile]);
        assert_eq!(output.status.code(), Some(1));
        assert!(words.iter().all(|words| stderr(&output).contains(words)), "{}", stderr(&output));
    }
}

#[test]
fn a_summary_says_how_hard_it_was_and_what_to_look_at() {
    let folder = folder("summary");
    let rows = format!("{ADA}Ben,2,,speed of A,2.8,\nBen,2,,speed of B,who knows,\nBen,99,,,1,\n");
    let output = mark(&folder, rows, &["--json"]);
    let said: Json = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!((&said["students"], &said["marks"], &said["not_marked"]), (&json!(2), &json!(19), &json!(1)));
    assert_eq!((&said["mean"], &said["questions"][0]["facility"]), (&json!(9.5), &json!(86)));
    assert_eq!(
        said["questions"][0]["scheme"][0],
        json!({"part": "", "id": "B1a", "code": "B1", "won": 2, "facility": 100, "discrimination": null})
    );
    assert_eq!(said["look"].as_array().unwrap().len(), 1);
    assert_eq!((&said["look"][0]["student"], &said["look"][0]["typed"]), (&json!("Ben"), &json!("who knows")));
    let notes: Vec<&str> =
        said["notes"].as_array().unwrap().iter().map(|note| note["note"].as_str().unwrap()).collect();
    assert!(notes.contains(&"under-accurate") && notes.contains(&"cannot-be-read"), "{notes:?}");
}

#[test]
fn submissions_come_from_stdin_too() {
    let folder = folder("stdin");
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .current_dir(&folder)
        .args(["mark", "sheet/key.json", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(ADA.as_bytes()).unwrap();
    assert!(child.wait_with_output().unwrap().status.success());
    assert_eq!(marks(&folder, 5, 6), ["9", "1", "1", "0"]);
}

#[test]
fn results_appear_whole_or_not_at_all() {
    let folder = folder("all-or-none");
    fs::create_dir_all(folder.join("marks/marks.jsonl")).unwrap();
    let output = mark(&folder, ADA, &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("it is a folder"), "{}", stderr(&output));
    let left: Vec<_> = fs::read_dir(folder.join("marks")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["marks.jsonl"]);
}

#[test]
fn at_a_wall_no_file_speaks_of_two_spheres() {
    let folder = folder("wall");
    let made = carom(&folder, &["sheet", "walls/rebound-speed-and-direction", "--reference", "--format", "text"]);
    assert!(made.status.success(), "{}", stderr(&made));
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let blanks = key["questions"][0]["parts"][0]["blanks"].as_array().unwrap();
    let angle = blanks.iter().find(|blank| blank["name"] == "direction of A").unwrap();
    let angle: f64 = angle["decimal"].as_str().unwrap().parse().unwrap();
    let rows = format!(
        "student,question,part,blank,answer,working\nAda,1,a,direction of A,37° to the wall,\n\
         Bea,1,a,direction of A,{:.1}°,\n",
        90.0 - angle
    );
    fs::write(folder.join("answers.csv"), rows).unwrap();
    let output = carom(&folder, &["mark", "sheet/key.json", "answers.csv", "--feedback", "html,text"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let read = |name: &str| fs::read_to_string(folder.join("marks").join(name)).unwrap();
    let lines = read("marks.jsonl");
    assert!(lines.contains("\"reading\":\"37° to the wall\"") && lines.contains("\"complement\""), "{lines}");
    for name in ["marks.csv", "marks.jsonl", "feedback/ada.html", "feedback/bea.txt"] {
        let text = read(name);
        assert!(!text.contains("line of centres") && !text.contains("common tangent"), "{name}: {text}");
    }
}

#[test]
fn what_is_of_an_earlier_marking_is_told_of() {
    let folder = folder("earlier");
    mark(&folder, ADA.replace("Ada", "Ben") + "Ben,99,,,1,\n", &[]);
    let output = mark(&folder, ADA, &[]);
    let said = stderr(&output);
    assert!(said.contains("1 file in `marks/feedback` of an earlier marking: `ben.html`"), "{said}");
    assert!(said.contains("`marks/not-marked.csv` is of an earlier marking"), "{said}");
}

#[test]
fn a_marking_writes_over_nothing_that_somebody_else_wrote() {
    let folder = folder("not-ours");
    fs::create_dir_all(folder.join("marks")).unwrap();
    for name in ["report.html", "marks.csv"] {
        fs::write(folder.join("marks").join(name), "my own").unwrap();
        let output = mark(&folder, ADA, &[]);
        assert_eq!(output.status.code(), Some(1));
        let said = stderr(&output);
        assert!(said.contains(&format!("`marks/{name}` would be written over")) && said.contains("help: "), "{said}");
        assert_eq!(fs::read_to_string(folder.join("marks").join(name)).unwrap(), "my own");
        fs::remove_file(folder.join("marks").join(name)).unwrap();
    }
}

#[test]
fn a_sheet_leaves_answers_alone_that_somebody_has_written_down() {
    let folder = folder("kept");
    let again = || carom(&folder, &["sheet", "--reference", "--format", "text", "--out", "sheet"]);
    let path = folder.join("sheet/submissions.csv");
    assert!(!stderr(&again()).contains("left as it is"), "an empty one is written anew");
    fs::write(&path, ADA).unwrap();
    let output = again();
    assert!(output.status.success() && stderr(&output).contains("has answers in it, and is left as it is"));
    assert_eq!(fs::read_to_string(&path).unwrap(), ADA);
}

#[test]
fn a_line_of_marks_has_the_fields_of_its_schema() {
    let folder = folder("schema");
    mark(&folder, format!("{ADA}Ben,2,,speed of A,2.8,4*4cos30 = 4v + 2w\n"), &[]);
    let page = |path: &str| fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
    let schema: Json = serde_json::from_str(&page("docs/schema/marks.schema.json")).unwrap();
    let fields = |json: &Json| json.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    let documented = page("docs/exchange-formats.md");
    let mut seen = 0;
    let mut holds = |json: &Json, schema: &Json| {
        assert_eq!(fields(json), fields(&schema["properties"]));
        assert_eq!(json!(fields(json)), schema["required"]);
        for name in fields(json) {
            assert!(documented.contains(&format!("`{name}`")), "docs/exchange-formats.md does not explain `{name}`");
        }
        seen += 1;
    };
    for line in fs::read_to_string(folder.join("marks/marks.jsonl")).unwrap().lines() {
        let line: Json = serde_json::from_str(line).unwrap();
        holds(&line, &schema);
        for (list, name) in [("answers", "answer"), ("lines", "line"), ("awards", "award"), ("followed", "followed")] {
            line[list].as_array().unwrap().iter().for_each(|one| holds(one, &schema["$defs"][name]));
        }
        for award in line["awards"].as_array().unwrap().iter().filter(|award| !award["evidence"].is_null()) {
            holds(&award["evidence"], &schema["$defs"]["evidence"]);
        }
    }
    assert!(seen > 20, "{seen} things were seen");
}
