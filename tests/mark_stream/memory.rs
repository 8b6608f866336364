//! However long a stream is, or a line of it, little of it is held: the most memory that a run has had, in bytes.

use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::thread;

use super::{STREAM, begin, carom, folder, text};

const MEGABYTE: usize = 1 << 20;

/// What a run prints, and the most memory that it has had before its input ended.
fn run(folder: &Path, pieces: impl Iterator<Item = Vec<u8>>) -> (String, usize) {
    let mut child = begin(folder, &STREAM);
    let mut stdin = child.stdin.take().unwrap();
    let mut stdout = child.stdout.take().unwrap();
    let reader = thread::spawn(move || {
        let mut printed = String::new();
        stdout.read_to_string(&mut printed).map(|_| printed)
    });
    pieces.for_each(|piece| stdin.write_all(&piece).unwrap());
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
    let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    let kilobytes: usize = most.trim().trim_end_matches("kB").trim().parse().unwrap();
    drop(stdin);
    assert!(child.wait().unwrap().success());
    (reader.join().unwrap().unwrap(), kilobytes << 10)
}

#[test]
fn a_line_without_an_end_is_set_aside_and_not_held() {
    let folder = folder("endless");
    let head = b"student,question,blank,answer\nAda,2,speed of A,2.78\nBen,2,speed of A,".to_vec();
    let tail = b"\nCleo,2,speed of A,2.78\n".to_vec();
    for opening in ["", "\""] {
        let long = (0..64).map(|_| vec![b'7'; MEGABYTE]);
        let pieces = [head.clone(), opening.into()].into_iter().chain(long).chain([tail.clone()]);
        let (printed, most) = run(&folder, pieces);
        assert!(most < 32 * MEGABYTE, "{most} bytes");
        let rows: Vec<&str> = printed.lines().collect();
        // Of a question with four blanks each student has four rows.
        assert_eq!(rows.len(), 1 + 4 + 1 + 4, "{rows:?}");
        assert!(printed.contains("line 3: this is longer than 1048576 bytes"), "{rows:?}");
        assert!(printed.contains("\nCleo,2,,speed of A,correct,"), "{rows:?}");
    }
    // Nor where the names of the columns should stand.
    let output = carom(&folder, &STREAM, &vec![b'7'; 4 * MEGABYTE]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("line 1 of `stdin`, which is to name the columns, is too long"));
    assert!(output.stderr.len() < 500);
}

#[test]
fn a_student_with_ever_more_answers_is_not_held_for_ever() {
    let folder = folder("hoarder");
    let row = || format!("Ada,2,speed of A,{}\n", "7".repeat(MEGABYTE - 100)).into_bytes();
    let pieces = (0..60).map(|_| row());
    let (printed, most) = run(&folder, [b"student,question,blank,answer\n".to_vec()].into_iter().chain(pieces));
    assert!(most < 64 * MEGABYTE, "{most} bytes");
    assert!(printed.contains("more than 8388608 bytes"));
    assert_eq!(printed.lines().filter(|row| row.contains(",not-marked,")).count(), 59);
}

#[test]
fn ten_times_as_many_students_take_no_more_memory() {
    let folder = folder("flat");
    let students = |count: usize| {
        let pad = "x".repeat(250);
        let student = move |student: usize| format!("student {student},2,speed of A,2.{},{pad}\n", student % 100);
        let block = move |block: usize| (0..1000).map(|place| student(block * 1000 + place)).collect::<String>().into();
        [b"student,question,blank,answer,notes\n".to_vec()].into_iter().chain((0..count / 1000).map(block))
    };
    let (few, most_for_few) = run(&folder, students(10_000));
    let (many, most_for_many) = run(&folder, students(100_000));
    assert_eq!((few.lines().count(), many.lines().count()), (1 + 4 * 10_000, 1 + 4 * 100_000));
    // The second has 24 megabytes more to read. Of each student who is over sixteen bytes stay.
    assert!(most_for_many < most_for_few + 8 * MEGABYTE, "{most_for_few} and {most_for_many} bytes");
}

/// What `docs/marking-in-bulk.md` says of a million; it takes as long as all the others together.
#[test]
#[ignore = "takes as long as all the others together; `.ci/run` runs it"]
fn a_million_answers_are_marked_in_less_than_two_hundred_megabytes() {
    let folder = folder("million");
    let right = [("speed of A", 2.78), ("direction of A", 46.1), ("speed of B", 3.08), ("direction of B", 0.0)];
    let answers = move |student: u64| -> String {
        let each = right.iter().enumerate().map(|(place, (blank, right))| {
            let chance = (4 * student + place as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
            // Three in ten are wrong, and half of these as others are wrong too.
            let wrong = [0.5, 1.5, 2.0, 3.0].get(chance as usize / 10 % 8).copied();
            let typed = match (chance % 10 < 3, wrong) {
                (false, _) => right.to_string(),
                (true, Some(times)) => (right * times).to_string(),
                (true, None) => (chance as f64 / 1e6).to_string(),
            };
            format!("student {student},2,{blank},{typed}\n")
        });
        each.collect()
    };
    let block = move |block: u64| (0..1000).map(|place| answers(block * 1000 + place)).collect::<String>().into();
    let pieces = [b"student,question,blank,answer\n".to_vec()].into_iter().chain((0..250).map(block));
    let (printed, most) = run(&folder, pieces);
    assert_eq!(printed.lines().count(), 1 + 1_000_000);
    assert!(printed.matches(",correct,").count() > 600_000, "{}", printed.matches(",correct,").count());
    assert!(most < 200 * MEGABYTE, "{most} bytes");
}
