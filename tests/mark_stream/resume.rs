//! A run into a folder that something ends, at whatever moment, and the run that goes on.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Child, Output};
use std::thread;
use std::time::{Duration, Instant};

use super::{begin, carom, folder, text};

const INTO: [&str; 6] = ["mark", "sheet/key.json", "-", "--stream", "--out", "marks"];

/// What is read at a time, about.
const BLOCK: usize = 1 << 15;

/// So many students, with a column that nobody looks at to make the rows long; one row in ten is broken.
fn padded(students: usize) -> String {
    let pad = "x".repeat(900);
    let mut table = "student,question,blank,answer,notes\n".to_owned();
    for student in 0..students {
        let angle = 40 + student % 10;
        let question = if student % 10 == 3 { 99 } else { 2 };
        table.push_str(&format!("S{student},2,speed of A,2.7{},{pad}\n", student % 9));
        table.push_str(&format!("S{student},{question},direction of A,{angle}.1°,{pad}\n"));
    }
    table
}

/// The marks of a run that nothing ends.
fn uninterrupted(folder: &Path, table: &str) -> Vec<u8> {
    let output = carom(folder, &["mark", "sheet/key.json", "-", "--stream"], table.as_bytes());
    assert!(output.status.success(), "{}", text(&output.stderr));
    output.stdout
}

fn journal(folder: &Path) -> Vec<u8> {
    fs::read(folder.join("marks/unfinished/journal")).unwrap_or_default()
}

/// How many blocks are whole.
fn blocks(folder: &Path) -> usize {
    journal(folder).iter().filter(|byte| **byte == b'\n').count().saturating_sub(1)
}

/// Waits for something that a run does; it does it sooner or later, or ends.
fn wait_until(child: &mut Child, what: impl Fn() -> bool) {
    let start = Instant::now();
    while !what() && child.try_wait().unwrap().is_none() {
        assert!(start.elapsed() < Duration::from_secs(300), "it takes for ever");
        thread::sleep(Duration::from_millis(1));
    }
}

/// Starts a run, lets it have so much of the input, waits until so many blocks are whole, and kills it.
fn kill_after(folder: &Path, table: &str, bytes: usize, whole: usize) {
    let mut child = begin(folder, &INTO);
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(&table.as_bytes()[..bytes]).unwrap();
    wait_until(&mut child, || blocks(folder) >= whole);
    // On every system but Windows this is a signal that cannot be caught.
    child.kill().unwrap();
    child.wait().unwrap();
}

/// What has been marked stands in its place and nothing else is left.
fn is_finished(folder: &Path, output: &Output, marks: &[u8]) {
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(output.stdout.is_empty());
    let found = fs::read(folder.join("marks/marks.csv")).unwrap();
    assert!(found == marks, "{} bytes and {}: {}", found.len(), marks.len(), text(&output.stderr));
    assert_eq!(fs::read_dir(folder.join("marks")).unwrap().count(), 1);
}

#[test]
fn a_run_killed_at_any_moment_is_gone_on_with() {
    let folder = folder("killed");
    let table = padded(200);
    let marks = uninterrupted(&folder, &table);
    let whole = table.len() / BLOCK;
    assert!(whole > 8, "{whole}");
    for moment in 0..24 {
        let _ = fs::remove_dir_all(folder.join("marks"));
        let bytes = table.len() * moment / 23;
        // At every second moment all that can be whole is waited for, at the others the kill comes while it is at work.
        let waited_for = if moment % 2 == 0 { (bytes / (BLOCK + 1000)).saturating_sub(1) } else { 0 };
        kill_after(&folder, &table, bytes, waited_for);
        assert!(!folder.join("marks/marks.csv").exists(), "marks appear whole or not at all");
        let done = blocks(&folder);
        assert!(done >= waited_for);
        let output = carom(&folder, &INTO, table.as_bytes());
        is_finished(&folder, &output, &marks);
        assert_eq!(text(&output.stderr).contains("going on at line"), done > 0, "{}", text(&output.stderr));
    }
}

#[test]
fn a_run_killed_again_and_again_ends_in_the_end() {
    let folder = folder("again");
    let table = padded(400);
    fs::write(folder.join("table.csv"), &table).unwrap();
    let marks = uninterrupted(&folder, &table);
    let mut runs = 0;
    let output = loop {
        let mut child = begin(&folder, &["mark", "sheet/key.json", "table.csv", "--stream", "--out", "marks"]);
        let before = blocks(&folder);
        wait_until(&mut child, || blocks(&folder) > before);
        runs += 1;
        let _ = child.kill();
        let output = child.wait_with_output().unwrap();
        if output.status.success() {
            break output;
        }
        assert!(runs < 100, "no run goes on where the last one was");
    };
    is_finished(&folder, &output, &marks);
    assert!(runs > 2, "{runs}");
}

#[test]
fn nothing_is_believed_that_the_files_do_not_bear_out() {
    let folder = folder("damaged");
    let table = padded(100);
    let marks = uninterrupted(&folder, &table);
    let whole = table.len() / (BLOCK + 1000) - 1;
    let (journal_at, marks_at) = (folder.join("marks/unfinished/journal"), folder.join("marks/unfinished/marks.csv"));
    let damages: [(&str, &dyn Fn()); 8] = [
        ("a line of the journal is torn", &|| {
            fs::write(&journal_at, [&journal(&folder)[..], b"0123"].concat()).unwrap()
        }),
        ("a line of it is no line", &|| fs::write(&journal_at, [&journal(&folder)[..], b"1 2 3\n"].concat()).unwrap()),
        ("the journal is cut", &|| fs::write(&journal_at, &journal(&folder)[..journal(&folder).len() - 9]).unwrap()),
        ("the journal is no text", &|| fs::write(&journal_at, [0xff; 99]).unwrap()),
        ("the journal is gone", &|| fs::remove_file(&journal_at).unwrap()),
        ("marks are cut", &|| fs::write(&marks_at, &fs::read(&marks_at).unwrap()[..2000]).unwrap()),
        ("a byte of the marks is another", &|| {
            let mut marks = fs::read(&marks_at).unwrap();
            marks[700] ^= 1;
            fs::write(&marks_at, marks).unwrap();
        }),
        ("marks are gone", &|| fs::remove_file(&marks_at).unwrap()),
    ];
    for (what, damage) in damages {
        let _ = fs::remove_dir_all(folder.join("marks"));
        kill_after(&folder, &table, table.len() - 10, whole);
        damage();
        let output = carom(&folder, &INTO, table.as_bytes());
        println!("{what}: {}", text(&output.stderr));
        is_finished(&folder, &output, &marks);
    }
}

#[test]
fn what_has_changed_since_is_marked_afresh_and_said() {
    let folder = folder("changed");
    let table = padded(100);
    let whole = table.len() / (BLOCK + 1000) - 1;
    let other_key = carom(&folder, &["sheet", "--seed", "5", "--format", "text", "--out", "other"], b"");
    assert!(other_key.status.success());
    let late = table.replace("S60,2,speed of A", "S60,2,speed of B");
    let early = table.replace("S0,2,speed of A", "S0,2,speed of B");
    let shorter = &table[..table.find("S20,").unwrap()];
    let longer = format!("{table}T,2,speed of A,2.78,\n");
    let strict = ["--profile", "aqa"];
    let cases: [(&str, &[&str], &str, &[&str]); 6] = [
        (&late, &[], "sheet/key.json", &["going on at line", "the submissions have changed since: from line"]),
        (&early, &[], "sheet/key.json", &["the submissions have changed since: from line 1 all is marked afresh"]),
        (shorter, &[], "sheet/key.json", &["the submissions have changed since"]),
        (&longer, &[], "sheet/key.json", &["going on at line"]),
        (&table, &strict, "sheet/key.json", &["another key, profile or version of Carom: all is marked afresh"]),
        (&table, &[], "other/key.json", &["another key, profile or version of Carom: all is marked afresh"]),
    ];
    for (table_now, profile, key, said) in cases {
        let _ = fs::remove_dir_all(folder.join("marks"));
        kill_after(&folder, &table, table.len() - 10, whole);
        let to_pipe = [&["mark", key, "-", "--stream"], profile].concat();
        let marks = carom(&folder, &to_pipe, table_now.as_bytes()).stdout;
        let output = carom(&folder, &[&to_pipe[..], &["--out", "marks"]].concat(), table_now.as_bytes());
        is_finished(&folder, &output, &marks);
        for words in said {
            assert!(text(&output.stderr).contains(words), "{words} in {}", text(&output.stderr));
        }
    }
}

#[test]
fn what_a_table_left_is_not_in_the_way_of_json_lines() {
    let folder = folder("kinds");
    kill_after(&folder, &padded(50), 50_000, 1);
    let line = r#"{"student": "Ada", "question": 2, "blank": "speed of A", "answer": "2.78"}"#;
    let output = carom(&folder, &INTO, line.as_bytes());
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(fs::read_to_string(folder.join("marks/marks.jsonl")).unwrap().contains("\"correct\""));
    assert_eq!(fs::read_dir(folder.join("marks")).unwrap().count(), 1);
}

#[test]
fn two_runs_do_not_write_into_one_folder() {
    let folder = folder("two");
    let table = padded(50);
    let mut first = begin(&folder, &INTO);
    let mut stdin = first.stdin.take().unwrap();
    stdin.write_all(&table.as_bytes()[..1000]).unwrap();
    wait_until(&mut first, || !journal(&folder).is_empty());
    let second = carom(&folder, &INTO, table.as_bytes());
    assert_eq!(second.status.code(), Some(1));
    assert!(text(&second.stderr).contains("another `carom mark` is writing into `marks`"), "{}", text(&second.stderr));
    stdin.write_all(&table.as_bytes()[1000..]).unwrap();
    drop(stdin);
    is_finished(&folder, &first.wait_with_output().unwrap(), &uninterrupted(&folder, &table));
}

#[test]
fn nothing_is_left_of_a_run_that_has_nothing_to_mark() {
    let folder = folder("nothing");
    let output = carom(&folder, &INTO, b"student,question,answer\n");
    assert_eq!(output.status.code(), Some(1));
    assert!(!folder.join("marks").exists());
    fs::create_dir_all(folder.join("marks/marks.csv")).unwrap();
    let output = carom(&folder, &INTO, b"student,question,answer\nAda,2,3\n");
    assert!(text(&output.stderr).contains("it is a folder"), "{}", text(&output.stderr));
    assert!(!folder.join("marks/unfinished").exists());
}
