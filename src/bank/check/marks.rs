//! Marks checked: codes, what they are awarded for, and the marks on which they depend.

use super::super::document::{Faults, listed};
use super::super::file::MarkFile;
use super::super::literal::Words;
use super::super::{Code, EarnedFor, Mark};
use super::names::NamesUsed;
use super::quantities;
use super::styles::line;
use crate::diagnostic::near;
use crate::mechanics::{LATER, Law, Quantity};

/// The marks of a part.
pub fn marks(written: &[MarkFile], unknowns: &[String], used: &mut NamesUsed, faults: &mut Faults) -> Vec<Mark> {
    let mut found: Vec<Mark> = Vec::new();
    for mark in written {
        let code = mark.code.as_ref().and_then(|code| read_code(code, faults));
        let earned_for = mark.earned_for.as_ref().and_then(|words| read_earned_for(words, unknowns, faults));
        let text = mark.text.as_ref().and_then(|words| line(words, None, used, faults));
        let note = mark.note.as_ref().and_then(|words| line(words, None, used, faults));
        // A mark at fault keeps its place, so that the marks after it are no faults too.
        let (at_fault, code) = (code.is_none() || earned_for.is_none(), code.unwrap_or(Code::B1));
        let earned_for = earned_for.unwrap_or(EarnedFor::Unknown(String::new()));
        let id = next_id(code, &found);
        let depends = match &mark.depends {
            Some(names) => {
                faults.twice("the mark", &[], names);
                on_accuracy(code, names, &found, faults);
                names.iter().filter_map(|name| earlier(name, names, &found, faults)).collect()
            }
            None if at_fault => Vec::new(),
            None => usual(code, &earned_for, mark, &found, faults),
        };
        found.push(Mark { id, code, earned_for, text, note, depends });
    }
    found
}

fn read_code(words: &Words, faults: &mut Faults) -> Option<Code> {
    let text = words.get_ref().as_str();
    let found = Code::ALL.into_iter().find(|code| code.name() == text);
    if found.is_none() {
        let names = Code::ALL.map(Code::name);
        let several = text.len() == 2 && text.ends_with(|c: char| matches!(c, '2'..='9'));
        let one = text.get(..1).filter(|_| several).map(|letter| format!("{letter}1"));
        let help = match one.filter(|one| names.contains(&one.as_str())) {
            Some(one) => format!("write one row for each mark: `{one}` more than once in place of `{text}`"),
            None => {
                let near = names.into_iter().find(|name| name.eq_ignore_ascii_case(text)).or_else(|| near(text, names));
                near.map_or_else(|| "write one of those".to_owned(), |near| format!("did you mean `{near}`?"))
            }
        };
        faults.report(
            words.span(),
            format!("unknown mark code `{text}`"),
            format!("expected {}", listed(&names)),
            help,
        );
    }
    found
}

fn read_earned_for(words: &Words, unknowns: &[String], faults: &mut Faults) -> Option<EarnedFor> {
    let text = words.get_ref().trim();
    if let Some(found) = EarnedFor::read(text, unknowns) {
        return Some(found);
    }
    let laws = EarnedFor::names();
    let numbered = text.split_once('.').filter(|(number, law)| LATER.contains(number) && laws.contains(law));
    if let Some((number, law)) = numbered {
        let help =
            format!("write `{law}`: the {number} mark of its code that is for it in a part is for the {number} impact");
        faults.report(words.span(), format!("unknown step `{text}`"), "a law has no number", help);
        return None;
    }
    if text.contains('.') {
        quantities::unknown_at(words.span(), "step", text, &[], faults);
        return None;
    }
    let (label, help) = match step_meant(text, &laws) {
        Some(meant) => ("no law has this name".to_owned(), format!("did you mean `{meant}`?")),
        None => (
            format!("expected a quantity, or a law: {}", listed(&laws)),
            "write one of those, or take it out".to_owned(),
        ),
    };
    faults.report(words.span(), format!("unknown step `{text}`"), label, help);
    None
}

/// The step that words are most probably about.
fn step_meant(words: &str, laws: &[&str]) -> Option<String> {
    let sphere = words.split(|sign: char| !sign.is_alphabetic()).find(|word| ["A", "B", "C"].contains(word));
    let condition = is_about_condition(words).then(|| EarnedFor::Condition.to_string());
    let quantity = || Quantity::meant(words).map(|quantity| quantity.to_string());
    // No law is called after a velocity: it is the answer.
    let velocity = || sphere.filter(|_| words.to_lowercase().contains("velocity")).and_then(|_| quantity());
    let law = || {
        let law = near(words, laws.iter().copied()).or_else(|| Law::meant(words).map(Law::name))?;
        let of_sphere = sphere.map(|sphere| format!("{law} {sphere}"));
        Some(of_sphere.filter(|law| EarnedFor::read(law, &[]).is_some()).unwrap_or_else(|| law.to_owned()))
    };
    condition.or_else(velocity).or_else(law).or_else(quantity)
}

/// Do words speak of what a condition asks: of an inequality, or of what is greatest?
fn is_about_condition(words: &str) -> bool {
    const BEGIN: [&str; 9] =
        ["condition", "differentiat", "inequalit", "maxim", "minim", "greatest", "least", "stationary", "turning"];
    let words = words.to_lowercase();
    words.split(' ').any(|word| BEGIN.iter().any(|begin| word.starts_with(begin)))
}

/// `M1a`, `M1b`, …, `M1z`, `M1aa`, …
fn next_id(code: Code, before: &[Mark]) -> String {
    let mut number = before.iter().filter(|mark| mark.code.stem() == code.stem()).count();
    let mut letters = Vec::new();
    loop {
        letters.insert(0, char::from(b'a' + (number % 26) as u8));
        if number < 26 {
            break;
        }
        number = number / 26 - 1;
    }
    format!("{}{}", code.stem(), letters.into_iter().collect::<String>())
}

/// A mark that is named as a condition must stand before.
fn earlier(name: &Words, all: &[Words], before: &[Mark], faults: &mut Faults) -> Option<String> {
    let text = name.get_ref();
    if before.iter().any(|mark| mark.id == *text) {
        return Some(text.clone());
    }
    let ids: Vec<&str> = before.iter().map(|mark| mark.id.as_str()).collect();
    let label = match ids.as_slice() {
        [] => "no mark stands before this one".to_owned(),
        _ => format!("the marks before this one are {}", listed(&ids)),
    };
    let message = format!("no earlier mark `{text}` in this part");
    if ids.is_empty() {
        faults.report(name.span(), message, label, "leave `depends` out");
        return None;
    }
    let left = ids.into_iter().filter(|id| !all.iter().any(|named| named.get_ref() == id));
    faults.unknown(name.span(), message, label, text, left);
    None
}

/// A method is not taken away for a wrong number: a method mark that depends on a mark for accuracy.
fn on_accuracy(code: Code, names: &[Words], before: &[Mark], faults: &mut Faults) {
    let is_accuracy = |name: &&Words| before.iter().any(|mark| mark.id == *name.get_ref() && mark.code.is_accuracy());
    if let Some(name) = names.iter().find(is_accuracy).filter(|_| code.is_method()) {
        let message = format!("`{}` depends on `{}`, a mark for accuracy", code.name(), name.get_ref());
        let label = "a method is not lost by a wrong number";
        let help = "name method marks in `depends`, as in `depends = [\"M1a\"]`, or leave it out";
        faults.report(name.span(), message, label, help);
    }
}

/// What a mark depends on if the file does not say: `A1` on the method mark of the same step or the nearest
/// before it, `dM1` on those of momentum and restitution.
fn usual(code: Code, earned_for: &EarnedFor, mark: &MarkFile, before: &[Mark], faults: &mut Faults) -> Vec<String> {
    let methods: Vec<&Mark> = before.iter().filter(|mark| mark.code.is_method()).collect();
    let span = mark.code.as_ref().map_or(mark.span.clone(), |words| words.span());
    if code.is_accuracy() {
        let same = methods.iter().rev().find(|method| method.earned_for == *earned_for);
        return match same.or(methods.last()) {
            Some(method) => vec![method.id.clone()],
            None => {
                faults.report(
                    span,
                    format!("`{}` without a method mark before it", code.name()),
                    "an accuracy mark is not given without its method",
                    "put an `M1` before it, or make it a `B1`",
                );
                Vec::new()
            }
        };
    }
    if code != Code::DependentM1 {
        return Vec::new();
    }
    let central = |method: &&&Mark| {
        matches!(&method.earned_for, EarnedFor::Law(law, _) if law.gives_equation()) && method.code == Code::M1
    };
    let mut needed: Vec<String> = methods.iter().filter(central).map(|method| method.id.clone()).collect();
    if needed.is_empty() {
        needed = methods.iter().map(|method| method.id.clone()).collect();
    }
    if needed.is_empty() {
        faults.report(
            span,
            "`dM1` without a method mark before it",
            "there is nothing on which it could depend",
            "make it an `M1`",
        );
    }
    needed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_for_a_step_are_told_its_name() {
        let laws = EarnedFor::names();
        for (words, step) in [
            ("momentun", "momentum"),
            ("velocity A", "A.after.x"),
            ("the velocity of B", "B.after.x"),
            ("speed of A", "speed A"),
            ("Pythagoras for B", "speed B"),
            ("angle of A", "direction A"),
            ("solving", "solve"),
            ("loss in energy", "energy"),
            ("inequality for v", "condition"),
        ] {
            assert_eq!(step_meant(words, &laws).as_deref(), Some(step), "{words}");
        }
    }
}
