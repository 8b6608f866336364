//! The students that Carom writes.

use crate::answer::{Accept, Kind};
use crate::bank::{Code, EarnedFor};
use crate::expr::{Expr, print};
use crate::mark::{KeyedBlank, KeyedPart, KeyedQuestion, PartScript, Script};
use crate::mechanics::{Axis, Moment, Quantity, Seen, Sphere};
use crate::number::{Places, round};
use crate::paper::{Blank, KeyPart, KeyQuestion, PrintedAnswer, PrintedPart, PrintedQuestion};

/// A student with what must come of the script.
#[derive(Clone, Debug)]
pub struct Student {
    /// What kind of student it is, for reports: `right answers in LaTeX`.
    pub who: String,
    /// What is handed in.
    pub script: Script,
    /// What it must earn.
    pub expected: Expected,
}

/// What a student must earn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expected {
    /// Every mark.
    Everything,
    /// Every mark of the parts whose answer is not printed in the question.
    AllButShown,
    /// No mark.
    Nothing,
    /// A wrong answer with this mistake among its causes.
    Mistake {
        /// The place of the part.
        part: usize,
        /// The place of the blank.
        blank: usize,
        /// The tag of the mistake.
        tag: String,
    },
    /// A wrong answer, and no accuracy mark of its part.
    Wrong {
        /// The place of the part.
        part: usize,
        /// The place of the blank.
        blank: usize,
    },
    /// A right number in a form that is not wanted.
    ExactWanted {
        /// The place of the part.
        part: usize,
        /// The place of the blank.
        blank: usize,
    },
    /// A mark that follows through.
    FollowThrough {
        /// The place of the part.
        part: usize,
        /// The id of the mark.
        id: String,
    },
}

impl Student {
    /// What was handed in, on one line.
    pub fn wrote(&self) -> String {
        let parts = self.script.parts.iter().flat_map(|part| {
            let answers = part.answers.iter().map(|(_, answer)| answer.clone());
            answers.chain(part.working.iter().cloned())
        });
        parts.collect::<Vec<_>>().join(" | ")
    }
}

/// How a right answer may be written.
type Notation = (&'static str, fn(&PrintedAnswer, &str) -> Option<String>);

/// The notations, each of one printed answer and its decimal to fifteen figures.
const NOTATIONS: [Notation; 9] = [
    ("right answers in exact form", |answer, _| answer.exact.as_ref().map(print::unicode)),
    ("right answers in plain letters", |answer, _| {
        answer.exact.as_ref().filter(|exact| is_plain(exact)).map(print::plain)
    }),
    ("right answers in LaTeX", |answer, _| answer.exact.as_ref().map(|exact| format!("${}$", print::latex(exact)))),
    ("right answers in figures", |answer, _| answer.rounded.as_ref().map(print::unicode)),
    ("right answers in figures, with their units", |answer, _| {
        let rounded = answer.rounded.as_ref().or(answer.exact.as_ref())?;
        Some(format!("{} {}", print::unicode(rounded), answer.unit.plain()).trim().to_owned())
    }),
    ("right answers in exact form and then in figures", |answer, _| {
        Some(format!("{} = {}", print::unicode(answer.exact.as_ref()?), print::unicode(answer.rounded.as_ref()?)))
    }),
    ("right answers after ≈", |answer, _| {
        answer.rounded.as_ref().map(|rounded| format!("≈ {}", print::unicode(rounded)))
    }),
    ("right answers with five figures", |_, decimal| longer(decimal, 5)),
    ("right answers with ten figures", |_, decimal| longer(decimal, 10)),
];

/// What is no answer to anything.
const JUNK: [&str; 8] = ["?", "idk", "see working", "=", "((((", "√", "the answer is above", "\\frac{}{}"];

/// Every student of a question as it was printed.
pub fn students(printed: &PrintedQuestion, key: &KeyQuestion, question: &KeyedQuestion) -> Vec<Student> {
    let mut all = Vec::new();
    for (who, notation) in NOTATIONS {
        all.extend(right(who, notation, printed, key));
    }
    all.push(worked(printed, question));
    all.push(Student { who: "an empty script".to_owned(), script: script(Vec::new()), expected: Expected::Nothing });
    for junk in JUNK {
        let parts = key.parts.iter().map(|part| PartScript {
            label: part.label.clone(),
            answers: part.blanks.iter().map(|blank| (Some(blank.name.clone()), junk.to_owned())).collect(),
            working: vec![junk.to_owned()],
        });
        all.push(Student { who: "nonsense".to_owned(), script: script(parts.collect()), expected: Expected::Nothing });
    }
    for (place, (part, keyed)) in key.parts.iter().zip(&question.parts).enumerate() {
        all.extend(mistaken(place, part, keyed, question));
        all.extend(followed(place, part, keyed, question));
        all.extend(in_figures(place, part));
        all.extend(of_wrong_ranges(place, part));
    }
    all
}

fn script(parts: Vec<PartScript>) -> Script {
    Script { student: "synthetic".to_owned(), question: 1, parts }
}

/// Right in a notation, wherever an answer has it; else exact.
fn right(
    who: &str,
    notation: fn(&PrintedAnswer, &str) -> Option<String>,
    printed: &PrintedQuestion,
    key: &KeyQuestion,
) -> Option<Student> {
    let mut is_used = false;
    let mut parts = Vec::new();
    for (part, key) in printed.parts.iter().zip(&key.parts) {
        let mut answers = Vec::new();
        for (answer, blank) in part.answers.iter().zip(&key.blanks) {
            // Figures are no notation for what must be exact.
            let decimal = blank.decimal.as_str().filter(|_| !is_exact(blank)).unwrap_or_default();
            let written = notation(answer, decimal);
            is_used |= written.is_some();
            // The key has the exact value of an answer that the page says in words.
            let exact =
                || answer.exact.as_ref().map(print::unicode).or_else(|| blank.rounded.as_str().map(str::to_owned));
            answers.push((Some(blank.name.clone()), written.or_else(exact).unwrap_or_default()));
        }
        parts.push(PartScript { label: part.label.clone(), answers, working: Vec::new() });
    }
    is_used.then(|| Student { who: who.to_owned(), script: script(parts), expected: Expected::AllButShown })
}

/// Is only the exact value accepted?
fn is_exact(blank: &Blank) -> bool {
    blank.accept == Accept::Exact.to_string()
}

/// One student for each number that must be exact, who gives it in figures.
fn in_figures(place: usize, part: &KeyPart) -> Vec<Student> {
    let is_number = |blank: &Blank| is_exact(blank) && blank.kind == Kind::Number.name();
    let endless = |blank: &Blank| blank.decimal.as_str().and_then(|decimal| longer(decimal, 10)).is_some();
    let each = part.blanks.iter().enumerate().filter(|(_, blank)| is_number(blank) && endless(blank));
    each.map(|(blank, printed)| {
        let answers = vec![(Some(printed.name.clone()), printed.rounded.as_str().unwrap_or_default().to_owned())];
        let parts = vec![PartScript { label: part.label.clone(), answers, working: Vec::new() }];
        let expected = Expected::ExactWanted { part: place, blank };
        Student { who: "figures for what must be exact".to_owned(), script: script(parts), expected }
    })
    .collect()
}

/// How a range is written wrongly: its signs, one after another, and the numbers or letters that stand between them.
type WrongRange = (&'static str, fn(&str) -> String);

/// A range that is right but for whether its ends belong to it.
pub(super) const ENDS_COUNTED: &str = "the range with its ends counted otherwise";

/// The wrong ranges, each of a token of the right one.
const WRONG_RANGES: [WrongRange; 4] = [
    ("the range the wrong way round", |token| match token {
        "<" | "<=" => token.replace('<', ">"),
        _ => token.replace('>', "<"),
    }),
    ("the ends of the range for the range", |token| match token {
        "<" | "<=" | ">" | ">=" => "=".to_owned(),
        _ => token.to_owned(),
    }),
    (ENDS_COUNTED, |token| match token {
        "<" | ">" => format!("{token}="),
        _ => token.trim_end_matches('=').to_owned(),
    }),
    ("a range that ends elsewhere", |token| match token {
        "<" | "<=" | ">" | ">=" => token.to_owned(),
        end => format!("({end})/2"),
    }),
];

/// One student for each way in which a range is written wrongly.
fn of_wrong_ranges(place: usize, part: &KeyPart) -> Vec<Student> {
    let mut all = Vec::new();
    for (blank, printed) in part.blanks.iter().enumerate().filter(|(_, blank)| blank.kind == Kind::Range.name()) {
        let Some(letter) = printed.find.as_str() else { continue };
        let right = signs_and_sides(printed.exact.as_str().unwrap_or_default());
        for (who, wrong) in WRONG_RANGES {
            let token = |token: &String| if token == letter { token.clone() } else { wrong(token) };
            let written = right.iter().map(token).collect::<Vec<_>>().join(" ");
            let answers = vec![(Some(printed.name.clone()), written)];
            let parts = vec![PartScript { label: part.label.clone(), answers, working: Vec::new() }];
            let expected = Expected::Wrong { part: place, blank };
            all.push(Student { who: who.to_owned(), script: script(parts), expected });
        }
    }
    all
}

/// The signs of an inequality and what stands on either side of each, in their order.
fn signs_and_sides(inequality: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut is_side = false;
    for word in inequality.split(' ') {
        let is_sign = word.starts_with(['<', '>']);
        match found.last_mut().filter(|_| is_side && !is_sign) {
            Some(side) => *side = format!("{side} {word}"),
            None => found.push(word.to_owned()),
        }
        is_side = !is_sign;
    }
    found
}

/// A decimal to so many significant figures, if it goes on that long.
fn longer(decimal: &str, figures: usize) -> Option<String> {
    let places = Places::SignificantFigures(u32::try_from(figures).ok()?);
    let rounded = round(&decimal.parse().ok()?, &places).to_string();
    (rounded.contains('.') && !rounded.ends_with('0')).then_some(rounded)
}

/// Can it be typed in plain letters? A vector has brackets there and an angle is in radians.
fn is_plain(expr: &Expr) -> bool {
    !matches!(expr, Expr::Call(..) | Expr::Degrees(_) | Expr::Vector(..)) && expr.children().into_iter().all(is_plain)
}

/// Copies the model solution, every line of it, and what is to be shown at the end; fills in no other blank.
fn worked(printed: &PrintedQuestion, question: &KeyedQuestion) -> Student {
    let part = |(part, keyed): (&PrintedPart, &KeyedPart)| {
        let lines = part.working.iter().flat_map(|line| &line.equations).map(print::unicode);
        let shown = keyed.scheme.iter().find(|mark| mark.code == Code::A1Shown).and_then(|mark| mark.equation.as_ref());
        // What the working does not say in an equation it says in the answer.
        let answer = |(blank, answer): (&KeyedBlank, &PrintedAnswer)| {
            let own = shown.filter(|_| blank.model.kind == Kind::Shown).or(answer.exact.as_ref());
            // Of a direction the page may say in words what it is.
            let said = || Some(print::text_unicode(&answer.phrase)).filter(|phrase| !phrase.is_empty());
            Some((Some(blank.name.clone()), own.map(print::unicode).or_else(said)?))
        };
        let answers = keyed.blanks.iter().zip(&part.answers).filter_map(answer).collect();
        PartScript { label: part.label.clone(), answers, working: lines.collect() }
    };
    let parts = printed.parts.iter().zip(&question.parts).map(part).collect();
    Student { who: "the model solution".to_owned(), script: script(parts), expected: Expected::Everything }
}

/// One student for each mistake that leads to another number.
fn mistaken(place: usize, part: &KeyPart, keyed: &KeyedPart, question: &KeyedQuestion) -> Vec<Student> {
    let mut all = Vec::new();
    for (blank, (printed, known)) in part.blanks.iter().zip(&keyed.blanks).enumerate() {
        // A number that should have letters is another mistake.
        let is_lettered = !question.letters.iter().all(|letter| question.scene.unknowns.contains(letter));
        if is_lettered || printed.decimal.is_null() || printed.kind == Kind::Shown.name() {
            continue;
        }
        for (tags, values) in question.mistaken_values(&known.asked()) {
            let ([tag], [value]) = (tags.as_slice(), values.as_slice()) else { continue };
            let Some(written) = three_figures(*value) else { continue };
            if Some(written.as_str()) == printed.rounded.as_str() || is_hidden(&written, printed, known) {
                continue;
            }
            let answers = vec![(Some(printed.name.clone()), written)];
            let parts = vec![PartScript { label: part.label.clone(), answers, working: Vec::new() }];
            let expected = Expected::Mistake { part: place, blank, tag: (*tag).to_owned() };
            all.push(Student { who: format!("the mistake `{tag}`"), script: script(parts), expected });
        }
    }
    all
}

/// Is a wrong number one with the right one at the figures that are asked for? That the numbers hide it is told elsewhere.
fn is_hidden(written: &str, printed: &Blank, known: &KeyedBlank) -> bool {
    let (Some(places), Some(right)) = (known.model.accept.places(), printed.decimal.as_str()) else { return false };
    let at_its_places = |number: &str| number.parse().ok().map(|number| round(&number, places));
    at_its_places(written) == at_its_places(right)
}

/// A number to three significant figures, as a student writes it.
fn three_figures(value: f64) -> Option<String> {
    let decimal = format!("{value:.12}");
    let rounded = round(&decimal.parse().ok()?, &Places::SignificantFigures(3)).to_string();
    (1e-3..1e3).contains(&value.abs()).then_some(rounded)
}

/// A student whose component of A after the impact is wrong, and who goes on from it.
fn followed(place: usize, part: &KeyPart, keyed: &KeyedPart, question: &KeyedQuestion) -> Vec<Student> {
    let own = Quantity::Velocity(Sphere::A, Moment::After, Axis::N);
    let mut all = Vec::new();
    for mark in keyed.scheme.iter().filter(|mark| mark.code == Code::A1FollowThrough) {
        let asked = match &mark.earned_for {
            EarnedFor::Quantity(quantity) => *quantity,
            EarnedFor::Law(law, _) => match law.seen() {
                Seen::Value([first, ..], _) => *first,
                _ => continue,
            },
            _ => continue,
        };
        // Of the impact in which it is asked for.
        let own = question.meeting(asked.impact()).map_or(own, |meeting| meeting.quantity(own));
        let Some((value, answer)) = question.followed_value(own, asked) else { continue };
        let Some(answer) = three_figures(answer) else { continue };
        let working = vec![format!("v = {value}"), format!("KE lost = {answer}")];
        let answers = part.blanks.iter().map(|blank| (Some(blank.name.clone()), answer.clone())).collect();
        let parts = vec![PartScript { label: part.label.clone(), answers, working }];
        let expected = Expected::FollowThrough { part: place, id: mark.id.clone() };
        all.push(Student { who: "going on from a wrong value".to_owned(), script: script(parts), expected });
    }
    all
}
