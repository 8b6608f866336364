//! What holds of every answer, however strange, against every model.

use std::sync::LazyLock;

use carom::answer::{Accept, Kind};
use carom::mark::judging::{Judgement, Model, ModelOptions, Verdict, judge};
use carom::mark::reading::{Form, LONGEST, MOST_READINGS, Reading, Statement, Unreadable, read_answer};
use carom::number::{Letter, Places, Range, steps_taken};

/// The most steps of arithmetic that an answer may take, read and judged once: about seven milliseconds.
const MOST_STEPS: u64 = 500_000;

/// A model, and another with the same letters that no answer fits that fits the first exactly.
const PAIRS: [(&str, &str, Option<Kind>); 17] = [
    ("4*sqrt(39)/9", "4*sqrt(39)/9+1", Some(Kind::Number)),
    ("10/43", "10/43+1", Some(Kind::Number)),
    ("12", "13", Some(Kind::Number)),
    ("6*sin(10*deg)", "6*sin(10*deg)+1", Some(Kind::Number)),
    ("u*(1-e)/2", "u*(1-e)/2+1", Some(Kind::Expression)),
    ("u*sqrt(cos(theta)^2+e^2*sin(theta)^2)", "u*sqrt(cos(theta)^2+e^2*sin(theta)^2)+1", Some(Kind::Expression)),
    ("9*m*u^2/4", "9*m*u^2/4+1", Some(Kind::Expression)),
    ("4*i+j", "5*i+j", Some(Kind::Vector)),
    ("u*i-e*u*j/2", "u*i-(e*u/2+1)*j", Some(Kind::Vector)),
    ("atan(3*sqrt(3)/5)", "atan(3*sqrt(3)/5)+deg", Some(Kind::Angle)),
    ("[6*sin(10*deg), 0]", "[6*sin(10*deg)+1, 0]", Some(Kind::Velocity)),
    ("[2*sqrt(3), 2]", "[2*sqrt(3), 3]", Some(Kind::Velocity)),
    ("2/3", "5/3", Some(Kind::Ratio)),
    ("i-3*j", "i-2*j", Some(Kind::Line)),
    ("2*v+3*w=4*u", "2*v+3*w=4*u+1", Some(Kind::Equation)),
    ("m*u*cos(theta)=m*v+2*m*w", "m*u*cos(theta)=m*v+2*m*w+m", Some(Kind::Equation)),
    ("tan(beta)=2*tan(alpha)/(1-e)", "tan(beta)=2*tan(alpha)/(1-e)+1", Some(Kind::Shown)),
];

/// Letters beside those in the model: more can be meant where there are more.
const LETTERS: [(&str, Range); 5] = [
    ("u", Range::Positive),
    ("m", Range::Positive),
    ("e", Range::Unit),
    ("v_A", Range::Positive),
    ("theta", Range::Acute),
];

/// A model, and what is compared with it.
pub struct Pair {
    right: Model,
    other: Model,
    /// The right one by a looser rule.
    rounded: Model,
}

static MODELS: LazyLock<Vec<Pair>> =
    LazyLock::new(|| PAIRS.iter().map(|(right, other, kind)| pair(right, other, *kind)).collect());

/// A model and another one.
pub fn pair(right: &str, other: &str, kind: Option<Kind>) -> Pair {
    let letters: Vec<Letter> = LETTERS.iter().map(|(name, range)| Letter::new(name, *range).expect("short")).collect();
    let read = |text: &str, accept| {
        let options = ModelOptions { kind, accept: Some(accept), letters: letters.clone(), ..ModelOptions::default() };
        Model::read(text, &options).unwrap_or_else(|fault| panic!("{text}: {fault:?}"))
    };
    Pair {
        right: read(right, Accept::Exact),
        other: read(other, Accept::Exact),
        rounded: read(right, Accept::RoundsTo(Places::SignificantFigures(3))),
    }
}

/// Reads and judges a text against the models of that number, and asserts the laws.
pub fn hold(number: u8, text: &str) {
    hold_for(&MODELS[usize::from(number) % MODELS.len()], text);
}

/// Reads and judges a text against a model, and asserts the laws.
pub fn hold_for(pair: &Pair, text: &str) {
    let vocabulary = &pair.right.vocabulary;
    steps_taken();
    let readings = read_answer(text, vocabulary);
    match &readings {
        Ok(found) => {
            assert!(!found.is_empty() && found.len() <= MOST_READINGS, "{} readings", found.len());
            for reading in found {
                assert!(!reading.statements.is_empty(), "a reading that states nothing");
                assert!(reading.statements.iter().all(|statement| !statement.said.is_empty()), "a label alone");
            }
        }
        Err(Unreadable::Sign(place, reason)) => {
            assert!(text.is_char_boundary(*place) && !reason.is_empty(), "a fault at {place}");
        }
        Err(Unreadable::TooLong) => assert!(text.len() > LONGEST),
        Err(Unreadable::Blank) => {}
    }
    let judged = judge(&pair.right, &readings);
    let steps = steps_taken();
    assert!(steps <= MOST_STEPS, "{steps} steps of arithmetic");
    assert_eq!(judged, judge(&pair.right, &readings), "the same answer earns the same");
    let printed_once = |judged: &Judgement| judged.reading.as_ref().map(|printed| printed.len());
    assert!(printed_once(&judged).is_none_or(|length| length < 40 * LONGEST), "a reading too long to be shown");
    if judged.verdict == Verdict::Correct {
        accepted(pair, text, &readings, &judged);
    }
}

fn accepted(pair: &Pair, text: &str, readings: &Result<Vec<Reading>, Unreadable>, judged: &Judgement) {
    // What is exactly right is not also exactly something else: not even by another of its readings.
    let other = judge(&pair.other, readings);
    assert_ne!(
        other.verdict,
        Verdict::Correct,
        "right for two models, as {:?} and {:?}",
        judged.reading,
        other.reading
    );
    // A looser rule accepts what a strict one does.
    let rounded = judge(&pair.rounded, readings);
    assert_eq!(rounded.verdict, Verdict::Correct, "exact, and not to three figures: {:?}", rounded.note);
    // Blanks around an answer say nothing.
    let spaced = judge(&pair.right, &read_answer(&format!(" {text}\n"), &pair.right.vocabulary));
    assert!(text.len() + 2 > LONGEST || spaced.verdict == Verdict::Correct, "blanks turn it into {spaced:?}");
    // What the report prints is what was read.
    let Ok(found) = readings else { return };
    let used = found.iter().find(|reading| Some(&reading.printed) == judged.reading.as_ref());
    let Some(used) = used.filter(|reading| reading.statements.iter().all(is_formula)) else { return };
    let read_again = read_answer(&used.printed, &pair.right.vocabulary);
    // Brackets that are printed for clearness may take what is nested just not too deeply past the limit.
    if matches!(&read_again, Err(Unreadable::Sign(_, reason)) if reason.contains("nested too deeply")) {
        return;
    }
    let again = judge(&pair.right, &read_again);
    assert_eq!(again.verdict, Verdict::Correct, "printed as `{}`, which is {again:?}", used.printed);
}

/// A formula alone, without label, unit and words: what can be read again as it was printed.
fn is_formula(statement: &Statement) -> bool {
    let plain = matches!(statement.said.as_slice(), [said]
        if said.unit.is_none() && said.reference.is_none() && said.remarks.is_empty()
            && matches!(said.form, Form::Value(_) | Form::Vector(..) | Form::Ratio(..) | Form::Equation(_)));
    plain && statement.label.is_none()
}
