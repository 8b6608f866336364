//! The commands that `docs/marking-in-bulk.md` shows, run as they stand there.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::{folder, text};

/// The commands of a page.
fn commands() -> Vec<String> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/marking-in-bulk.md");
    let page = fs::read_to_string(page).unwrap();
    page.lines().filter_map(|line| line.strip_prefix("$ ")).map(str::to_owned).collect()
}

#[test]
fn the_commands_of_the_page_give_the_same_marks() {
    let folder = folder("page");
    // One that `sort` can sort: no line breaks in cells, and the students in order.
    let header = "student,question,part,blank,answer\n";
    let row =
        |student: usize| format!("S{student:04},2,,speed of A,2.7{}\nS{student:04},2,,speed of B,3.1\n", student % 10);
    fs::write(folder.join("answers.csv"), format!("{header}{}", (0..300).map(row).collect::<String>())).unwrap();
    let carom = Path::new(env!("CARGO_BIN_EXE_carom")).parent().unwrap();
    let path = format!("{}:{}", carom.display(), std::env::var("PATH").unwrap());
    let shown = commands();
    let run: Vec<&String> = shown.iter().filter(|command| command.contains("carom mark")).collect();
    assert_eq!(run.len(), 3);
    for command in run {
        let output = Command::new("sh").args(["-c", command]).env("PATH", &path).current_dir(&folder).output().unwrap();
        assert!(output.status.success(), "{command}: {}", text(&output.stderr));
    }
    let marks = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    assert_eq!(marks("marks/marks.csv").lines().count(), 1 + 300 * 4);
    assert!(marks("marks/marks.csv") == marks("marks.csv") && marks("marks.csv") == marks("sorted.csv"));
    assert!(shown.iter().any(|command| command.starts_with("python3 examples/spark/mark.py ")));
}
