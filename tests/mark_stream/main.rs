//! `carom mark --stream`: the marks that `carom mark` gives, row by row, whatever comes down the pipe; and into a folder,
//! whatever ends the run.

#[cfg(target_os = "linux")] // It says in a file how much memory a process has had.
mod memory;
#[cfg(unix)] // Its commands are for a shell.
mod page;
mod resume;
mod spark;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

use serde_json::Value as Json;

fn begin(folder: &Path, arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.current_dir(folder).args(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

fn carom(folder: &Path, arguments: &[&str], input: &[u8]) -> Output {
    let mut child = begin(folder, arguments);
    let mut stdin = child.stdin.take().unwrap();
    // What comes out must be read while this is written, and a program that refuses its input may close it.
    let input = input.to_vec();
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    output
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// An empty folder of this test's own, with the sheet of the reference exercises in `sheet`.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("stream-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let made = carom(&folder, &["sheet", "--reference", "--format", "text", "--out", "sheet"], b"");
    assert!(made.status.success());
    folder
}

const STREAM: [&str; 4] = ["mark", "sheet/key.json", "-", "--stream"];

/// So many students with rows of every kind: right, wrong, unreadable, empty, with working, with a line break in a cell.
fn table(students: usize) -> String {
    let mut table = "student,question,part,blank,answer,working\n".to_owned();
    for student in 0..students {
        table.push_str(&format!(
            "\"S, {student}\",2,,speed of A,4√39/9,\"v = 4sin30 = 2\n4*4cos30 = 4v + 2w\"\n\
             \"S, {student}\",2,,direction of A,{}.1°,\n\"S, {student}\",1,,,over there \"\"x\"\",\n\
             \"S, {student}\",2,,speed of B,,\n",
            40 + student % 10
        ));
    }
    table
}

#[test]
fn a_stream_earns_the_same_marks_as_a_file_in_the_same_order() {
    let folder = folder("same");
    // Several pieces, the last of them short.
    let table = table(2500);
    assert!(table.len() > 1 << 18);
    fs::write(folder.join("table.csv"), &table).unwrap();
    let whole = carom(&folder, &["mark", "sheet/key.json", "table.csv", "--feedback", "none"], b"");
    assert!(whole.status.success(), "{}", text(&whole.stderr));
    let piped = carom(&folder, &STREAM, table.as_bytes());
    assert!(piped.status.success() && piped.stderr.is_empty(), "{}", text(&piped.stderr));
    let marks = fs::read(folder.join("marks/marks.csv")).unwrap();
    assert!(piped.stdout == marks, "{} and {}", piped.stdout.len(), marks.len());
    let from_file = carom(&folder, &["mark", "sheet/key.json", "table.csv", "--stream"], b"");
    assert!(from_file.stdout == marks);
    // Nothing more is written beside.
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
}

#[test]
fn json_lines_come_out_as_json_lines() {
    let folder = folder("json");
    let row = |student: usize, question: usize, answer: &str| {
        let row = serde_json::json!({"student": format!("S{student}"), "question": question, "answer": answer, "blank": "speed of A"});
        format!("{row}\n")
    };
    let lines: String = (0..50).map(|student| row(student, 2, "2.78") + &row(student, 5, "3")).collect();
    let lines = format!("\n{lines}");
    fs::write(folder.join("lines.jsonl"), &lines).unwrap();
    let whole = carom(&folder, &["mark", "sheet/key.json", "lines.jsonl", "--feedback", "none"], b"");
    assert!(whole.status.success(), "{}", text(&whole.stderr));
    let piped = carom(&folder, &STREAM, lines.as_bytes());
    assert_eq!(text(&piped.stdout), fs::read_to_string(folder.join("marks/marks.jsonl")).unwrap());
}

#[test]
fn what_is_broken_is_told_of_in_its_place_and_the_rest_is_marked() {
    let folder = folder("broken");
    let head = "student,question,part,blank,answer\n";
    let long = "x".repeat((1 << 20) + 1);
    let rows: [&[u8]; 9] = [
        b"Ada,2,,speed of A,2.78\n",
        b"Ada,99,,speed of A,2.78\n",
        b"Zo\xeb,2,,speed of A,2.78\n",
        b"\n",
        b"Ben,2,,speed of A,2.78\n",
        b"Ada,2,,speed of B,3.08\n",
        long.as_bytes(),
        b"\n",
        b"Cleo,2,,speed of A,2.78,and,more\n",
    ];
    let input = [head.as_bytes(), &rows.concat()].concat();
    let output = carom(&folder, &STREAM, &input);
    assert!(output.status.success());
    assert!(text(&output.stderr).contains("stdin: 5 rows set aside"), "{}", text(&output.stderr));
    let mut reader = csv::Reader::from_reader(&output.stdout[..]);
    let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let aside: Vec<String> =
        records.iter().filter(|r| &r[4] == "not-marked").map(|r| r[9].chars().take(40).collect()).collect();
    for start in [
        "line 3: no question `99`",
        "line 4: this is not in UTF-8",
        "line 7: other students",
        "line 8: this is longer",
        "line 9: 7 cells under 5",
    ] {
        assert!(aside.iter().any(|said| said.starts_with(start)), "{start} in {aside:?}");
    }
    let marked: Vec<&str> = records.iter().filter(|r| &r[4] == "correct").map(|r| r.get(0).unwrap()).collect();
    assert_eq!(marked, ["Ada", "Ben"]);
    // In JSON lines too, the row with it.
    let lines = b"{\"student\": \"Ada\", \"question\": 2, \"answer\": 3}\nno json\n";
    let output = carom(&folder, &STREAM, lines);
    let said: Vec<Json> = text(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((&said[0]["line"], &said[1]["line"], &said[1]["answer"]), (&1.into(), &2.into(), &"no json".into()));
}

#[test]
fn a_stream_that_is_wrong_as_a_whole_is_refused() {
    let folder = folder("wrong");
    let utf_16: Vec<u8> = "student,question,answer\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let returns = "student,question,answer\r".to_owned() + &"Ada,2,2.78\r".repeat(9);
    let long = "student,question,answer\r".to_owned() + &"Ada,2,2.78\r".repeat(1 << 17);
    for (input, said) in [
        (&b"student,answer\nAda,1\n"[..], "no column `question`"),
        (&utf_16, "UTF-16"),
        (returns.as_bytes(), "carriage returns alone"),
        (long.as_bytes(), "carriage returns alone"),
        (b"[{\"student\": \"Ada\", \"question\": 2, \"answer\": \"1\"}]\n", "a JSON array in place of JSON lines"),
        (b"[\n{\"student\": \"Ada\"}\n]\n", "mark it without `--stream`"),
    ] {
        let output = carom(&folder, &STREAM, input);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(text(&output.stderr).contains(said), "{}", text(&output.stderr));
    }
    // Nothing in, nothing out: what runs many filters gives some of them nothing. Of a file it is hardly meant.
    for (input, printed) in [("", ""), ("student,question,answer\n", "student,question,part,blank,verdict")] {
        let output = carom(&folder, &STREAM, input.as_bytes());
        assert!(output.status.success() && text(&output.stdout).starts_with(printed));
        assert!(text(&output.stderr).contains("warning: stdin has no answers"));
        fs::write(folder.join("empty.csv"), input).unwrap();
        let output = carom(&folder, &["mark", "sheet/key.json", "empty.csv", "--stream"], b"");
        assert_eq!(output.status.code(), Some(1));
    }
    // It makes no pages.
    for option in [["--overrides", "x.csv"], ["--feedback", "html"], ["--templates", "own"]] {
        let both = carom(&folder, &[&["mark", "sheet/key.json", "-", "--stream"], &option[..]].concat(), b"");
        assert_eq!(both.status.code(), Some(2), "{option:?}");
    }
}

#[test]
fn what_was_hardly_meant_and_what_is_of_an_earlier_marking_is_told_of() {
    let folder = folder("told");
    let table = "student,question,blank,answer,workings\nAda,2,speed of A,2.78,\nBen,99,,1,\n";
    fs::write(folder.join("table.csv"), table).unwrap();
    assert!(carom(&folder, &["mark", "sheet/key.json", "table.csv"], b"").status.success());
    let output = carom(&folder, &["mark", "sheet/key.json", "-", "--stream", "--out", "marks"], table.as_bytes());
    let said = text(&output.stderr);
    assert!(output.status.success());
    assert_eq!(said.matches("nobody looks at the column `workings`").count(), 1, "{said}");
    for old in ["marks.jsonl", "not-marked.csv", "report.html", "report.csv", "report-marks.csv", "report-mistakes.csv"]
    {
        let old = Path::new("marks").join(old);
        assert!(said.contains(&format!("`{}` is of an earlier marking", old.display())), "{said}");
    }
    assert!(said.contains("1 file in `marks"), "{said}");
    let new = Path::new("marks").join("marks.csv");
    assert!(!said.contains(&format!("`{}` is of", new.display())), "{said}");
}
