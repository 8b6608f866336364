//! How long it takes to mark what a class of thirty hands in for one sheet: questions are prepared once.

use std::hint::black_box;
use std::time::Instant;

use carom::bank::{read_question, shipped};
use carom::diagnostic::Source;
use carom::examine::{Expected, students};
use carom::generate::reference;
use carom::mark::{AnswerKey, KeyedQuestion, PartScript, Profile, Script, from_own_values, mark};
use carom::paper::{Key, compose, key_question};
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
    worst_and_median();
}

/// Ten lines of working for [`TYPED`], as they are typed.
const RIGHT: &str = "perpendicular: 4sin30 = 2
CLM: 4(4cos30) = 4v + 2w
NEL: w - v = 1/3 (4cos30)
4v + 2w = 8√3
3w - 3v = 2√3
6v = 20√3/3
v = 1.92, w = 3.08
speed of A = sqrt(1.92^2 + 2^2) = 2.77
tan θ = 2/1.92
θ = 46.2";

/// The same with slips, and with lines that are no law.
const WITH_SLIPS: &str = "A moves at 30 to the line of centres
4 x 4sin30 = 2v + 4w
v - w = 1/3 (4cos30)
2v + 4w = 9
so 4v + 2w = 17 and w = 2v - 3
v + w = 5.1
v = 1.11, w = 1.78
energy = 1/2 4 1.11^2 + 1/2 2 1.78^2 = 5.63
speed = sqrt(1.11^2 + (4cos30)^2)
tan θ = 3.46/1.11";

/// The question of these lines.
const TYPED: &str = "rest/speeds-and-directions";

/// What is handed in: right answers, answers that a known mistake leads to, answers a tenth too large, for which every
/// reading, slip and wrong value before them is tried in vain, answers that follow from a wrong value in the working, that
/// working alone, and the lines of the worked solution.
const HANDED_IN: [&str; 6] = ["right", "mistaken", "unexplained", "followed", "unanswered", "worked"];

/// What is handed in made of something else that is.
type Change = fn(&Script) -> Script;

/// A question of a key, as text, and everything that Carom's own students hand in for it.
struct Sheet {
    id: &'static str,
    key: String,
    question: KeyedQuestion,
    scripts: Vec<(&'static str, Script)>,
}

fn read(key: &str) -> KeyedQuestion {
    let key = AnswerKey::read(key).unwrap_or_else(|faults| panic!("{faults:?}"));
    key.papers.into_iter().flat_map(|paper| paper.questions).next().expect("a question")
}

/// Every shipped question with its reference numbers.
fn sheets() -> Vec<Sheet> {
    let sheet = |(id, text)| {
        let question = read_question(id, &Source::new(id, text)).unwrap_or_else(|_| panic!("{id}"));
        let variant = reference(&question).unwrap_or_else(|_| panic!("{id}"));
        let printed = compose(&question, &variant, 1);
        let of_key = key_question(&question, &variant, &printed);
        let key = Key::new("shipped".to_owned(), None, vec![of_key.clone()]);
        let key = serde_json::to_string(&key).expect("a key");
        let question = read(&key);
        let own = students(&printed, &of_key, &question).into_iter().filter_map(|student| {
            let kind = match student.expected {
                Expected::Mistake { .. } => "mistaken",
                Expected::FollowThrough { .. } => "followed",
                Expected::AllButShown => "right",
                Expected::Everything => "worked",
                Expected::Nothing | Expected::ExactWanted { .. } | Expected::Wrong { .. } => return None,
            };
            Some((kind, student.script))
        });
        let mut scripts: Vec<(&str, Script)> = own.collect();
        let changed: [(&str, &str, Change); 2] =
            [("unexplained", "right", a_tenth_more), ("unanswered", "followed", unanswered)];
        for (kind, like, change) in changed {
            let like = scripts.iter().filter(|(kind, _)| *kind == like);
            let changed: Vec<_> = like.map(|(_, script)| (kind, change(script))).collect();
            scripts.extend(changed);
        }
        Sheet { id, key, question, scripts }
    };
    shipped().map(sheet).collect()
}

/// Every answer a tenth too large.
fn a_tenth_more(script: &Script) -> Script {
    let mut script = script.clone();
    for (_, answer) in script.parts.iter_mut().flat_map(|part| &mut part.answers) {
        *answer = match answer.parse::<f64>() {
            Ok(number) => format!("{:.3}", number * 1.1),
            Err(_) => format!("1.1({answer})"),
        };
    }
    script
}

/// The working without the answers to which it leads.
fn unanswered(script: &Script) -> Script {
    let mut script = script.clone();
    script.parts.iter_mut().for_each(|part| part.answers.clear());
    script
}

fn lines(script: &Script) -> usize {
    script.parts.iter().map(|part| part.working.len()).sum()
}

/// How many answers are handed in; of a script of working alone one.
fn answers(script: &Script) -> usize {
    script.parts.iter().map(|part| part.answers.len()).sum::<usize>().max(1)
}

/// What was typed in lines, as a script.
fn typed(lines: &str) -> Script {
    let working = lines.lines().map(str::to_owned).collect();
    let part = PartScript { label: String::new(), answers: Vec::new(), working };
    Script { student: "Ann".to_owned(), question: 1, parts: vec![part] }
}

/// All that Carom's students hand in of one kind, marked.
#[divan::bench(args = HANDED_IN)]
fn scripts(bencher: Bencher, kind: &str) {
    let sheets = sheets();
    let all = || sheets.iter().flat_map(|sheet| sheet.scripts.iter().map(move |script| (sheet, script)));
    let all: Vec<_> = all().filter(|(_, (own, _))| *own == kind).map(|(sheet, (_, script))| (sheet, script)).collect();
    let profile = Profile::default();
    let count = all.iter().map(|(_, script)| if kind == "worked" { 1 } else { answers(script) }).sum::<usize>();
    bencher.counter(ItemsCount::new(count)).bench(|| {
        all.iter().for_each(|(sheet, script)| drop(black_box(mark(&sheet.question, script, &profile))));
    });
}

/// Ten lines of working, right and with slips.
#[divan::bench(args = ["right", "with slips"])]
fn ten_lines(bencher: Bencher, kind: &str) {
    let sheets = sheets();
    let sheet = sheets.iter().find(|sheet| sheet.id == TYPED).expect("the question is shipped");
    let script = typed(if kind == "right" { RIGHT } else { WITH_SLIPS });
    let profile = Profile::default();
    bencher.bench(|| mark(&sheet.question, &script, &profile));
}

/// A wrong answer, tried against every reading, slip and pair of slips, and the answer of the next part, which follows from it.
fn carried() -> Script {
    let part = |label: &str, blank: &str, answer: &str| PartScript {
        label: label.to_owned(),
        answers: vec![(Some(blank.to_owned()), answer.to_owned())],
        working: Vec::new(),
    };
    let parts = vec![part("a", "speed of B", "5"), part("b", "coefficient of restitution", "0.778")];
    Script { student: "Ann".to_owned(), question: 1, parts }
}

/// The question of these answers.
const CARRIED: &str = "direct/restitution-from-one-speed";

/// The rest solved again from the wrong values of what is followed through, and written out: only a page that shows it
/// needs it.
#[divan::bench]
fn solved_again(bencher: Bencher) {
    let sheets = sheets();
    let mut followed = Vec::new();
    for sheet in &sheets {
        let scripts = sheet.scripts.iter().filter(|(kind, _)| *kind == "followed");
        followed.extend(scripts.map(|(_, script)| (sheet, mark(&sheet.question, script, &Profile::default()))));
    }
    bencher.counter(ItemsCount::new(followed.len())).bench(|| {
        for (sheet, marked) in &followed {
            let each = sheet.question.parts.iter().zip(marked);
            each.for_each(|(part, marked)| drop(black_box(from_own_values(&sheet.question, part, &marked.own))));
        }
    });
}

/// A question prepared: its key read, and everything worked out that marking looks up.
#[divan::bench]
fn preparing(bencher: Bencher) {
    let sheets = sheets();
    bencher.counter(ItemsCount::new(sheets.len())).bench(|| sheets.iter().for_each(|sheet| drop(prepared(sheet))));
}

/// The key of a question read, and an answer marked that has no cause: that everything is looked up is what counts.
fn prepared(sheet: &Sheet) -> KeyedQuestion {
    let question = read(&sheet.key);
    let nonsense = |part: &carom::mark::KeyedPart| PartScript {
        label: part.label.clone(),
        answers: part.blanks.iter().map(|blank| (Some(blank.name.clone()), "987.6".to_owned())).collect(),
        working: Vec::new(),
    };
    let parts = question.parts.iter().map(nonsense).collect();
    black_box(mark(&question, &Script { student: "Ann".to_owned(), question: 1, parts }, &Profile::default()));
    question
}

/// The median and the worst of each, each the best of some repetitions.
fn worst_and_median() {
    let (sheets, profile) = (sheets(), Profile::default());
    println!("\nmarking, in microseconds: median, worst");
    for kind in HANDED_IN {
        let of = match kind {
            "worked" => "a script",
            "followed" => "an answer and two lines",
            "unanswered" => "two lines",
            _ => "an answer",
        };
        let mut times = Vec::new();
        for sheet in &sheets {
            for (_, script) in sheet.scripts.iter().filter(|(own, _)| *own == kind) {
                let took = time(|| drop(black_box(mark(&sheet.question, script, &profile))));
                let (share, what) = match kind {
                    "worked" => (took, format!("{}, {} lines", sheet.id, lines(script))),
                    _ => (took / answers(script) as f64, format!("{}, {:?}", sheet.id, script.parts[0].answers)),
                };
                assert!(!of.contains("two lines") || lines(script) == 2, "{what}");
                times.push((share, what));
            }
        }
        row(&format!("{kind}, {of}"), times);
    }
    let sheet = sheets.iter().find(|sheet| sheet.id == TYPED).expect("the question is shipped");
    for (name, text) in [("ten lines, right", RIGHT), ("ten lines, with slips", WITH_SLIPS)] {
        let script = typed(text);
        row(name, vec![(time(|| drop(black_box(mark(&sheet.question, &script, &profile)))), sheet.id.to_owned())]);
    }
    let sheet = sheets.iter().find(|sheet| sheet.id == CARRIED).expect("the question is shipped");
    let script = carried();
    let marked = mark(&sheet.question, &script, &profile);
    assert_eq!(marked[1].answers[0].judgement.note, Some("follow-through"));
    let took = time(|| drop(black_box(mark(&sheet.question, &script, &profile)))) / answers(&script) as f64;
    row("carried, an answer", vec![(took, sheet.id.to_owned())]);
    let preparing = sheets.iter().map(|sheet| (time(|| drop(prepared(sheet))), sheet.id.to_owned()));
    row("preparing a question", preparing.collect());
}

fn row(name: &str, mut times: Vec<(f64, String)>) {
    times.sort_by(|one, two| one.0.total_cmp(&two.0));
    let (median, worst) = (times[times.len() / 2].0, &times[times.len() - 1]);
    println!("{name:33} {median:8.1} {:8.1}  {}", worst.0, worst.1);
}

fn time(once: impl Fn()) -> f64 {
    let once = || {
        let start = Instant::now();
        once();
        start.elapsed().as_secs_f64() * 1e6
    };
    (0..9).map(|_| once()).fold(f64::MAX, f64::min)
}
