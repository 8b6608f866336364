//! Marks in bulk: scripts marked on all processors, each at once in the form in which it is written, in their order.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use serde_json::json;

use super::json_lines::lines_of;
use super::rows::cells_of;
use super::{MARKS, marked};
use crate::mark::profile::Profile;
use crate::mark::submissions::{HandedIn, SetAside, Sorted};
use crate::table::append;

/// What the verdict of a row is that was not marked.
const NOT_MARKED: &str = "not-marked";

/// The marks of scripts as rows of a table without its header, or as JSON lines; then what was set aside, each with its
/// line and the reason.
pub fn in_bulk(sorted: &Sorted, profile: &Profile, as_table: bool) -> String {
    let one = |script: &HandedIn| {
        let script = marked(script, profile);
        if as_table { append(script.rows().into_iter().map(cells_of)) } else { lines_of(&script) }
    };
    let mut text = on_all_processors(&sorted.scripts, &one).concat();
    match as_table {
        true => text.push_str(&append(sorted.set_aside.iter().map(row_aside))),
        false => sorted.set_aside.iter().for_each(|aside| text.push_str(&line_aside(aside))),
    }
    text
}

fn row_aside(aside: &SetAside) -> [String; MARKS.len()] {
    let row = &aside.row;
    let [student, question, part, blank] = [&row.student, &row.question, &row.part, &row.blank].map(String::clone);
    let nought = || "0".to_owned();
    let reason = format!("line {}: {}", row.line, aside.reason);
    [
        student,
        question,
        part,
        blank,
        NOT_MARKED.to_owned(),
        nought(),
        nought(),
        String::new(),
        NOT_MARKED.to_owned(),
        reason,
    ]
}

fn line_aside(aside: &SetAside) -> String {
    let row = &aside.row;
    let line = json!({
        "student": row.student, "question": row.question, "part": row.part, "verdict": NOT_MARKED,
        "line": row.line, "reason": aside.reason, "answer": row.answer, "working": row.working,
    });
    format!("{line}\n")
}

/// What workers on all processors make of each item, in the order of the items.
fn on_all_processors<Item: Sync, Made: Send>(items: &[Item], work: &(dyn Fn(&Item) -> Made + Sync)) -> Vec<Made> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let places = std::iter::from_fn(|| Some(next.fetch_add(1, Ordering::Relaxed)));
        places.map_while(|place| Some((place, work(items.get(place)?)))).collect::<Vec<_>>()
    };
    let workers = thread::available_parallelism().map_or(1, NonZero::get).min(items.len());
    let mut made: Vec<(usize, Made)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(worker)).collect();
        // A panic in a worker is a bug in carom and is passed on as it is.
        let join = |worker: thread::ScopedJoinHandle<'_, _>| {
            worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        workers.into_iter().flat_map(join).collect()
    });
    made.sort_unstable_by_key(|(place, _)| *place);
    made.into_iter().map(|(_, made)| made).collect()
}
