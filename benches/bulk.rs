//! What it costs to mark in bulk: beside reading the same table with nothing but the csv crate, for a thousand answers to a
//! million, on one processor and on all.
//!
//! Times are of processors, all that a run had, so that other work on the machine weighs little; the rest is as the clock
//! has it. Needs Linux, which says in files what a process has had.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Instant;

use serde_json::Value as Json;

/// What students write.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// Decimals, all of them right, in three figures or more.
    Right,
    /// Three in ten wrong, half of these as others have them too.
    Mixed,
    /// The same, and hardly two alike: right ones with further figures, wrong ones anywhere.
    Different,
}

const KINDS: [(Kind, &str); 3] =
    [(Kind::Right, "right decimals"), (Kind::Mixed, "three in ten wrong"), (Kind::Different, "no two alike")];

fn main() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bulk");
    fs::create_dir_all(&folder).expect("a folder");
    let made = carom().args(["sheet", "--seed", "3", "--format", "text", "--out"]).arg(folder.join("sheet")).output();
    assert!(made.expect("carom").status.success());
    let key = fs::read_to_string(folder.join("sheet/key.json")).expect("a key");
    let blanks = blanks(&serde_json::from_str(&key).expect("JSON"));

    println!(
        "processor time for an answer, in microseconds: read with the csv crate, marked, and how many times that is"
    );
    println!("{:20} {:>9} {:>8} {:>8} {:>7} {:>11} {:>8}", "", "answers", "read", "marked", "times", "a second", "MB");
    for (kind, name) in KINDS {
        for count in [1_000, 10_000, 100_000, 1_000_000] {
            let table = written(&folder, &blanks, kind, count);
            // A short table is read often enough to be measured.
            let often = 1_000_000 / count;
            let read =
                processor_time(OWN, || (0..often).for_each(|_| assert!(records(&table) >= count))) / often as f64;
            let often = (100_000 / count).max(1);
            let mut most = 0;
            let marked =
                processor_time(OF_RUNS, || (0..often).for_each(|_| most = marked(&folder, &table).0)) / often as f64;
            let micros = |seconds: f64| seconds * 1e6 / count as f64;
            println!(
                "{name:20} {count:9} {:8.2} {:8.2} {:7.1} {:11.0} {:8.1}",
                micros(read),
                micros(marked),
                marked / read,
                count as f64 / marked,
                most as f64 / (1 << 20) as f64
            );
        }
    }

    println!(
        "\na million answers by the clock, in seconds: one processor, all, and how many times as quick; best of three"
    );
    for (kind, name) in KINDS {
        let table = written(&folder, &blanks, kind, 1_000_000);
        let best = |one: bool| (0..3).map(|_| clock(&folder, &table, one)).fold(f64::MAX, f64::min);
        let (one, all) = (best(true), best(false));
        println!("{name:20} {one:8.2} {all:8.2} {:8.2}", one / all);
    }
}

fn carom() -> Command {
    Command::new(env!("CARGO_BIN_EXE_carom"))
}

/// Every blank with a number for its answer: the question, the part, the name, the number.
fn blanks(key: &Json) -> Vec<(String, String, String, f64)> {
    let mut blanks = Vec::new();
    for question in key["questions"].as_array().expect("questions") {
        for part in question["parts"].as_array().expect("parts") {
            for blank in part["blanks"].as_array().expect("blanks") {
                let number = blank["decimal"].as_str().and_then(|decimal| decimal.parse().ok());
                let text = |json: &Json| json.as_str().unwrap_or_default().to_owned();
                blanks.extend(number.map(|number| {
                    (question["number"].to_string(), text(&part["label"]), text(&blank["name"]), number)
                }));
            }
        }
    }
    blanks
}

/// Numbers from 0 to 1, the same every time.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn figures(number: f64, figures: usize) -> String {
    let before = number.abs().max(1e-9).log10().floor() as i32 + 1;
    format!("{number:.*}", usize::try_from(figures as i32 - before).unwrap_or(0))
}

/// A table of so many answers.
fn written(folder: &Path, blanks: &[(String, String, String, f64)], kind: Kind, count: usize) -> PathBuf {
    let mut dice = Dice(count as u64);
    let mut text = "student,question,part,blank,answer\n".to_owned();
    for answer in 0..count {
        let (question, part, blank, right) = &blanks[answer % blanks.len()];
        let is_wrong = kind != Kind::Right && dice.roll() < 0.3;
        let wrong = match dice.roll() < 0.5 && kind == Kind::Mixed {
            true => right * [0.5, 2.0, 3.0, 1.5][(dice.roll() * 4.0) as usize],
            false => right * (0.5 + 1.5 * dice.roll()),
        };
        let typed = match (is_wrong, kind) {
            (true, Kind::Different) => figures(wrong, 6),
            (true, _) => figures(wrong, 3),
            (false, Kind::Different) => figures(*right, 4) + &((dice.roll() * 1e6) as usize).to_string(),
            (false, _) => figures(*right, [3, 3, 4, 5][(dice.roll() * 4.0) as usize]),
        };
        text.push_str(&format!("student {:07},{question},{part},{blank},{typed}\n", answer / blanks.len()));
    }
    let path = folder.join("answers.csv");
    fs::write(&path, text).expect("a table");
    path
}

/// Reads a table with the csv crate.
fn records(table: &Path) -> usize {
    let mut reader = csv::Reader::from_path(table).expect("a table");
    let mut record = csv::StringRecord::new();
    let mut count = 0;
    while reader.read_record(&mut record).expect("a record") {
        count += 1;
    }
    count
}

/// Marks a table through a pipe: the most memory the run has had, and the length of what it printed.
fn marked(folder: &Path, table: &Path) -> (usize, usize) {
    let mut child = carom()
        .arg("mark")
        .arg(folder.join("sheet/key.json"))
        .args(["-", "--stream"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("carom");
    let (mut stdin, mut stdout) = (child.stdin.take().expect("a pipe"), child.stdout.take().expect("a pipe"));
    let reader = thread::spawn(move || {
        let (mut piece, mut length) = (vec![0; 1 << 16], 0);
        while let Ok(more @ 1..) = stdout.read(&mut piece) {
            length += more;
        }
        length
    });
    let (mut file, mut piece) = (File::open(table).expect("a table"), vec![0; 1 << 16]);
    while let Ok(more @ 1..) = file.read(&mut piece) {
        stdin.write_all(&piece[..more]).expect("a pipe");
    }
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
    let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
    drop(stdin);
    assert!(child.wait().expect("carom").success());
    (most.unwrap_or(0_usize) << 10, reader.join().expect("what was printed"))
}

/// How long a run takes by the clock, its marks thrown away; on one processor alone, if that is asked.
fn clock(folder: &Path, table: &Path, on_one: bool) -> f64 {
    let mut command = if on_one { Command::new("taskset") } else { carom() };
    if on_one {
        command.args(["-c", "0"]).arg(env!("CARGO_BIN_EXE_carom"));
    }
    command.arg("mark").arg(folder.join("sheet/key.json")).arg(table).arg("--stream").stdout(Stdio::null());
    let start = Instant::now();
    assert!(command.status().expect("carom, and taskset").success());
    start.elapsed().as_secs_f64()
}

/// Where `/proc/self/stat` says what this process has had of processors, in hundredths of a second.
const OWN: Range<usize> = 11..13;

/// Where it says the same of the runs that it has waited for.
const OF_RUNS: Range<usize> = 13..15;

/// Seconds of processor in the meantime.
fn processor_time(whose: Range<usize>, work: impl FnOnce()) -> f64 {
    let so_far = || {
        let stat = fs::read_to_string("/proc/self/stat").expect("Linux");
        let after_the_name = stat.rsplit(')').next().unwrap_or_default();
        let ticks = |place: usize| after_the_name.split_whitespace().nth(place)?.parse::<f64>().ok();
        whose.clone().filter_map(ticks).sum::<f64>() / 100.0
    };
    let before = so_far();
    work();
    so_far() - before
}
