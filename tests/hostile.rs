//! Files that are not what they should be, wherever one may stand: a class list, submissions, a key, a folder. Each is refused
//! in words that say what was found, and nothing is written.
//!
//! What stands in rows and names is in `class.rs`, `mark.rs`, `mark_stream` and `report.rs`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value as Json;

fn carom(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).current_dir(folder).args(arguments).output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

const ROWS: &str = "student,question,blank,answer\nAda,2,speed of A,2.78\n";

/// An empty folder of this test's own, with the sheet of the reference exercises and something that was handed in.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("hostile-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let made = carom(&folder, &["sheet", "--reference", "--format", "text", "--out", "sheet"]);
    assert!(made.status.success(), "{}", stderr(&made));
    fs::write(folder.join("rows.csv"), ROWS).unwrap();
    fs::write(folder.join("class.csv"), "student\nAda\n").unwrap();
    folder
}

/// Everything below a folder.
fn tree(folder: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            all.extend(tree(&entry));
        }
        all.push(entry);
    }
    all.sort();
    all
}

/// A command that is refused with these words and leaves everything as it was.
fn refused(folder: &Path, arguments: &[&str], words: &[&str]) {
    let before = tree(folder);
    let output = carom(folder, arguments);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    words.iter().for_each(|words| assert!(said.contains(words), "{arguments:?}: {words} in\n{said}"));
    assert!(said.len() < 2000 && !said.contains(['\0', '\u{202e}']), "{said}");
    assert_eq!(tree(folder), before, "{arguments:?}");
}

const MARK: [&str; 3] = ["mark", "sheet/key.json", "rows.csv"];

#[test]
fn a_folder_in_place_of_a_file_is_named() {
    let folder = folder("folders");
    fs::create_dir(folder.join("empty")).unwrap();
    let words = ["`empty` cannot be read: it is a folder\nhelp: give the file in it"];
    refused(&folder, &["mark", "empty", "rows.csv"], &words);
    refused(&folder, &["mark", "sheet/key.json", "empty"], &words);
    refused(&folder, &["mark", "sheet/key.json", "empty", "--stream"], &["`empty` cannot be read"]);
    refused(&folder, &["mark", "sheet/key.json", "rows.csv", "--overrides", "empty"], &words);
    refused(&folder, &["sheet", "--class", "empty"], &words);
    refused(&folder, &["solve", "empty"], &words);
    // In the folder of a sheet each has its file.
    refused(&folder, &["mark", "sheet", "rows.csv"], &["it is a folder\nhelp: did you mean `sheet/key.json`?"]);
    refused(&folder, &["mark", "sheet/key.json", "sheet"], &["help: did you mean `sheet/submissions.csv`?"]);
    refused(&folder, &["solve", "sheet"], &["it is a folder\nhelp: give the file in it"]);
    for command in ["sheet", "explain", "preview"] {
        refused(&folder, &[command, "sheet"], &["unknown question `sheet`\nhelp: that is a folder"]);
        refused(&folder, &[command, "rows.csv"], &["unknown question `rows.csv`\nhelp: that is a file"]);
    }
    refused(&folder, &["sheet", "5C-2,5C-3"], &["help: write spaces between questions: `5C-2 5C-3`"]);
    // And a file in place of a folder.
    refused(
        &folder,
        &["new-bank", "rows.csv/bank"],
        &["`rows.csv` is a file, and `rows.csv/bank` cannot be made in it"],
    );
    refused(&folder, &["check", "rows.csv"], &["a bank is a folder", "help: name the folder in which it is\n"]);
}

#[test]
fn what_is_wrong_with_a_whole_file_is_said_with_one_thing_to_try() {
    let folder = folder("whole");
    let key = fs::read_to_string(folder.join("sheet/key.json")).unwrap();
    let half = &key[..key.floor_char_boundary(key.len() / 2)];
    let mark: &[&str] = &["mark", "bad", "rows.csv"];
    let handed_in: &[&str] = &["mark", "sheet/key.json", "bad"];
    let class: &[&str] = &["sheet", "--class", "bad"];
    let solve: &[&str] = &["solve", "bad"];
    for (command, text, said, help) in [
        (mark, half, "this is no key: it ends too early", "copy the file again, whole"),
        (mark, "", "this is no key: nothing stands in `bad`", "`carom sheet` writes"),
        (mark, r#"{"questions": 3}"#, "it has the number `3`, expected a list", "takes the key first"),
        (mark, r#"{"questions": [{"number": -1}]}"#, "`-1`, expected a whole number", "takes the key first"),
        (mark, r#"{"name": "another", "version": 3}"#, "a key has `questions`", "takes the key first"),
        (handed_in, "Ada,2,2.78\n", "no columns `student`, `question`, `answer`", "in the first line, above the rows"),
        (handed_in, "student,answer\nAda,1\n", "no column `question`", "write `question` in the first line"),
        (handed_in, "student,questoin,answer\n", "no column `question`", "write `question` for `questoin`"),
        (handed_in, "student,question,answer,answer\n", "two columns `answer`", "give one of them another name"),
        (handed_in, "student | question | answer\n", "no columns `student`", "in the first line, above the rows"),
        (handed_in, &key, "nothing in `bad` could be marked", "is this the key of that sheet?"),
        (handed_in, "PK\u{3}\u{4}", "`bad` is a workbook of a spreadsheet program", "`CSV UTF-8`"),
        (handed_in, "%PDF-1.7", "`bad` is a PDF, and no text", "save it as UTF-8"),
        (class, "student\nAda\nAda\n", "`Ada` is in the list twice", "each student has one"),
        (class, "student\n", "nobody is in this class", "a number or a name for each"),
        (class, &key, "no column `student`", "write `student` in the first line"),
        (solve, "{\"masses\": {", "this is no JSON: it ends too early", "`carom solve --help` shows a scene"),
        (solve, &key, "unknown field `carom`", "`carom solve --help` shows a scene"),
        (solve, "§ 1", "cannot be read from here on", "`carom solve --help` shows a scene"),
    ] {
        fs::write(folder.join("bad"), text).unwrap();
        refused(&folder, command, &[said, "help: ", help]);
    }
    // What is typed is repeated without what commands a terminal.
    for arguments in
        [&["explain", "\u{1b}[31mred"][..], &["sheet", "--topic", "\u{1b}[31mred"], &["solve", "\u{1b}[31mred"]]
    {
        let output = carom(&folder, arguments);
        assert!(stderr(&output).contains("`[31mred`"), "{}", stderr(&output));
    }
    refused(&folder, &["mark", "-", "-"], &["cannot both come from stdin", "help: "]);
    refused(&folder, &["preview", "none.toml"], &["`none.toml` cannot be read: there is no such file"]);
    let words = "student,question,mark,given,comment\n";
    for (text, said) in [
        (format!("{words}Ada,2,M9,1,\n"), "no mark `M9`"),
        (words.replace("comment", "coment") + "Ada,2,M1a,1,x\n", "error: nobody looks at the column `coment`"),
    ] {
        fs::write(folder.join("words.csv"), text).unwrap();
        refused(&folder, &[&MARK[..], &["--overrides", "words.csv"]].concat(), &[said, "help: "]);
    }
}

#[test]
fn an_output_folder_that_cannot_be_is_named_and_what_stands_in_its_place_is_kept() {
    let folder = folder("output");
    fs::write(folder.join("file"), "mine").unwrap();
    let study = ["study", "--quick", "--out"];
    let sheet = ["sheet", "5C-2", "--format", "text", "--out"];
    let of_class = ["sheet", "5C-2", "--class", "class.csv", "--out"];
    let mark = [&MARK[..], &["--out"]].concat();
    let stream = [&MARK[..], &["--stream", "--out"]].concat();
    for command in [&["man", "--out"][..], &study, &sheet, &of_class, &mark, &stream] {
        for (out, file) in [("file", "file"), ("file/below", "file"), ("rows.csv/marks", "rows.csv")] {
            let said =
                format!("error: the folder `{out}` cannot be made: `{file}` is a file\nhelp: name another folder");
            refused(&folder, &[command, &[out]].concat(), &[&said]);
        }
        let (long, below) = ("x".repeat(300), format!("new/{}", "x".repeat(300)));
        for out in [&long, &below] {
            refused(
                &folder,
                &[command, &[out]].concat(),
                &["cannot be made: the name is too long, or no name", "help: "],
            );
        }
        if cfg!(target_os = "linux") {
            refused(&folder, &[command, &["/proc/new/sheet"]].concat(), &["cannot be made: nothing can be made there"]);
        }
    }
    assert_eq!(fs::read_to_string(folder.join("file")).unwrap(), "mine");
    // A folder where one of the files is to be: none of the others is written either.
    fs::create_dir_all(folder.join("marks/report.html")).unwrap();
    refused(&folder, &MARK, &["`marks/report.html` cannot be written: it is a folder"]);
    fs::create_dir_all(folder.join("other")).unwrap();
    fs::write(folder.join("other/feedback"), "mine").unwrap();
    refused(&folder, &[&MARK[..], &["--out", "other"]].concat(), &["`other/feedback` is a file"]);
}

#[test]
fn where_one_may_not_write_or_the_disk_is_full_it_is_said_and_no_folder_is_left() {
    let folder = folder("may-not");
    let sheet = ["sheet", "5C-2", "--format", "text", "--out"];
    // The page of a preview goes into a file that is named.
    for (out, said) in [("/", "`/` is not the name of a file"), ("rows.csv/page.html", "is a file")] {
        refused(&folder, &["preview", "5C-2", "--open", "--out", out], &[said, "help: "]);
    }
    refused(&folder, &["new-question", "rows.csv/new.toml"], &["`rows.csv` is a file and no folder", "help: "]);
    let preview = ["preview", "5C-2", "--open"];
    let output = Command::new(env!("CARGO_BIN_EXE_carom")).args(preview).env("TMPDIR", "/no/such").output();
    let said = stderr(&output.unwrap());
    assert!(cfg!(windows) || said.contains("in `/no/such`: nothing can be made there\nhelp: name a folder"), "{said}");
    // Whoever is root may write anywhere, but not here.
    #[cfg(target_os = "linux")]
    {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        for arguments in [
            &["list"][..],
            &["schema", "key"],
            &["explain", "5C-2"],
            &["completions", "bash"],
            &["--help"],
            &["mark", "-h"],
        ] {
            let command = Command::new(env!("CARGO_BIN_EXE_carom"))
                .args(arguments)
                .stdout(full.try_clone().unwrap())
                .stderr(std::process::Stdio::piped())
                .output()
                .unwrap();
            let said = stderr(&command);
            assert_eq!(command.status.code(), Some(1), "{said}");
            assert!(said.contains("what is printed cannot be written: the disk is full\nhelp: "), "{said}");
        }
        let stdin = fs::File::open(&folder).unwrap();
        let command = [&MARK[..2], &["-", "--stream"]].concat();
        let output = Command::new(env!("CARGO_BIN_EXE_carom")).current_dir(&folder).args(command).stdin(stdin).output();
        assert!(stderr(&output.unwrap()).contains("cannot be read: it is a folder\nhelp: "));
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let closed = folder.join("closed");
        fs::create_dir(&closed).unwrap();
        fs::set_permissions(&closed, fs::Permissions::from_mode(0o555)).unwrap();
        let is_root = fs::write(closed.join("probe"), "").is_ok();
        if !is_root {
            for out in ["closed", "closed/new/sheet"] {
                refused(
                    &folder,
                    &[&sheet[..], &[out]].concat(),
                    &["you may not write there", "help: name another folder"],
                );
            }
        }
        fs::set_permissions(&closed, fs::Permissions::from_mode(0o755)).unwrap();
    }
}

#[test]
fn a_key_is_read_in_utf_8_with_a_mark_or_without_and_in_nothing_else() {
    let folder = folder("encodings");
    let key = fs::read_to_string(folder.join("sheet/key.json")).unwrap();
    let utf_16: Vec<u8> = key.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let latin_1: Vec<u8> = key.replace("Carom", "C").bytes().chain(*b"\xeb").collect();
    let cases: [(&[u8], &[&str]); 7] = [
        (&utf_16, &["`bad.json` is in UTF-16"]),
        (&latin_1, &["`bad.json` is not in UTF-8"]),
        (b"", &["this is no key", "bad.json"]),
        (b"\0\0\0\0", &["bad.json"]),
        (b"null", &["this is no key"]),
        (b"[[[[[[[[", &["this is no key"]),
        (ROWS.as_bytes(), &["this is no key", "takes the key first"]),
    ];
    for (bytes, words) in cases {
        fs::write(folder.join("bad.json"), bytes).unwrap();
        refused(&folder, &["mark", "bad.json", "rows.csv"], words);
    }
    fs::write(folder.join("bad.json"), "[".repeat(100_000)).unwrap();
    refused(&folder, &["mark", "bad.json", "rows.csv"], &["this is no key"]);
    fs::write(folder.join("bom.json"), format!("\u{feff}{key}")).unwrap();
    assert!(carom(&folder, &["mark", "bom.json", "rows.csv"]).status.success());
}

#[test]
fn what_is_no_text_and_what_is_no_file_is_said_to_be_so() {
    let folder = folder("no-text");
    fs::write(folder.join("picture"), b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\xff\xfe\x01").unwrap();
    let said = ["`picture` is no text: it has bytes that stand in none", "give the file that you mean"];
    refused(&folder, &["mark", "picture", "rows.csv"], &said);
    refused(&folder, &["mark", "sheet/key.json", "picture"], &said);
    let said = [
        "there is no file `nofile`, and if it is the code of a sheet, a character of the code is mistyped",
        "give the `key.json` beside the sheets",
    ];
    refused(&folder, &["mark", "nofile", "rows.csv"], &said);
    fs::create_dir_all(folder.join("bank")).unwrap();
    fs::write(folder.join("bank/empty.toml"), "").unwrap();
    let output = carom(&folder, &["sheet", "--bank", "bank", "--seed", "1", "--out", "none"]);
    assert_eq!(stderr(&output).matches("nothing stands in this file").count(), 1, "{}", stderr(&output));
    fs::create_dir_all(folder.join("templates")).unwrap();
    let sheet = ["sheet", "5C-2", "--seed", "1", "--templates", "templates", "--out", "none"];
    refused(&folder, &sheet, &["no templates in `templates`", "`templates/html/style.css`"]);
    assert!(!folder.join("none").exists());
}

#[test]
fn a_key_of_another_version_is_refused_if_it_is_later_and_explained_if_it_cannot_be_read() {
    let folder = folder("version");
    let key = fs::read_to_string(folder.join("sheet/key.json")).unwrap();
    let own = env!("CARGO_PKG_VERSION");
    let mut json: Json = serde_json::from_str(&key).unwrap();
    json["carom"] = "999.3.0".into();
    json["code"] = "5RXM-M7TX-G".into();
    let write = |json: &Json| fs::write(folder.join("key.json"), json.to_string()).unwrap();
    write(&json);
    let said = format!("this key was written by carom 999.3.0, and this is carom {own}");
    let mark = ["mark", "key.json", "rows.csv"];
    refused(&folder, &mark, &[&said, "key.json:", "get carom 999.3.0, or", "`carom mark 5RXM-M7TX-G SUBMISSIONS`"]);
    json["code"] = "".into();
    write(&json);
    refused(&folder, &mark, &[&said, "`lock.json`"]);
    // An earlier one is read as far as it can be.
    json["carom"] = "0.0.1".into();
    json["questions"][0]["parts"][0]["blanks"][0]["kind"] = "numbre".into();
    write(&json);
    refused(
        &folder,
        &mark,
        &["was written by carom 0.0.1", "mark with carom 0.0.1", "unknown kind of answer `numbre`"],
    );
    json["questions"][0]["parts"][0]["blanks"][0]["kind"] = "number".into();
    write(&json);
    let output = carom(&folder, &mark);
    assert!(output.status.success(), "{}", stderr(&output));
}

#[test]
fn a_key_with_two_papers_for_one_student_is_refused() {
    let folder = folder("two-papers");
    let made = carom(&folder, &["sheet", "5C-2", "--class", "class.csv", "--format", "text", "--out", "class"]);
    assert!(made.status.success(), "{}", stderr(&made));
    let mut key: Json = serde_json::from_str(&fs::read_to_string(folder.join("class/key.json")).unwrap()).unwrap();
    let again = key["papers"][0].clone();
    key["papers"].as_array_mut().unwrap().push(again);
    fs::write(folder.join("key.json"), key.to_string()).unwrap();
    let words = ["`papers[1].student`: there is another paper for the same student"];
    refused(&folder, &["mark", "key.json", "rows.csv"], &words);
}

#[test]
fn names_that_a_student_cannot_be_told_by_are_one_student_in_a_class_list() {
    let folder = folder("names");
    for list in
        ["student\nAda\n\"\tAda\"\n", "student\nAda\nA\0da\n", "student\nAda\n\u{200f}Ada\n", "student\n=1\n'=1\n"]
    {
        fs::write(folder.join("list.csv"), list).unwrap();
        refused(&folder, &["sheet", "5C-2", "--class", "list.csv"], &["is in the list twice", "list.csv:3"]);
    }
}

#[test]
fn what_a_key_calls_its_questions_is_harmless_too() {
    let folder = folder("ids");
    let key: Json = serde_json::from_str(&fs::read_to_string(folder.join("sheet/key.json")).unwrap()).unwrap();
    let nasty = format!("=<script>\u{202e}\0{}", "x".repeat(10_000));
    // Two sheets with the question under different numbers, so that it goes by its id.
    let paper = |student: &str, number: usize| {
        let mut question = key["questions"][1].clone();
        question["id"] = nasty.as_str().into();
        question["mirrors"] = nasty.as_str().into();
        question["number"] = number.into();
        serde_json::json!({"student": student, "name": nasty, "code": nasty, "questions": [question]})
    };
    let class = serde_json::json!({"papers": [paper("Ada", 1), paper("Ben", 2)]});
    fs::write(folder.join("sheet/key.json"), class.to_string()).unwrap();
    fs::write(folder.join("rows.csv"), "student,question,blank,answer\nAda,1,speed of A,2.8\nBen,2,speed of A,1\n")
        .unwrap();
    let output = carom(&folder, &MARK);
    let said = String::from_utf8(output.stdout.clone()).unwrap() + &stderr(&output);
    assert!(output.status.success(), "{said}");
    let printed = String::from_utf8(output.stdout).unwrap();
    assert!(printed.lines().all(|line| line.chars().count() <= 80) && !said.contains(['\0', '\u{202e}']), "{said}");
    for file in tree(&folder.join("marks")).iter().filter(|path| path.is_file()) {
        let text = fs::read_to_string(file).unwrap();
        // Lines of JSON have everything as it was typed, each character that is no letter as a number.
        if file.extension().is_some_and(|ending| ending == "jsonl") {
            continue;
        }
        assert!(
            !text.contains(['\0', '\u{202e}']) && !text.contains("\n=") && !text.contains(",="),
            "{}",
            file.display()
        );
        assert!(
            file.extension().is_some_and(|ending| ending == "csv") || !text.contains("<script"),
            "{}",
            file.display()
        );
    }
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_nowhere_or_to_what_has_no_end_stops_nothing() {
    use std::os::unix::fs::symlink;
    let folder = folder("links");
    symlink("round", folder.join("round")).unwrap();
    symlink("nowhere", folder.join("lost")).unwrap();
    for link in ["round", "lost"] {
        refused(&folder, &["solve", link], &["is a link that leads to no file", "give the file itself"]);
        refused(&folder, &["mark", "sheet/key.json", link], &["is a link that leads to no file"]);
        refused(
            &folder,
            &["sheet", "--count", "1", "--seed", "1", "--out", link],
            &["is a link that leads nowhere", "take the link away"],
        );
    }
    // What is read of an earlier sheet might be a device.
    fs::create_dir(folder.join("endless")).unwrap();
    symlink("/dev/zero", folder.join("endless/key.json")).unwrap();
    symlink("/dev/zero", folder.join("endless/submissions.csv")).unwrap();
    let made = carom(&folder, &["sheet", "--count", "1", "--seed", "1", "--format", "text", "--out", "endless"]);
    assert!(made.status.success(), "{}", stderr(&made));
    assert!(fs::read_to_string(folder.join("endless/key.json")).unwrap().starts_with('{'));
}

#[test]
fn what_was_typed_is_repeated_in_brief() {
    let folder = folder("brief");
    let long = "9".repeat(3000);
    for (name, scene) in [
        ("text", format!("{{\"masses\": \"{}\"}}", "a".repeat(9000))),
        ("name", format!("{{\"{}\": 1}}", "a".repeat(9000))),
        (
            "apart",
            format!(
                "{{\"masses\": {{\"A\": \"1\", \"B\": \"1\"}}, \"before\": {{\"A\": [\"-{long}\", \"0\"], \"B\": [\"0\", \"0\"]}}, \
                 \"line_of_centres\": [\"1\", \"0\"], \"sense\": \"A_to_B\", \"e\": \"1\"}}"
            ),
        ),
    ] {
        fs::write(folder.join("long.json"), scene).unwrap();
        let output = carom(&folder, &["solve", "long.json"]);
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert!(stderr(&output).len() < 2500, "{name}: {}", stderr(&output));
    }
}

#[cfg(unix)]
#[test]
fn a_question_file_has_a_name_that_can_be_printed() {
    let folder = folder("names");
    fs::create_dir(folder.join("bank")).unwrap();
    fs::write(folder.join("bank/two\nlines.toml"), "").unwrap();
    let said = stderr(&carom(&folder, &["check", "bank"]));
    assert!(said.contains("`bank/twolines.toml` has signs in it that cannot be printed"), "{said}");
    let device = stderr(&carom(&folder, &["check", "/dev/null"]));
    assert!(device.contains("`/dev/null` is a file, and a bank is a folder"), "{device}");
}
